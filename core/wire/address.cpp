// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/address.h"

#include <cstdlib>

namespace galilean::wire {
namespace {

/// Returns "192.168.1.7" of "udp/192.168.1.7:7411@2", and "[fe80::1]" of "udp6/[fe80::1]:7411@2".
/// Returns an empty text if the locator has no port, and so no address.
std::string_view address_of_locator(std::string_view locator) {
  const auto slash = locator.find('/');
  if (slash == locator.npos) return {};
  locator.remove_prefix(slash + 1);
  const auto colon = locator.rfind(':');
  return colon == locator.npos ? std::string_view() : locator.substr(0, colon);
}

/// Returns whether many machines may listen to the address (RFC 5771, RFC 4291).
bool is_multicast(std::string_view address) {
  constexpr int kFirst = 224, kLast = 239;
  if (address.starts_with("[ff")) return true;
  const int first = std::atoi(std::string(address.substr(0, address.find('.'))).c_str());
  return first >= kFirst && first <= kLast;
}

}  // namespace

std::string address_in(std::string_view locators) {
  while (!locators.empty()) {
    const auto comma = locators.find(',');
    const auto address = address_of_locator(locators.substr(0, comma));
    if (!address.empty() && !is_multicast(address)) return std::string(address);
    locators.remove_prefix(comma == locators.npos ? locators.size() : comma + 1);
  }
  return {};
}

}  // namespace galilean::wire
