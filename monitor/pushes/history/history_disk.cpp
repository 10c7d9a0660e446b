// SPDX-License-Identifier: BSD-3-Clause
// How the history looks after its disk.
#include <string>
#include <system_error>

#include "core/plural.h"
#include "monitor/pushes/history/history.h"

namespace galilean::monitor {
namespace {

std::string megabytes(std::uintmax_t bytes) {
  return std::to_string(bytes >> 20) + " MB";
}

/// Returns what waits for the disk and what was lost, as the end of a clause.
std::string debts(const History::Disk& disk) {
  std::string text;
  if (disk.owed > 0)
    text += "; " + plural(disk.owed, "change") + " in memory " +
            agreeing(disk.owed, "waits", "wait") + " for it";
  if (disk.lost > 0)
    text +=
        "; " + plural(disk.lost, "earlier change") + agreeing(disk.lost, " was lost", " were lost");
  return text;
}

}  // namespace

History::Disk History::check_disk() {
  if (!owed_.empty())
    (void)pay();
  else if (!write_problem_.empty())
    try_disk();
  const auto probed = probe_.write();
  std::error_code failed;
  const auto room = std::filesystem::space(folder_, failed);
  Disk disk;
  if (!failed) disk.available_bytes = room.available;
  const auto needed = reserve_.bytes();
  if (!reserve_.is_taken() && disk.available_bytes > 3 * needed) (void)reserve_.take();
  disk.has_reserve = reserve_.is_taken();
  disk.owed = owed_.size();
  disk.lost = owed_.lost();
  const bool is_unknown = failed && write_problem_.empty();
  disk.problem = is_unknown
                     ? "the disk of " + folder_.string() + " cannot be asked: " + failed.message()
                     : problem_of(disk, probed);
  return disk;
}

std::string History::problem_of(const Disk& disk, const Result<void>& probed) const {
  const std::string where = "the disk of " + folder_.string();
  const auto needed = reserve_.bytes();
  if (!write_problem_.empty())
    return "nothing can be kept, so that pushes are refused: " + write_problem_ + debts(disk);
  if (!probed) return where + " fails, so that pushes may be refused: " + probed.error().message;
  if (needed > 0 && disk.available_bytes < needed)
    return where + " is full: " + megabytes(disk.available_bytes) + " are left" +
           (disk.has_reserve ? " and a reserve of " + megabytes(needed)
                             : ", and the reserve is used up");
  if (needed > 0 && !disk.has_reserve)
    return where + " is nearly full: there is no room for the reserve of " + megabytes(needed);
  if (disk.lost > 0) return where + " had failed for long" + debts(disk);
  return {};
}

}  // namespace galilean::monitor
