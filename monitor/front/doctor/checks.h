// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::front {

/// One thing that Galilean needs of a machine, and whether it is there.
struct Check {
  std::string what;
  bool ok = false;
  std::string told;     ///< what was found
  std::string to_do{};  ///< where it is not there
};

/// Each looks at one thing, leaves nothing behind, and takes two seconds at most.
[[nodiscard]] Check check_programs();
[[nodiscard]] Check check_page();
[[nodiscard]] Check check_pseudo_terminals();
[[nodiscard]] Check check_shared_memory();
[[nodiscard]] Check check_port(int port);
[[nodiscard]] Check check_loopback();
[[nodiscard]] Check check_multicast();
[[nodiscard]] Check check_dds(int domain);
[[nodiscard]] Check check_devices();

}  // namespace galilean::front
