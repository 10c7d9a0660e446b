// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean::wire {

/// Returns one plain sentence for what Cyclone says of a refusal, with what to do. `line` is
/// Cyclone's own, which follows in brackets.
[[nodiscard]] std::string refusal_of(const std::string& line);

/// Returns what remains of a line of Cyclone's without those before it that Cyclone did not end:
/// "Non secure remote writer 1:2:3:403 is not allowed." That is told by
/// tell_of_unsecured_programs() with the program's name.
[[nodiscard]] std::string ended_part(const std::string& line);

/// Tells a sentence of DDS Security on standard error, if it was not told before.
void tell_once(const std::string& sentence);

/// Has Cyclone give out what it has logged on this thread and has not ended, which would otherwise
/// be the beginning of what it logs next.
void end_unended_line();

/// Takes what Cyclone logs from now on. Each line is told once on standard error, whoever is
/// refused in it. After some hundred different ones the rest is not told.
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
