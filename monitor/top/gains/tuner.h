// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bhdl/source/source_file.h"
#include "core/catalog/catalog.h"
#include "core/wire/messages.h"
#include "monitor/top/gains/tunables.h"

namespace galilean::monitor::top {

/// The numbers of a running program, and where an operator moved them to. What was moved stays so
/// until the robots run it.
class Tuner {
 public:
  /// Takes over what runs. It is read anew only if it is another program or another catalog.
  void show(const msg::Program& program, const msg::Catalog& catalog);

  /// Returns the hash of the program that is shown; empty: none is.
  [[nodiscard]] const std::string& program_hash() const noexcept { return program_hash_; }
  [[nodiscard]] const std::vector<Tunable>& tunables() const noexcept { return tunables_; }
  /// Returns the number where it was moved to, else where it runs, as BHDL writes it.
  [[nodiscard]] std::string text_of(const Tunable& tunable) const;
  [[nodiscard]] double value_of(const Tunable& tunable) const;
  [[nodiscard]] bool is_moved(const Tunable& tunable) const { return moved_.contains(tunable.key); }
  /// Moves a number by so many of its steps, within its range.
  void move(const Tunable& tunable, int steps);
  void put_back() { moved_.clear(); }

  [[nodiscard]] bool has_moves() const noexcept { return !moved_.empty(); }
  /// Returns the running program with what was moved.
  [[nodiscard]] std::vector<bhdl::SourceFile> moved_files() const;
  /// Returns "search · gain of noise 1 → 1.2", for the history of pushes.
  [[nodiscard]] std::string reason() const;
  /// Notes that what was moved is sent, so that `undo` can take it back.
  void note_sent();
  [[nodiscard]] bool can_undo() const noexcept { return !undo_.empty(); }
  /// Moves what was sent last back to where it was. Requires: can_undo().
  void undo();

 private:
  std::string program_hash_, catalog_hash_;
  std::vector<bhdl::SourceFile> files_;
  Catalog catalog_;
  std::vector<Tunable> tunables_;
  std::map<std::string, std::string> moved_;  ///< the numbers as texts, by the tunables' keys
  std::map<std::string, std::string> undo_;   ///< the same, of before what was sent last
};

}  // namespace galilean::monitor::top
