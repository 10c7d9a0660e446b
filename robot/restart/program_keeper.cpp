// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/program_keeper.h"

#include <utility>

namespace galilean::robot {

ProgramKeeper::ProgramKeeper(std::filesystem::path file, std::string robot)
    : file_(std::move(file)) {
  newest_.robot = std::move(robot);
}

std::string ProgramKeeper::begin(const bhdl::Program& program, bool pushed,
                                 const KeptOrders& orders) {
  const std::lock_guard lock(mutex_);
  newest_.running = true;
  newest_.orders = orders;
  note(program, pushed);
  return write(newest_);
}

Worker ProgramKeeper::writer(const Tell& tell) {
  return {[this, tell](const std::stop_token& stop) { write_newest(stop, tell); },
          [tell](const std::string& failure) {
            if (!failure.empty()) tell("What runs cannot be kept (" + failure + ").");
          }};
}

void ProgramKeeper::keep(const bhdl::Program& program, bool pushed) {
  const std::lock_guard lock(mutex_);
  note(program, pushed);
  changed_ = true;
  wake_.notify_one();
}

void ProgramKeeper::keep_orders(const KeptOrders& orders) {
  const std::lock_guard lock(mutex_);
  newest_.orders = orders;
  changed_ = true;
  wake_.notify_one();
}

/// Requires: mutex_ is locked.
void ProgramKeeper::note(const bhdl::Program& program, bool pushed) {
  newest_.pushed = pushed;
  newest_.hash = program.hash;
  newest_.files = program.files;
}

void ProgramKeeper::write_newest(const std::stop_token& stop, const Tell& tell) {
  KeptProgram kept;
  {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, stop, [this] { return std::exchange(changed_, false); })) return;
    kept = newest_;
  }
  tell(write(kept));
}

std::string ProgramKeeper::end() {
  const std::lock_guard lock(mutex_);
  newest_.running = false;
  return write(newest_);
}

std::string ProgramKeeper::write(const KeptProgram& kept) const {
  const auto written = write_kept_program(file_, kept);
  if (written) return "";
  return written.error().message +
         "; so the next start does not know what ran, nor how it ended: check the disk.";
}

}  // namespace galilean::robot
