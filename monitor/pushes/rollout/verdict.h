// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::monitor {

/// The state of a step, judged by what the robots did and by the time.
struct Verdict {
  enum class Kind { kPending, kUnderWay, kDone, kFailed };
  Kind kind = Kind::kPending;
  std::string detail = {};  ///< one sentence; empty where there is nothing to say
};

}  // namespace galilean::monitor
