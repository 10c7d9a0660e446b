// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/domain_option.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/secure_folder.h"
#include "core/visible_text.h"

namespace galilean {
namespace {

/// Names the keys for this process and for those that it starts, wherever their current folder is.
Result<void> choose_keys(const std::string& folder) {
  std::error_code unknown;
  const auto absolute = std::filesystem::absolute(folder, unknown);
  if (unknown || !std::filesystem::is_directory(absolute, unknown))
    return Error{"'" + visible(folder) +
                 "' is no folder; 'galilean team keys add' makes a member's"};
  setenv(kSecureVariable, absolute.c_str(), 1);
  return {};
}

/// `note` ends the help.
std::string noted(const std::string& help, const std::string& note) {
  return note.empty() ? help : help + " (" + note + ")";
}

}  // namespace

CommandLineOption add_domain_option(CommandLine& line, int& domain, const std::string& note) {
  constexpr int kHighestDomain = 232;  // DDSI-RTPS 2.2, 9.6.1.1: above it, ports exceed 65535
  line.option("--secure", choose_keys,
              noted("Folder of this member's keys, for DDS Security; without it GALILEAN_SECURE, "
                    "else none",
                    note))
      .names_folder();
  return line
      .option("--domain", domain, noted("DDS domain; without it ROS_DOMAIN_ID, else 0", note))
      .between(0, kHighestDomain);
}

}  // namespace galilean
