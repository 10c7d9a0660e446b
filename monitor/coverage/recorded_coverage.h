// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "monitor/coverage/program_coverage.h"
#include "monitor/mcap/mcap_reader.h"

namespace galilean::monitor {

/// What robots exercised of their programs in one recording, or in several that are counted
/// together.
class RecordedCoverage {
 public:
  /// More programs, or more states and conditions, come from no real team.
  static constexpr std::size_t kMostPrograms = 1000, kMostKeptBytes = std::size_t{16} << 20;

  /// Begins with a recording. Its messages come next, in any order.
  void begin(const mcap::Summary& summary);
  /// Takes a message of that recording. Only programs, states and changes of state count.
  void take(const mcap::Message& message);

  /// Returns what was done of each program, by the program's hash.
  [[nodiscard]] const std::map<std::string, ProgramCoverage>& programs() const noexcept {
    return programs_;
  }
  /// Returns what could not be counted, in sentences without a full stop; none: all was.
  [[nodiscard]] std::vector<std::string> uncounted() const;

 private:
  enum class Kind { kProgram, kState, kTransition };

  template <class Message, class Take>
  void decode(mcap::ByteView cdr, const Take& take_it);
  template <class Note>
  void note(const std::string& hash, const Note& note_it);
  ProgramCoverage* of(const std::string& hash);

  std::unordered_map<std::uint16_t, Kind> kinds_;  ///< of the recording's channels
  std::map<std::string, ProgramCoverage> programs_;
  std::size_t kept_bytes_ = 0;
  std::set<std::string> uncounted_;
  std::uint64_t undecoded_ = 0;
};

}  // namespace galilean::monitor
