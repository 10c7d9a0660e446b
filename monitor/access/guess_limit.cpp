// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/guess_limit.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <array>
#include <cstring>

namespace galilean::monitor {

GuessLimit::Verdict GuessLimit::note_wrong(const std::string& address, const std::string& digest,
                                           Time now) {
  Window& window = window_of(network_of(address), now);
  ++window.requests;
  const bool is_known = window.guesses.contains(digest);
  const bool is_one_too_many = !is_known && window.guesses.size() >= kMostGuesses;
  if (!is_known && !is_one_too_many) window.guesses.insert(digest);
  if (!is_one_too_many && window.requests <= kMostRequests) return {};
  const bool is_first = !window.has_refused;
  window.has_refused = true;
  return {.wait = window.ends - now, .is_first = is_first};
}

GuessLimit::Window& GuessLimit::window_of(const std::string& network, Time now) {
  if (windows_.size() >= kMostAddresses && !windows_.contains(network))
    std::erase_if(windows_, [&](const auto& each) { return each.second.ends <= now; });
  const bool is_full = windows_.size() >= kMostAddresses && !windows_.contains(network);
  Window& window = windows_[is_full ? std::string() : network];
  if (window.ends <= now) window = Window{.ends = now + kWindow, .guesses = {}};
  return window;
}

std::string network_of(const std::string& address) {
  const std::string plain = address.substr(0, address.find('%'));  // without its interface
  in6_addr v6{};
  if (inet_pton(AF_INET6, plain.c_str(), &v6) != 1) return plain;
  if (IN6_IS_ADDR_V4MAPPED(&v6)) {
    std::array<char, INET_ADDRSTRLEN> v4{};
    return inet_ntop(AF_INET, &v6.s6_addr[12], v4.data(), v4.size()) ? v4.data() : plain;
  }
  constexpr std::size_t kNetworkBytes = 8;
  std::memset(&v6.s6_addr[kNetworkBytes], 0, sizeof v6.s6_addr - kNetworkBytes);
  std::array<char, INET6_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET6, &v6, text.data(), text.size()) ? text.data() : plain;
}

}  // namespace galilean::monitor
