// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/team_listener.h"

#include <algorithm>
#include <utility>

#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

/// The time after which no further robot is expected. A robot sends its state ten times a second.
constexpr Duration kNobodyNew = std::chrono::milliseconds(500);

std::string list_of(const std::map<std::string, Robot, std::less<>>& robots) {
  std::string names;
  for (const auto& [name, robot] : robots)
    if (robot.state) names += (names.empty() ? "" : ", ") + visible(name);
  return names;
}

bool speaks(const std::map<std::string, Robot, std::less<>>& robots) {
  return std::ranges::any_of(robots, [](auto& each) { return each.second.state.has_value(); });
}

}  // namespace

TeamListener::TeamListener(std::unique_ptr<wire::Participant> participant, Ingest::ReadAtOnce hears)
    : participant_(std::move(participant)),
      team_(clock_),
      ingest_(
          *participant_,
          {{},
           [this](const Message& message) {
             team_.receive(message);
             if (message_) message_(message);
           },
           {}},
          [this] {
            {
              const std::lock_guard lock(mutex_);
              pending_ = true;
            }
            woken_.notify_one();
          },
          std::move(hears)) {}

bool TeamListener::is_heard_by_pushers(const Channel& channel) {
  const auto type = channel.schema->ros_type;
  return type == msg::RobotState::kRosType || type == msg::Catalog::kRosType ||
         type == msg::ProgramReply::kRosType || type == msg::ObjectMap::kRosType;
}

Result<std::unique_ptr<TeamListener>> TeamListener::join(const std::string& name, int domain,
                                                         Ingest::ReadAtOnce hears) try {
  auto participant = wire::Participant::join(name, domain);
  if (!participant) return participant.error();
  return std::unique_ptr<TeamListener>(
      new TeamListener(std::move(participant).value(), std::move(hears)));
} catch (const std::exception& error) {
  return Error{std::string("DDS cannot be used: ") + error.what()};
}

bool TeamListener::wait(Duration timeout, const std::function<bool()>& enough) {
  const auto until = std::chrono::steady_clock::now() + timeout;
  while (!enough()) {
    {
      std::unique_lock lock(mutex_);
      // The wait is short, because `enough` may come true without a message.
      const auto soon = std::min(until, std::chrono::steady_clock::now() + kNobodyNew / 10);
      woken_.wait_until(lock, soon, [this] { return pending_; });
      pending_ = false;
    }
    ingest_.poll();
    if (std::chrono::steady_clock::now() >= until) return enough();
  }
  return true;
}

bool TeamListener::known(const std::string& name) const {
  const Robot* robot = team_.find(name);
  return robot && robot->state && robot->catalog;
}

Result<std::vector<const Robot*>> TeamListener::find(const std::vector<std::string>& names,
                                                     Duration timeout) {
  std::size_t heard = 0;
  Time since = now();
  wait(timeout, [&] {
    if (!names.empty()) return std::ranges::all_of(names, [&](auto& name) { return known(name); });
    if (team_.robots().size() != heard) since = now();
    heard = team_.robots().size();
    return speaks(team_.robots()) && now() - since >= kNobodyNew;
  });
  std::vector<const Robot*> found;
  for (const auto& [name, robot] : team_.robots())
    if (names.empty() || std::ranges::find(names, name) != names.end()) found.push_back(&robot);
  if (!speaks(team_.robots()))
    return Error{
        "no robot sends its state; check that robots run, and in the same DDS domain "
        "(--domain or ROS_DOMAIN_ID)"};
  for (const auto& name : names)
    if (const Robot* robot = team_.find(name); !robot || !robot->state)
      return Error{"robot '" + visible(name) + "' sends no state; " +
                   agreeing(team_.robots().size(), "this one does: ", "these do: ") +
                   list_of(team_.robots())};
  return found;
}

}  // namespace galilean::monitor
