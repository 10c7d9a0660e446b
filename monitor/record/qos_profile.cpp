// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/qos_profile.h"

#include <algorithm>
#include <cstdint>

namespace galilean::monitor {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
/// The largest time of ROS 2 stands for no limit.
constexpr std::int64_t kUnlimited_ns = 9'223'372'036 * kSecond_ns + 854'775'807;

std::string duration_text(std::int64_t ns) {
  return "\n    sec: " + std::to_string(ns / kSecond_ns) +
         "\n    nsec: " + std::to_string(ns % kSecond_ns) + "\n";
}

}  // namespace

std::string offered_qos_profiles(const wire::EndpointQos& offered) {
  const bool is_kept = offered.durability >= wire::EndpointQos::Durability::kTransientLocal;
  const std::string unlimited = duration_text(kUnlimited_ns);
  return std::string("- history: ") + (offered.depth == 0 ? "keep_all" : "keep_last") +
         "\n  depth: " + std::to_string(offered.depth) +
         "\n  reliability: " + (offered.reliable ? "reliable" : "best_effort") +
         "\n  durability: " + (is_kept ? "transient_local" : "volatile") +
         "\n  deadline:" + duration_text(std::min(offered.deadline_ns, kUnlimited_ns)) +
         "  lifespan:" + unlimited +
         "  liveliness: automatic\n  liveliness_lease_duration:" + unlimited +
         "  avoid_ros_namespace_conventions: false\n";
}

}  // namespace galilean::monitor
