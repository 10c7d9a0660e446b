// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/qos_profile.h"

namespace galilean::monitor {
namespace {

struct Profile {
  int depth;
  const char* reliability;
  const char* durability;
};

Profile profile_of(wire::Delivery delivery) {
  switch (delivery) {
    case wire::Delivery::kState:
      return {1, "reliable", "transient_local"};
    case wire::Delivery::kEvent:
      return {64, "reliable", "transient_local"};
    case wire::Delivery::kCommand:
      return {64, "reliable", "volatile"};
    case wire::Delivery::kFlow:
      return {10, "reliable", "volatile"};
    case wire::Delivery::kStream:
      break;
  }
  return {1, "best_effort", "volatile"};
}

}  // namespace

std::string offered_qos_profiles(wire::Delivery delivery) {
  const Profile profile = profile_of(delivery);
  // The largest time of ROS 2 stands for no limit.
  const std::string unlimited = "\n    sec: 9223372036\n    nsec: 854775807\n";
  return "- history: keep_last\n  depth: " + std::to_string(profile.depth) +
         "\n  reliability: " + profile.reliability + "\n  durability: " + profile.durability +
         "\n  deadline:" + unlimited + "  lifespan:" + unlimited +
         "  liveliness: automatic\n  liveliness_lease_duration:" + unlimited +
         "  avoid_ros_namespace_conventions: false\n";
}

}  // namespace galilean::monitor
