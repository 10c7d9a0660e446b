// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/wire/participant.h"

namespace galilean::robot {

/// The processes whose programs a robot accepts, by the names with which they joined the DDS
/// domain.
class AcceptedSenders {
 public:
  static constexpr const char* kAny = "any";

  /// If `kAny` is among the names, programs are accepted from every process.
  explicit AcceptedSenders(std::vector<std::string> names = {wire::kMonitorName})
      : names_(std::move(names)) {}

  /// Errors: the robot accepts nothing from `sender`; the error says why and what to do. The name
  /// of a sender that has left is not known.
  [[nodiscard]] Result<void> accept(const std::optional<std::string>& sender) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace galilean::robot
