// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::wire {

/// Returns the first address of one machine in Cyclone's list of locators, without protocol, port
/// and interface: "192.168.1.7" in "udp/239.255.0.1:7401@2,udp/192.168.1.7:7411@2". Returns an
/// empty text if there is none, as for the own process.
[[nodiscard]] std::string address_in(std::string_view locators);

}  // namespace galilean::wire
