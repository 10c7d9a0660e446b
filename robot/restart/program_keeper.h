// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

#include "bhdl/program/program.h"
#include "core/worker.h"
#include "robot/restart/kept_program.h"

namespace galilean::robot {

/// Keeps on disk what the robot program runs, for its next start. Whoever destroys it without `end`
/// leaves a file that says that the robot program died.
class ProgramKeeper {
 public:
  /// Gets what is wrong and what that means, or an empty text when it is well again.
  using Tell = std::function<void(const std::string& problem)>;

  ProgramKeeper(std::filesystem::path file, std::string robot);

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  /// Writes at once that the robot program runs, and begins with this program and with what
  /// operators had ordered before. Returns what a Tell gets.
  [[nodiscard]] std::string begin(const bhdl::Program& program, bool pushed,
                                  const KeptOrders& orders = {});
  /// Returns a thread that writes what `keep` is given. Requires: this outlives it.
  [[nodiscard]] Worker writer(const Tell& tell);
  /// Any thread but control. A program has proven itself. The thread writes it; only the newest
  /// counts.
  void keep(const bhdl::Program& program, bool pushed);
  /// Any thread but control. Operators ordered this. The thread writes it; only the newest counts.
  void keep_orders(const KeptOrders& orders);
  /// Writes at once that the robot program ended in order. Returns what a Tell gets. Requires: the
  /// writer has ended.
  [[nodiscard]] std::string end();

 private:
  void note(const bhdl::Program& program, bool pushed);
  void write_newest(const std::stop_token& stop, const Tell& tell);
  [[nodiscard]] std::string write(const KeptProgram& kept) const;

  const std::filesystem::path file_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  KeptProgram newest_;
  bool changed_ = false;
};

}  // namespace galilean::robot
