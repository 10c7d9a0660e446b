// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "core/broken_pipe.h"
#include "monitor/access/tokens.h"
#include "monitor/server/monitor.h"

namespace {
namespace monitor = galilean::monitor;

constexpr int kCannotStart = 2;

/// "127.0.0.1:8080", "[::1]:8080" or a port alone.
void read_listen(const std::string& text, monitor::MonitorOptions& options) {
  const auto colon = text.rfind(':');
  std::string address = colon == text.npos ? options.address : text.substr(0, colon);
  if (address.starts_with('[') && address.ends_with(']'))
    address = address.substr(1, address.size() - 2);
  const std::string port = colon == text.npos ? text : text.substr(colon + 1);
  int number = -1;
  if (!CLI::detail::lexical_cast(port, number) || number < 0 || number > 65535 || address.empty())
    throw CLI::ValidationError("--listen", "'" + text +
                                               "' is no ADDRESS:PORT, such as "
                                               "127.0.0.1:8080");
  options.address = address;
  options.port = static_cast<std::uint16_t>(number);
}

/// "io:1.5,2,90" -> where io's odom frame has its origin in the map: metres and degrees.
void read_start(const std::string& text, monitor::MonitorOptions& options) {
  double x_m = 0, y_m = 0, heading_deg = 0;
  char rest = 0;
  const auto colon = text.find(':');
  if (colon == text.npos || colon == 0 ||
      std::sscanf(text.c_str() + colon + 1, "%lf,%lf,%lf%c", &x_m, &y_m, &heading_deg, &rest) != 3)
    throw CLI::ValidationError("--start",
                               "'" + text +
                                   "' is no ROBOT:X,Y,HEADING in metres and degrees, such as "
                                   "io:1.5,2,90");
  options.map.starts[text.substr(0, colon)] = {{x_m, y_m}, heading_deg * galilean::kPi / 180};
}

int run(const monitor::MonitorOptions& options) {
  auto made = monitor::Monitor::make(options);
  if (!made) {
    std::cerr << "galilean-monitor: " << made.error().message << std::endl;
    return kCannotStart;
  }
  const auto& running = made.value();
  const bool is_ipv6 = options.address.find(':') != std::string::npos;
  const std::string link = std::string("http://") + (is_ipv6 ? "[" : "") + options.address +
                           (is_ipv6 ? "]:" : ":") + std::to_string(running->port());
  std::cout << "galilean-monitor: " << link << std::endl;
  if (const auto token = running->new_operator_token(); !token.empty())
    std::cout << "  who opens " << link << "/#token=" << token
              << " may steer the team; this is said once, the token is in "
              << monitor::operator_token_file(options.data_folder).string() << std::endl;
  running->run();
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  galilean::ignore_broken_pipes();
  monitor::MonitorOptions options;
  options.data_folder = monitor::default_data_folder();
  double silent_after_s = 2;
  CLI::App app("Watches and steers a team of robots, and serves the page that shows it.",
               "galilean-monitor");
  app.add_option_function<std::string>(
      "--listen", [&](const std::string& text) { read_listen(text, options); },
      "where to serve, ADDRESS:PORT (127.0.0.1:8080)");
  app.add_option("--domain", options.domain, "DDS domain (ROS_DOMAIN_ID, else 0)");
  app.add_option("--web", options.page_folder, "folder of the built page");
  app.add_option("--programs", options.library_folder, "folder of the programs to choose from");
  app.add_option("--catalog", options.catalog_file, "components, for where no robot is asked");
  app.add_option("--data", options.data_folder,
                 "folder that keeps the history of pushes and the tokens");
  app.add_option("--simulator", options.simulator, "what tries programs, instead of galilean-sim");
  app.add_option("--silent-after", silent_after_s,
                 "seconds without a word before a robot is silent")
      ->check(CLI::PositiveNumber);
  app.add_option_function<std::vector<std::string>>(
      "--start",
      [&](const std::vector<std::string>& texts) {
        for (const auto& text : texts) read_start(text, options);
      },
      "where a robot's odometry begins in the map, ROBOT:X,Y,HEADING in m and degrees");
  app.add_option("--allow-origin", options.allowed_origins,
                 "another page that may use this monitor, as https://host[:port]");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? EXIT_SUCCESS : kCannotStart;
  }
  options.map.silent_after = galilean::from_seconds(silent_after_s);
  return run(options);
}
