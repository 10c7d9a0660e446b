// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::monitor {

/// Returns this machine's name, if it is one of letters, digits, '.' and '-' as certificates name
/// it; else an empty text.
[[nodiscard]] std::string own_host_name();

/// Returns the addresses of this machine's interfaces, but for IPv6 addresses of one link, which
/// are nobody's name for it.
[[nodiscard]] std::vector<std::string> own_addresses();

}  // namespace galilean::monitor
