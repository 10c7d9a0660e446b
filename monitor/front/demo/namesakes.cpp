// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/namesakes.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>
#include <utility>

#include "core/visible_text.h"

namespace galilean::front {
namespace {

/// The time for DDS' discovery in both directions.
constexpr Duration kAcquaintance = std::chrono::milliseconds(800);
constexpr Duration kLookAtClockEach = std::chrono::milliseconds(10);

using Names = std::vector<std::string>;

/// Returns the names that are in both.
Names common(const Names& names, const Names& others) {
  Names both;
  std::ranges::copy_if(names, std::back_inserter(both), [&](const std::string& name) {
    return std::ranges::find(others, name) != others.end();
  });
  return both;
}

/// Returns "io", "io and callisto", or "io, ganymede and callisto".
std::string list_of(const Names& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + visible(names[i]);
  return text;
}

}  // namespace

Namesakes::Namesakes(std::unique_ptr<wire::Participant> participant)
    : participant_(std::move(participant)), endpoints_(*participant_), began_(clock_.now()) {}

Result<std::unique_ptr<Namesakes>> Namesakes::look(int domain) {
  auto participant = wire::Participant::join("demo", domain);
  if (!participant) return participant.error();
  return std::unique_ptr<Namesakes>(new Namesakes(std::move(participant).value()));
}

Result<void> Namesakes::check(const std::vector<std::string>& robots, Termination& termination) {
  while (clock_.now() - began_ < kAcquaintance) {
    if (termination.asked()) return Error{"ended while starting"};
    std::this_thread::sleep_for(kLookAtClockEach);
  }
  auto why = why_not_beside(robots, wire::robots_in(endpoints_.known()), participant_->domain());
  if (!why.empty()) return Error{std::move(why)};
  return {};
}

std::string why_not_beside(const std::vector<std::string>& robots, const wire::Neighbours& there,
                           unsigned domain) {
  const auto live = common(robots, there.live), played = common(robots, there.played);
  if (live.empty() && played.empty()) return {};
  const std::string where = " in DDS domain " + std::to_string(domain) + " already";
  const std::string other_domain = ", or use another domain (--domain or ROS_DOMAIN_ID)";
  if (live.empty()) return "a replay plays " + list_of(played) + where + "; end it" + other_domain;
  return list_of(live) + (live.size() == 1 ? " lives" : " live") + where +
         ", and two robots of one name obey and tell as one; end " +
         (live.size() == 1 ? "that one" : "those") + other_domain;
}

}  // namespace galilean::front
