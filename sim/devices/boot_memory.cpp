// SPDX-License-Identifier: BSD-3-Clause
#include "sim/devices/boot_memory.h"

#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "core/private_file.h"

namespace galilean::sim {
namespace {

/// Returns the number that is all of the file's text, or nothing.
std::optional<std::uint16_t> number_in(std::ifstream& file) {
  std::string text;
  // A number has five digits at most. Whatever is longer is none.
  for (char letter = 0; text.size() < 8 && file.get(letter);) text += letter;
  if (!text.empty() && text.back() == '\n') text.pop_back();
  std::uint16_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return number;
}

}  // namespace

BootMemory::BootMemory(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream kept(file_);
  if (!kept) return;
  const auto number = number_in(kept);
  if (number)
    count_ = *number;
  else
    problem_ = file_.string() +
               " is no count of a board's starts, which begins at 1 again: a robot that runs may "
               "not notice that its board is a new one.";
}

std::uint16_t BootMemory::count_start() {
  count_ = count_ == std::numeric_limits<std::uint16_t>::max()
               ? std::uint16_t{1}
               : static_cast<std::uint16_t>(count_ + 1);
  if (!file_.empty()) keep();
  return count_;
}

void BootMemory::keep() {
  // The file is replaced as a whole: whoever is ended meanwhile leaves the old count or the new
  // one.
  if (make_private_folder(file_.parent_path()) &&
      replace_private_file(file_, std::to_string(count_) + "\n"))
    return;
  problem_ = file_.string() +
             " cannot be written, so that the next simulator does not know how often this board "
             "was started: make its folder one that can be written, or set XDG_STATE_HOME.";
}

}  // namespace galilean::sim
