#include "monitor/server/metrics.h"

#include <sstream>

namespace galilean::monitor {
namespace {

void metric(std::ostream& out, const char* name, const char* type, const char* help, auto value) {
  out << "# HELP galilean_" << name << ' ' << help << "\n# TYPE galilean_" << name << ' ' << type
      << "\ngalilean_" << name << ' ' << value << '\n';
}

/// A robot's name as a label's value.
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
  out << "# HELP galilean_robot_" << name << ' ' << help << "\n# TYPE galilean_robot_" << name
      << ' ' << type << '\n';
  for (const auto& robot : robots)
    out << "galilean_robot_" << name << "{robot=\"" << escaped(robot.name) << "\"} "
        << value_of(robot) << '\n';
}

}  // namespace

std::string metrics_text(const Team& team, const foxglove::Hub::Counts& websocket,
                         const HttpServer::Counts& http) {
  std::ostringstream out;
  const auto robots = team.statuses();
  metric(out, "robots", "gauge", "Robots ever heard.", robots.size());
  using R = RobotStatus;
  robot_metric(out, robots, "silent", "gauge", "1 while nothing is heard of it.",
               [](const R& robot) { return robot.health == Health::kSilent ? 1 : 0; });
  robot_metric(out, robots, "age_seconds", "gauge", "Time since it was last heard.",
               [](const R& robot) { return robot.age_s; });
  robot_metric(out, robots, "tick_microseconds", "gauge", "What its last tick took.",
               [](const R& robot) { return robot.tick_time_us; });
  robot_metric(out, robots, "overruns_total", "counter", "Ticks that began a period late.",
               [](const R& robot) { return robot.overruns; });
  robot_metric(out, robots, "drifting", "gauge", "1 while it runs another program than the team.",
               [](const R& robot) { return robot.drifting ? 1 : 0; });
  if (const auto& score = team.score()) {
    metric(out, "deposited", "gauge", "Pieces thrown away.", score->deposited);
    metric(out, "collisions", "gauge", "Collisions that the referee saw.", score->collisions);
    metric(out, "points", "gauge", "The referee's points.", score->points);
  }
  metric(out, "websocket_clients", "gauge", "Clients connected.", websocket.clients);
  metric(out, "websocket_subscriptions", "gauge", "Subscriptions of all.", websocket.subscriptions);
  metric(out, "websocket_frames_total", "counter", "Frames given to clients.", websocket.frames);
  metric(out, "websocket_superseded_total", "counter",
         "Frames that a newer one replaced before a slow client took them.", websocket.superseded);
  metric(out, "websocket_dismissed_total", "counter", "Clients closed for being too slow.",
         websocket.dismissed);
  metric(out, "http_connections", "gauge", "Connections open.", http.connections);
  metric(out, "http_requests_total", "counter", "Requests.", http.requests);
  metric(out, "http_refused_total", "counter", "Requests with a wrong Host or Origin.",
         http.refused);
  return out.str();
}

}  // namespace galilean::monitor
