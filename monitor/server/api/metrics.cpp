// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/metrics.h"

#include <unistd.h>

#include <ctime>
#include <fstream>
#include <sstream>

#include "core/visible_text.h"
#include "monitor/background/guarded.h"

namespace galilean::monitor {
namespace {

void family(std::ostream& out, const std::string& name, const char* type, const char* help) {
  out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n';
}

void metric(std::ostream& out, const std::string& name, const char* type, const char* help,
            auto value) {
  family(out, name, type, help);
  out << name << ' ' << value << '\n';
}

/// Returns a text that others chose, escaped for a label's value.
std::string escaped(const std::string& name) {
  std::string result;
  for (const char letter : name) {
    if (letter == '\\' || letter == '"') result += '\\';
    if (letter == '\n')
      result += "\\n";
    else
      result += letter;
  }
  return result;
}

void robot_metric(std::ostream& out, const std::vector<RobotStatus>& robots, const char* name,
                  const char* type, const char* help, auto value_of) {
  family(out, std::string("galilean_robot_") + name, type, help);
  for (const auto& robot : robots)
    out << "galilean_robot_" << name << "{robot=\"" << escaped(robot.name) << "\"} "
        << value_of(robot) << '\n';
}

/// Writes the process' metrics under the names that every Prometheus client library gives them.
void process_metrics(std::ostream& out) {
  metric(out, "process_cpu_seconds_total", "counter", "Processor time used, of all threads.",
         static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
  std::size_t all_pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> all_pages >> resident_pages;
  metric(out, "process_resident_memory_bytes", "gauge", "Memory in use.",
         resident_pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

/// Topics of which nothing was lost or filled have no line, because only robots' events are
/// counted.
void event_metric(std::ostream& out, const Intake& intake, const std::string& name,
                  const char* help, std::uint64_t ChannelIntake::*count) {
  family(out, name, "counter", help);
  for (const auto& channel : intake.channels)
    if (const auto events = channel.*count; events > 0)
      out << name << "{topic=\"" << escaped(visible(channel.topic)) << "\"} " << events << '\n';
}

void intake_metrics(std::ostream& out, const Intake& intake) {
  constexpr const char* kRefused = "galilean_refused_messages_total";
  family(out, kRefused, "counter", "Messages from DDS that were not taken, and why.");
  for (const auto& each : intake.refused)
    out << kRefused << "{topic=\"" << escaped(visible(each.topic)) << "\",reason=\""
        << escaped(each.reason) << "\"} " << each.messages << '\n';
  event_metric(out, intake, "galilean_filled_events_total",
               "Events of robots that came after a gap in which the robot could not be heard.",
               &ChannelIntake::filled);
  event_metric(out, intake, "galilean_lost_events_total",
               "Events of robots that will not come: the robot does not keep them any more.",
               &ChannelIntake::lost);
  metric(out, "galilean_topics", "gauge", "Topics known.", intake.channels.size());
  metric(out, "galilean_topics_not_read_total", "counter", "Topics beyond those that are read.",
         intake.topics_not_read);
  metric(out, "galilean_robots_forgotten_total", "counter",
         "Robots that were silent for an hour and gave their places to others.",
         intake.robots_forgotten);
}

void map_metrics(std::ostream& out, const MapService& map) {
  metric(out, "galilean_map_update_seconds", "gauge", "Duration of the last map update.",
         map.update_s());
  metric(out, "galilean_map_well", "gauge",
         "0 while the map stands still, loses updates or drops messages.",
         map.watch().problem().empty() ? 1 : 0);
  metric(out, "galilean_map_failures_total", "counter",
         "Messages and updates at which the map failed.", map.watch().failures());
  metric(out, "galilean_map_dropped_messages_total", "counter",
         "Messages that the map did not take, because too many waited.", map.watch().dropped());
}

void history_metrics(std::ostream& out, const HistoryWatch& history) {
  metric(out, "galilean_history_disk_well", "gauge",
         "1 while the history's disk has room and can be written.", history.is_disk_well() ? 1 : 0);
  metric(out, "galilean_history_disk_available_bytes", "gauge", "Room left on the history's disk.",
         history.disk().available_bytes);
  metric(out, "galilean_history_reserve", "gauge",
         "1 while room on the disk is kept back for the history.",
         history.disk().has_reserve ? 1 : 0);
  metric(out, "galilean_history_owed_changes", "gauge",
         "Changes of the history that wait in memory for its disk.", history.disk().owed);
  metric(out, "galilean_history_lost_changes_total", "counter",
         "Changes of the history that were lost, because too many waited for its disk.",
         history.disk().lost);
  const auto& found = history.verification();
  if (!found) return;
  metric(out, "galilean_history_whole", "gauge",
         "1 if no row of the history had been changed or taken away when the monitor started.",
         found->broken ? 0 : 1);
}

void limit_metrics(std::ostream& out, const LimitCounts& counts) {
  family(out, "galilean_limit_reached_total", "counter",
         "How often clients reached a limit; MONITOR.md lists the limits.");
  for (std::size_t each = 0; each < kLimitCount; ++each) {
    const auto limit = static_cast<Limit>(each);
    out << "galilean_limit_reached_total{limit=\"" << LimitCounts::name(limit) << "\"} "
        << counts.count(limit) << '\n';
  }
  metric(out, "galilean_out_of_memory_total", "counter",
         "Requests and other jobs that failed because no memory was left.", memory_failures.load());
}

}  // namespace

std::string metrics_text(const Team& team, const foxglove::Hub::Counts& websocket,
                         const HttpServer::Counts& http, const Intake& intake,
                         const LimitCounts& limit_counts, const MapService& map,
                         const HistoryWatch& history) {
  std::ostringstream out;
  process_metrics(out);
  map_metrics(out, map);
  const auto robots = team.statuses();
  metric(out, "galilean_robots", "gauge", "Robots that are known.", robots.size());
  using R = RobotStatus;
  robot_metric(out, robots, "silent", "gauge", "1 while nothing is heard of it.",
               [](const R& robot) { return robot.health == Health::kSilent ? 1 : 0; });
  robot_metric(out, robots, "replayed", "gauge", "1 while a recording plays it.",
               [](const R& robot) { return robot.replayed ? 1 : 0; });
  robot_metric(out, robots, "age_seconds", "gauge", "Time since it was last heard.",
               [](const R& robot) { return robot.age_s; });
  robot_metric(out, robots, "tick_seconds", "gauge", "Duration of the last tick.",
               [](const R& robot) { return robot.tick_time_us * 1e-6; });
  robot_metric(out, robots, "overruns_total", "counter", "Ticks that began a period late.",
               [](const R& robot) { return robot.overruns; });
  robot_metric(out, robots, "drifting", "gauge", "1 while it runs another program than the team.",
               [](const R& robot) { return robot.drifting ? 1 : 0; });
  robot_metric(out, robots, "clock_ahead_seconds", "gauge",
               "How far its clock is ahead of the monitor's; 0 where that is little.",
               [](const R& robot) { return robot.clock_ahead_s; });
  intake_metrics(out, intake);
  metric(out, "galilean_strategies_dropped_total", "counter",
         "Programs whose score was dropped for newer ones.", team.strategies_dropped());
  if (const auto& score = team.score()) {
    metric(out, "galilean_deposited", "gauge", "Pieces thrown away.", score->deposited);
    metric(out, "galilean_collisions", "gauge", "Collisions that the referee saw.",
           score->collisions);
    metric(out, "galilean_points", "gauge", "The referee's points.", score->points);
  }
  metric(out, "galilean_websocket_clients", "gauge", "Clients connected.", websocket.clients);
  metric(out, "galilean_websocket_subscriptions", "gauge", "Subscriptions of all.",
         websocket.subscriptions);
  metric(out, "galilean_websocket_frames_total", "counter", "Frames given to clients.",
         websocket.frames);
  metric(out, "galilean_websocket_superseded_total", "counter",
         "Frames that a newer one replaced before a slow client took them.", websocket.superseded);
  metric(out, "galilean_websocket_dismissed_total", "counter", "Clients closed for being too slow.",
         websocket.dismissed);
  metric(out, "galilean_replays", "gauge", "Recordings that are played to a viewer.", http.replays);
  metric(out, "galilean_http_connections", "gauge", "Connections open.", http.connections);
  metric(out, "galilean_http_requests_total", "counter", "Requests.", http.requests);
  metric(out, "galilean_http_refused_total", "counter", "Requests with a wrong Host or Origin.",
         http.refused);
  metric(out, "galilean_http_wrong_tokens_total", "counter",
         "Requests with a token that gives no right.", http.wrong_tokens);
  metric(out, "galilean_http_held_off_total", "counter",
         "Requests answered with 429, after too many wrong tokens.", http.held_off);
  metric(out, "galilean_websocket_revoked_total", "counter",
         "Clients closed because their token was revoked or expired.", http.revoked);
  history_metrics(out, history);
  metric(out, "galilean_http_malformed_total", "counter", "Requests that are no strict HTTP.",
         http.malformed);
  metric(out, "galilean_connections", "gauge", "Connections open, WebSockets included.",
         http.all_connections);
  metric(out, "galilean_connections_closed_total", "counter",
         "Connections that waited for a request and were closed to make room.",
         http.closed_for_others);
  limit_metrics(out, limit_counts);
  return out.str();
}

}  // namespace galilean::monitor
