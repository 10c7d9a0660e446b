// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/accepted_senders.h"

#include <algorithm>

namespace galilean::robot {

Result<void> AcceptedSenders::accept(const std::optional<std::string>& sender) const {
  const auto accepts = [this](const std::string& name) {
    return std::ranges::find(names_, name) != names_.end();
  };
  if (accepts(kAny) || (sender && accepts(*sender))) return {};
  std::string list;
  for (const std::string& name : names_) list += (list.empty() ? "" : ", ") + name;
  const std::string from =
      sender ? "from '" + *sender + "'" : "from a participant that has already left";
  return Error{"it came " + from + ", but this robot accepts programs only from " + list +
               ": push through the monitor, or start the robot with --accept-swaps-from " +
               (sender ? *sender : kAny)};
}

}  // namespace galilean::robot
