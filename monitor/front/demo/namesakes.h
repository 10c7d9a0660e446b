// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/result.h"
#include "core/termination.h"
#include "core/wire/neighbours.h"
#include "core/wire/participant.h"

namespace galilean::front {

/// Looks for robots in the DDS domain from its construction on, until `check` has told of them. The
/// demo's own robots must not be there yet.
class Namesakes {
 public:
  /// Errors: the domain cannot be joined.
  [[nodiscard]] static Result<std::unique_ptr<Namesakes>> look(int domain);

  /// Waits for DDS' discovery. Errors: one of the robots lives in the domain already, or a replay
  /// plays it; or termination was asked for.
  [[nodiscard]] Result<void> check(const std::vector<std::string>& robots,
                                   Termination& termination);

 private:
  explicit Namesakes(std::unique_ptr<wire::Participant> participant);

  std::unique_ptr<wire::Participant> participant_;
  wire::Endpoints endpoints_;
  SteadyClock clock_;
  Time began_;
};

/// Returns why a demo must not start robots of these names beside these neighbours; an empty text
/// if it may.
[[nodiscard]] std::string why_not_beside(const std::vector<std::string>& robots,
                                         const wire::Neighbours& there, unsigned domain);

}  // namespace galilean::front
