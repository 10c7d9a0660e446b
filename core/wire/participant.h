// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/result.h"

namespace galilean::wire {

class Refusals;

/// The name with which the monitor joins the domain. Robots recognise the monitor by it.
inline constexpr const char* kMonitorName = "monitor";
/// The name with which a replay joins. Whatever it writes comes from a recording.
inline constexpr const char* kReplayName = "replay";

/// A process's membership in a DDS domain. It must be destroyed before `main` returns, because
/// Cyclone's threads outlive exit handlers otherwise. Processes on one machine find one another
/// with or without multicast. On other machines they are found by multicast, or by the addresses in
/// GALILEAN_PEERS (separated by commas). CYCLONEDDS_URI overrides these settings. GALILEAN_SECURE
/// names the folder with the keys of DDS Security; without it the process joins unsecured.
class Participant {
 public:
  /// `name` is what other processes see. A negative `domain` means ROS_DOMAIN_ID, or 0 if that is
  /// not set. Errors: there is no such domain, DDS cannot start, the domain cannot be joined, or
  /// DDS Security refuses the keys or cannot secure that domain.
  [[nodiscard]] static Result<std::unique_ptr<Participant>> join(const std::string& name,
                                                                 int domain = -1);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  [[nodiscard]] std::int32_t handle() const noexcept;
  /// Returns the number of the domain that was joined, however it was chosen.
  [[nodiscard]] std::uint32_t domain() const noexcept;
  /// Returns the entity of one topic, which is made at first use, or 0 if DDS Security permits
  /// neither to read nor to write it. Any thread may call it. Errors:
  /// throws std::runtime_error if Cyclone refuses the topic, or if `ros_type` is not one of the
  /// messages.
  [[nodiscard]] std::int32_t topic(const std::string& name, const std::string& ros_type);
  /// Returns the account of the messages that this process received and did not take.
  [[nodiscard]] Refusals& refusals() const noexcept;

 private:
  struct State;
  explicit Participant(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
