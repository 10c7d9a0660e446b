// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/result.h"

namespace galilean::wire {

/// The name that the monitor joins the domain with; robots recognise the monitor by it.
inline constexpr const char* kMonitorName = "monitor";

/// A process's membership in a DDS domain. Must go before `main` returns (Cyclone's threads outlive
/// exit handlers otherwise). Several on one machine find one another with or without multicast;
/// on other machines by multicast, or by the addresses in GALILEAN_PEERS (separated by commas).
/// CYCLONEDDS_URI, where set, has the last word.
class Participant {
 public:
  /// `name` is what others are shown. Domain: ROS_DOMAIN_ID where `domain` is negative, else 0.
  [[nodiscard]] static Result<std::unique_ptr<Participant>> join(const std::string& name,
                                                                 int domain = -1);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  [[nodiscard]] std::int32_t handle() const noexcept;
  /// The entity of one topic, made at first use. Throws std::runtime_error if Cyclone refuses it or
  /// if `ros_type` is not one of the messages.
  [[nodiscard]] std::int32_t topic(const std::string& name, const std::string& ros_type);

 private:
  struct State;
  explicit Participant(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
