// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/wire/participant.h"

namespace galilean::robot {

/// Whose programs a robot takes: processes by the names that they joined the DDS domain with.
class AcceptedSenders {
 public:
  static constexpr const char* kAny = "any";

  /// `kAny` among them: everybody's.
  explicit AcceptedSenders(std::vector<std::string> names = {wire::kMonitorName})
      : names_(std::move(names)) {}

  /// Why nothing is taken from `sender`, and what to do; empty if it is. Nobody knows the name of a
  /// sender that has left.
  [[nodiscard]] std::string objection(const std::optional<std::string>& sender) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace galilean::robot
