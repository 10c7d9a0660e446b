// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean::wire {

/// Returns one plain sentence for what Cyclone says of a refusal, with what to do. `line` is
/// Cyclone's own, which follows in brackets.
[[nodiscard]] std::string refusal_of(const std::string& line);

/// Returns what is alike in all that Cyclone says of one stranger, so that each is told once.
[[nodiscard]] std::string stranger_of(const std::string& line);

/// Takes what Cyclone logs from now on. Each stranger whom it refuses is told once on standard
/// error, and so is each other line. After some hundred different ones the rest is not told.
void listen_to_cyclone();

/// Keeps what Cyclone says while this process joins, instead of telling it.
class JoiningLog {
 public:
  JoiningLog();
  ~JoiningLog();
  JoiningLog(const JoiningLog&) = delete;
  JoiningLog& operator=(const JoiningLog&) = delete;
  /// Returns the first failure that Cyclone told, which names the cause; empty if it told none.
  [[nodiscard]] std::string first_line() const;
};

}  // namespace galilean::wire
