// SPDX-License-Identifier: BSD-3-Clause
#include "sim/devices/boot_memory.h"

#include <unistd.h>

#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

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
  // A file is replaced as a whole: whoever is ended meanwhile leaves the old count or the new one.
  std::error_code failed;
  std::filesystem::create_directories(file_.parent_path(), failed);
  const std::filesystem::path made = file_.string() + "." + std::to_string(getpid());
  std::ofstream out(made, std::ios::trunc);
  out << count_ << "\n";
  out.close();
  const bool written = out.good();
  if (written) std::filesystem::rename(made, file_, failed);
  if (written && !failed) return;
  std::error_code gone_already;
  std::filesystem::remove(made, gone_already);
  problem_ = file_.string() +
             " cannot be written, so that the next simulator does not know how often this board "
             "was started: make its folder one that can be written, or set XDG_STATE_HOME.";
}

}  // namespace galilean::sim
