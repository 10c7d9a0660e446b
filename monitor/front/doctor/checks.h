// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::front {

/// The result of checking one thing that Galilean needs of a machine.
struct Check {
  std::string what;
  bool ok = false;
  std::string told;     ///< the finding
  std::string to_do{};  ///< the remedy if `ok` is false
};

/// Each function checks one thing, leaves nothing behind and takes little more than 2 s at most,
/// but for check_messages where something listens at the port and does not answer.
[[nodiscard]] Check check_programs();
[[nodiscard]] Check check_page();
[[nodiscard]] Check check_pseudo_terminals();
[[nodiscard]] Check check_shared_memory();
[[nodiscard]] Check check_port(int port);
[[nodiscard]] Check check_loopback();
[[nodiscard]] Check check_multicast();
[[nodiscard]] Check check_dds(int domain);
[[nodiscard]] Check check_devices();
/// Asks the monitor of this machine, if one runs, which messages it did not take.
[[nodiscard]] Check check_messages(int port);

}  // namespace galilean::front
