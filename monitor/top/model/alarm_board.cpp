// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/plural.h"
#include "monitor/top/model/alarms.h"

namespace galilean::monitor::top {
namespace {

/// What was over sooner was none: a robot that was just started is heard before its program is.
constexpr Duration kPassing = std::chrono::milliseconds(1500);

std::vector<std::string> robots_of(const std::vector<const PostedAlarm*>& group) {
  std::vector<std::string> robots;
  for (const auto* each : group)
    if (std::ranges::find(robots, each->alarm.robot) == robots.end())
      robots.push_back(each->alarm.robot);
  return robots;
}

/// What one robot is or was, and what several are or were.
struct Words {
  const char* one;
  const char* one_past;
  const char* several;
  const char* several_past;
};

Words words_of(AlarmKind kind) {
  switch (kind) {
    case AlarmKind::kSilent:
      return {"is silent", "was silent", "are silent", "were silent"};
    case AlarmKind::kLate:
      return {"begins its ticks late", "began its ticks late", "begin their ticks late",
              "began their ticks late"};
    case AlarmKind::kDrift:
      return {"runs another program than the team", "ran another program than the team",
              "run another program than the team", "ran another program than the team"};
    case AlarmKind::kStuck:
      return {"does not move", "did not move", "do not move", "did not move"};
    case AlarmKind::kUncertain:
      return {"may not be where the map shows it", "may not have been where the map showed it",
              "may not be where the map shows them", "may not have been where the map showed them"};
    case AlarmKind::kPush:
      return {"refused or went back from a push", "refused or went back from a push",
              "refused or went back from a push", "refused or went back from a push"};
    case AlarmKind::kRefused:
      return {"sends messages that are not taken", "sent messages that were not taken",
              "send messages that are not taken", "sent messages that were not taken"};
    case AlarmKind::kLost:
      return {"did more in a gap than it keeps", "did more in a gap than it keeps",
              "did more in a gap than they keep", "did more in a gap than they keep"};
    case AlarmKind::kProblem:
      break;
  }
  return {"has problems", "had problems", "have problems", "had problems"};
}

/// Returns "3 robots are silent: io, europa, callisto", or "… were silent …" where that is over.
std::string group_text(const std::vector<const PostedAlarm*>& group, bool over) {
  const auto robots = robots_of(group);
  const Words words = words_of(group[0]->alarm.kind);
  const char* now = robots.size() == 1 ? words.one : words.several;
  const char* past = robots.size() == 1 ? words.one_past : words.several_past;
  const bool are_robots = group[0]->alarm.kind != AlarmKind::kRefused;
  std::string text =
      plural(robots.size(), are_robots ? "robot" : "sender") + " " + (over ? past : now);
  for (std::size_t i = 0; i < robots.size(); ++i) text += (i == 0 ? ": " : ", ") + robots[i];
  return text;
}

AlarmLine line_of(const std::vector<const PostedAlarm*>& group, Time now) {
  AlarmLine line;
  for (const auto* each : group) line.keys.push_back(each->alarm.key);
  line.seen = std::ranges::all_of(group, [](const auto* each) { return each->seen; });
  line.over = std::ranges::all_of(group, [](const auto* each) { return each->over.has_value(); });
  if (group.size() == 1) {
    line.text = sentence_of(*group[0], now);
    line.robot = group[0]->alarm.robot;
  } else {
    line.text = group_text(group, line.over);
  }
  return line;
}

}  // namespace

void AlarmBoard::update(const std::vector<Alarm>& active, Time now) {
  std::vector<PostedAlarm> next;
  const auto known = [&](const std::string& key) {
    return std::ranges::find_if(
        posted_, [&](const auto& each) { return each.alarm.key == key && !each.over; });
  };
  for (const auto& alarm : active) {
    const auto before = known(alarm.key);
    const bool is_new = before == posted_.end();
    const Time found = is_new ? now : before->found;
    next.push_back({alarm, alarm.since.value_or(found), {}, !is_new && before->seen, found});
  }
  for (auto posted : posted_) {
    const bool lasts = std::ranges::any_of(
        active, [&](const Alarm& alarm) { return alarm.key == posted.alarm.key; });
    if (lasts || posted.seen || posted.over.value_or(now) - posted.found < kPassing) continue;
    if (!posted.over) posted.over = now;
    next.push_back(std::move(posted));
  }
  std::ranges::stable_sort(next, [](const PostedAlarm& a, const PostedAlarm& b) {
    return a.seen != b.seen ? b.seen : a.found > b.found;
  });
  posted_ = std::move(next);
}

void AlarmBoard::acknowledge(const std::vector<std::string>& keys) {
  for (auto& posted : posted_)
    if (keys.empty() || std::ranges::find(keys, posted.alarm.key) != keys.end()) posted.seen = true;
  std::erase_if(posted_, [](const PostedAlarm& posted) { return posted.seen && posted.over; });
}

std::string lasting(double duration_s) {
  char text[32];
  const double whole = std::max(duration_s, 0.0);
  if (whole < 10)
    std::snprintf(text, sizeof text, "%.1f s", whole);
  else if (whole < 120)
    std::snprintf(text, sizeof text, "%.0f s", whole);
  else if (whole < 7200)
    std::snprintf(text, sizeof text, "%.0f min", whole / 60);
  else
    std::snprintf(text, sizeof text, "%.0f h", whole / 3600);
  return text;
}

std::string sentence_of(const PostedAlarm& posted, Time now) {
  if (posted.alarm.kind == AlarmKind::kPush)
    return posted.alarm.words + ", " + lasting(to_seconds(now - posted.since)) + " ago";
  const std::string lasted = lasting(to_seconds(posted.over.value_or(now) - posted.since));
  if (!posted.over) return posted.alarm.words + ", for " + lasted;
  return posted.alarm.past.empty() ? posted.alarm.words + "; over after " + lasted
                                   : posted.alarm.past + " for " + lasted;
}

std::vector<AlarmLine> alarm_lines(const std::vector<PostedAlarm>& posted, Time now,
                                   std::size_t most) {
  std::vector<std::vector<const PostedAlarm*>> groups;
  const bool grouped = posted.size() > most;
  for (const auto& each : posted) {
    const auto same = std::ranges::find_if(groups, [&](const auto& group) {
      return grouped && group[0]->alarm.kind == each.alarm.kind && group[0]->seen == each.seen &&
             group[0]->over.has_value() == each.over.has_value();
    });
    if (same == groups.end())
      groups.push_back({&each});
    else
      same->push_back(&each);
  }
  std::vector<AlarmLine> lines;
  for (const auto& group : groups) lines.push_back(line_of(group, now));
  return lines;
}

}  // namespace galilean::monitor::top
