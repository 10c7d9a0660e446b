// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/domain_option.h"

namespace galilean {

CommandLineOption add_domain_option(CommandLine& line, int& domain, const std::string& note) {
  constexpr int kHighestDomain = 232;  // DDSI-RTPS 2.2, 9.6.1.1: above it, ports exceed 65535
  const std::string help = "DDS domain; without it ROS_DOMAIN_ID, else 0";
  return line.option("--domain", domain, note.empty() ? help : help + " (" + note + ")")
      .between(0, kHighestDomain);
}

}  // namespace galilean
