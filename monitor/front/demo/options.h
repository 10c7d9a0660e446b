// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace galilean::front {

/// What `galilean demo` is asked for.
struct DemoOptions {
  int robots = 3;
  int port = 8080;
  std::string scenario = "office";
  std::string bhdl = "office_cleanup";  ///< a file, or the name of a program that ships
  bool watch = false;                   ///< the robots swap when it is saved
  std::uint64_t seed = 1;
  std::optional<double> headless_for_s;
  std::string record;                        ///< a file, or empty
  std::vector<std::string> allowed_origins;  ///< other pages that may use the monitor
  int domain = -1;                           ///< of DDS; -1: as ROS_DOMAIN_ID says, else 0
};

}  // namespace galilean::front
