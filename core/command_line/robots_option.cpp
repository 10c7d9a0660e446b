// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/robots_option.h"

#include <charconv>

namespace galilean {
namespace {

/// Text that is no number passes: the command line refuses it.
Result<void> check_number(const std::string& text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, wrong] = std::from_chars(text.data(), end, number);
  const bool is_number = rest == end && wrong != std::errc::invalid_argument;
  if (!is_number || (wrong == std::errc() && number >= 1 && number <= kMostRobots)) return {};
  return Error{"there can be from 1 to " + std::to_string(kMostRobots) + " robots, not " + text +
               ", because a DDS domain has room for no more on one machine"};
}

}  // namespace

CommandLineOption add_robots_option(CommandLine& line, std::uint64_t& robots) {
  const std::string help = "Number of robots, from 1 to " + std::to_string(kMostRobots);
  return line.option("--robots", robots, help).check(check_number).show_default();
}

}  // namespace galilean
