// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// The simulations that are heard in the domain.
class Simulations {
 public:
  /// A simulation that was not heard for longer than this is gone.
  static constexpr Duration kSilentAfter = std::chrono::seconds(2);

  void note(msg::SimulationState state, Time now);
  /// Returns the newest state of the simulation of this name, or of the only one if `name` is
  /// empty. Errors: it is not heard, or several are and `name` is empty; the error lists those that
  /// are.
  [[nodiscard]] Result<const msg::SimulationState*> find(const std::string& name, Time now) const;
  [[nodiscard]] std::size_t count() const noexcept { return heard_.size(); }

 private:
  struct Heard {
    msg::SimulationState state;
    Time at;
  };
  std::map<std::string, Heard> heard_;
};

}  // namespace galilean::monitor
