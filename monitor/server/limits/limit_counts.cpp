// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/limits/limit_counts.h"

#include <iostream>
#include <string>

namespace galilean::monitor {
namespace {

/// A limit's name, and what happens when it is reached, as a sentence.
struct LimitWords {
  std::string_view name, sentence;
};

constexpr std::array<LimitWords, kLimitCount> kLimitWords{{
    {"connections",
     "As many connections are open as the monitor keeps; the one that waits longest for a request "
     "is closed for a new one, and beyond those only an operator is answered."},
    {"connections_of_address",
     "As many connections of one address are open as the monitor keeps; the one that waits longest "
     "for a request is closed for a new one, and beyond those only an operator is answered."},
    {"descriptors",
     "No file descriptor is free, so new connections wait; close clients, or start the monitor "
     "with a higher 'ulimit -n'."},
    {"headers", "A request had a longer header than the monitor reads, and was refused."},
    {"body", "A request had a longer body than its path takes, and was refused."},
    {"bodies",
     "As many bytes of requests' bodies are being read as the monitor keeps, so a request was "
     "refused."},
    {"checks", "As many checks wait as the monitor keeps, so a request was refused."},
    {"recordings",
     "As many requests for recordings wait as the monitor keeps, so a request was refused."},
    {"commands", "As many commands wait for DDS as the monitor keeps, so a command was refused."},
    {"pings", "A WebSocket sent more pings a second than the monitor answers, and was closed."},
    {"message", "A client's message was longer than the monitor reads, and was refused."},
    {"messages",
     "As many bytes of WebSockets' messages are being read as the monitor keeps, so one was "
     "closed."},
    {"subscriptions", "A client subscribed oftener than the monitor keeps, and was refused."},
    {"calls",
     "As many calls of a client wait for answers as the monitor keeps, so a call was refused."},
    {"waiting_events",
     "A client read its events more slowly than the monitor keeps them, and was closed."},
    {"waiting_events_of_all",
     "As many events wait for slow clients as the monitor keeps, so the slowest was closed."},
}};

}  // namespace

void LimitCounts::reached(Limit limit) {
  if (counts_[static_cast<std::size_t>(limit)].fetch_add(1) > 0) return;
  const auto& [name, sentence] = kLimitWords[static_cast<std::size_t>(limit)];
  std::string line = "galilean-monitor: ";
  line.append(sentence)
      .append(" This is told once; /metrics counts it as galilean_limit_reached_total{limit=\"")
      .append(name)
      .append("\"}.\n");
  std::clog << line << std::flush;
}

std::uint64_t LimitCounts::count(Limit limit) const noexcept {
  return counts_[static_cast<std::size_t>(limit)].load();
}

std::string_view LimitCounts::name(Limit limit) noexcept {
  return kLimitWords[static_cast<std::size_t>(limit)].name;
}

}  // namespace galilean::monitor
