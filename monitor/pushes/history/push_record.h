// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "monitor/pushes/history/replies.h"
#include "monitor/pushes/history/step.h"

namespace galilean::monitor {

/// A push as it is published and recorded.
struct PushRecord {
  std::string id;
  std::int64_t pushed_ns = 0;  ///< since the Unix epoch
  std::string author;
  std::string program;               ///< the main file's name
  std::string hash;                  ///< empty until the program was checked
  std::vector<std::string> targets;  ///< empty: the team
  Progress progress = {};
  std::vector<RobotReply> replies = {};
  std::string not_kept = {};  ///< why the history does not hold all of this yet; empty: it does
};

}  // namespace galilean::monitor
