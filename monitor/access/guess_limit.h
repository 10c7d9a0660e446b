// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/clock.h"

namespace galilean::monitor {

/// Counts wrong tokens by the address that they come from, so that whoever tries many is told to
/// wait. Only wrong tokens are asked about: a right one passes from every address at any time. A
/// token that is wrong again teaches its sender nothing, so that a page that was left open with an
/// old token does not keep its reader out.
class GuessLimit {
 public:
  static constexpr std::size_t kMostGuesses = 10;      ///< different wrong tokens in a window
  static constexpr std::size_t kMostRequests = 300;    ///< requests with a wrong token in a window
  static constexpr std::size_t kMostAddresses = 4096;  ///< those beyond share one count
  static constexpr Duration kWindow = std::chrono::minutes(1);  ///< from the first wrong token on

  struct Verdict {
    Duration wait{};        ///< until this address may try again; zero: it may go on
    bool is_first = false;  ///< nothing else was refused to this address in this window
  };

  /// Notes a wrong token with this digest.
  [[nodiscard]] Verdict note_wrong(const std::string& address, const std::string& digest, Time now);

 private:
  struct Window {
    Time ends{};
    std::set<std::string> guesses;
    std::size_t requests = 0;
    bool has_refused = false;
  };
  [[nodiscard]] Window& window_of(const std::string& network, Time now);

  std::map<std::string, Window> windows_;
};

/// Returns what counts as one address: an IPv4 address as it is, and the /64 network of an IPv6
/// address, since one machine has all addresses of such a network.
[[nodiscard]] std::string network_of(const std::string& address);

}  // namespace galilean::monitor
