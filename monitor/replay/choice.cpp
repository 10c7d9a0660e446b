// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/choice.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "core/plural.h"
#include "core/spelling.h"
#include "core/visible_text.h"
#include "monitor/replay/report.h"

namespace galilean::monitor {
namespace {

constexpr std::string_view kDdsPrefix = "rt";
constexpr std::string_view kBecomes = ":=";

std::string with_slash(const std::string& topic) {
  return topic.starts_with('/') ? topic : '/' + topic;
}

/// ROS 2's names are words of letters, digits and underscores, each behind a slash. None begins
/// with a digit.
bool is_topic_name(std::string_view name) {
  bool at_beginning = false;
  for (const unsigned char letter : name) {
    if (letter == '/' ? at_beginning : !std::isalnum(letter) && letter != '_') return false;
    if (at_beginning && std::isdigit(letter)) return false;
    at_beginning = letter == '/';
  }
  return name.size() > 1 && name.starts_with('/') && !at_beginning;
}

std::set<std::string> names_of(const Tracks& tracks) {
  std::set<std::string> names;
  for (const auto& [id, track] : tracks.played) names.insert(track.topic.substr(kDdsPrefix.size()));
  return names;
}

Result<std::string> find_played(const std::string& topic, const std::set<std::string>& known) {
  const auto name = with_slash(topic);
  if (known.contains(name)) return name;
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto meant = meant_name(name, names);
  return Error{"no topic '" + visible(name) + "' can be played" +
               (meant.empty() ? "" : "; did you mean '" + visible(meant) + "'?")};
}

Error unknown_robot(const std::string& robot, const std::set<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto meant = meant_name(robot, names);
  return {"no robot '" + visible(robot) + "' is in it" +
          (!meant.empty()  ? "; did you mean '" + visible(meant) + "'?"
           : known.empty() ? ""
                           : agreeing(known.size(), "; there is ", "; there are ") +
                                 listed({known.begin(), known.end()}))};
}

/// Leaves the topics that are named; all if none is.
Result<void> leave_topics(const std::vector<std::string>& topics,
                          const std::set<std::string>& known, Tracks& tracks) {
  std::set<std::string> wanted;
  for (const auto& topic : topics) {
    const auto found = find_played(topic, known);
    if (!found) return found.error();
    wanted.insert(std::string(kDdsPrefix) + found.value());
  }
  if (!wanted.empty())
    std::erase_if(tracks.played,
                  [&](const auto& each) { return !wanted.contains(each.second.topic); });
  return {};
}

/// Leaves what the robots sent that are named; what all sent if none is.
Result<void> leave_robots(const std::vector<std::string>& robots,
                          const std::set<std::string>& known, Tracks& tracks) {
  if (robots.empty()) return {};
  for (const auto& robot : robots)
    if (!known.contains(robot)) return unknown_robot(robot, known);
  std::erase_if(tracks.played, [&](const auto& each) {
    return std::ranges::none_of(robots,
                                [&](const auto& robot) { return is_of(each.second, robot); });
  });
  if (tracks.played.empty())
    return Error{"no topic of " + listed(robots) + " is left to be played"};
  return {};
}

}  // namespace

Result<Choice::Renamed> read_renamed(const std::string& text) {
  const auto middle = text.find(kBecomes);
  if (middle == std::string::npos)
    return Error{"'" + visible(text) + "' is not such as /io/state:=/europa/state"};
  Choice::Renamed renamed{with_slash(text.substr(0, middle)),
                          with_slash(text.substr(middle + kBecomes.size()))};
  for (const auto& name : {renamed.topic, renamed.name})
    if (!is_topic_name(name)) return Error{"'" + visible(name) + "' is no name of a topic"};
  return renamed;
}

Result<void> choose(const Choice& choice, Tracks& tracks) {
  const auto known = names_of(tracks);
  const auto robots = robots_of(tracks);
  if (auto left = leave_topics(choice.topics, known, tracks); !left) return left;
  std::map<std::string, std::string> names;
  for (const auto& [topic, name] : choice.renamed) {
    const auto found = find_played(topic, known);
    if (!found) return found.error();
    names[std::string(kDdsPrefix) + found.value()] = std::string(kDdsPrefix) + name;
  }
  if (auto left = leave_robots(choice.robots, robots, tracks); !left) return left;
  for (auto& [id, track] : tracks.played)
    if (const auto renamed = names.find(track.topic); renamed != names.end())
      track.topic = renamed->second;
  return {};
}

}  // namespace galilean::monitor
