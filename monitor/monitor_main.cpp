// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <iostream>
#include <utility>

#include "core/broken_pipe.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/last_sentence.h"
#include "core/non_blocking_log.h"
#include "monitor/access/access.h"
#include "monitor/access/tokens.h"
#include "monitor/server/monitor.h"

namespace {
namespace monitor = galilean::monitor;
using galilean::CommandLine, galilean::Error, galilean::Result;

/// Reads "127.0.0.1:8080", "[::1]:8080" or a port alone.
Result<void> read_listen(const std::string& text, monitor::MonitorOptions& options) {
  const auto colon = text.rfind(':');
  std::string address = colon == text.npos ? options.address : text.substr(0, colon);
  if (address.starts_with('[') && address.ends_with(']'))
    address = address.substr(1, address.size() - 2);
  const std::string port = colon == text.npos ? text : text.substr(colon + 1);
  const char* end = port.data() + port.size();
  std::uint16_t number = 0;
  const auto [rest, wrong] = std::from_chars(port.data(), end, number);
  if (wrong != std::errc() || rest != end || address.empty())
    return Error{"'" + text + "' is not a valid ADDRESS:PORT, such as 127.0.0.1:8080"};
  options.address = address;
  options.port = number;
  return {};
}

/// Reads the pose of a robot's odom frame in the map frame, in metres and degrees: "io:1.5,2,90".
Result<void> read_start(const std::string& text, monitor::MonitorOptions& options) {
  double x_m = 0, y_m = 0, heading_deg = 0;
  char rest = 0;
  const auto colon = text.find(':');
  if (colon == text.npos || colon == 0 ||
      std::sscanf(text.c_str() + colon + 1, "%lf,%lf,%lf%c", &x_m, &y_m, &heading_deg, &rest) != 3)
    return Error{"'" + text +
                 "' is not a valid ROBOT:X,Y,HEADING in metres and degrees, such as io:1.5,2,90"};
  options.map.starts[text.substr(0, colon)] = {{x_m, y_m}, heading_deg * galilean::kPi / 180};
  return {};
}

/// Returns how a new token is used. The token itself is for a person who reads it now: where the
/// output is kept, as by a service, others may read it later.
std::string way_to_steer(const std::string& link, const std::string& token,
                         const std::filesystem::path& file) {
  if (isatty(STDOUT_FILENO) == 1)
    return "  Open " + link + "/#token=" + token + " to steer the team.\n" +
           "  This link is printed only once. The token is kept in " + file.string();
  return "  To steer the team, open " + link + "/#token=TOKEN with the token in " + file.string();
}

int run(const monitor::MonitorOptions& options) {
  auto made = monitor::Monitor::make(options);
  if (!made) {
    std::cerr << "galilean-monitor: " << made.error().message << std::endl;
    return galilean::kFailed;
  }
  const auto& running = made.value();
  const bool is_ipv6 = options.address.find(':') != std::string::npos;
  const std::string link = (options.tls ? "https://" : "http://") +
                           std::string(is_ipv6 ? "[" : "") + options.address +
                           (is_ipv6 ? "]:" : ":") + std::to_string(running->port());
  std::cout << "galilean-monitor: " << link << std::endl;
  if (const auto token = running->new_operator_token(); !token.empty())
    std::cout << way_to_steer(link, token, monitor::operator_token_file(options.data_folder))
              << std::endl;
  if (options.tls)
    std::cout << "  The certificate's SHA-256 fingerprint, to compare with what the browser shows: "
              << running->fingerprint() << std::endl;
  else if (!monitor::is_loopback(options.address))
    std::cout
        << "  This is plain HTTP: anyone on the network between here and a reader can read the "
           "tokens, and steer the team with them."
        << std::endl;
  running->run();
  return EXIT_SUCCESS;
}

/// Returns why the monitor may not listen there; empty if it may. Whoever can listen to the network
/// has the operator's token as soon as it is sent once, so nobody shall come to that by accident.
std::string unprotected(const monitor::MonitorOptions& options, bool plain) {
  if (plain || options.tls || monitor::is_loopback(options.address)) return {};
  return "--listen " + options.address +
         " is heard on the network, where anyone can read the tokens of plain HTTP; give --tls, "
         "too, or --plain if you trust that network";
}

/// Returns why the certificate's options do not fit together; empty if they do.
std::string wrong_certificate(const monitor::MonitorOptions& options) {
  const auto& [certificate, key] = options.certificate;
  if (certificate.empty() != key.empty())
    return "--certificate and --key belong together; without both, --tls makes its own";
  if (!certificate.empty() && !options.tls) return "--certificate is of use with --tls only";
  return {};
}

/// Returns which of the folders is a file or anything else that is no folder; empty if none is.
std::string no_folder(const monitor::MonitorOptions& options) {
  const std::pair<const char*, const std::filesystem::path*> folders[] = {
      {"--web", &options.page_folder},
      {"--programs", &options.library_folder},
      {"--data", &options.data_folder},
      {"--recordings", &options.recordings_folder}};
  for (const auto& [option, folder] : folders) {
    std::error_code unknown;
    if (std::filesystem::exists(*folder, unknown) &&
        !std::filesystem::is_directory(*folder, unknown))
      return std::string(option) + " " + folder->string() + " is no folder";
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  galilean::say_why_it_ends("galilean-monitor");
  galilean::ignore_broken_pipes();
  galilean::ignore_file_size_limit();
  const galilean::NonBlockingLog log(STDERR_FILENO, std::clog);
  monitor::MonitorOptions options;
  options.data_folder = monitor::default_data_folder();
  options.recordings_folder = options.data_folder / "recordings";
  double silent_after_s = 2;
  bool plain = false;
  CommandLine app("Watches and steers a team of robots, and serves the page that shows it.",
                  "galilean monitor");
  app.option(
      "--listen", [&](const std::string& text) { return read_listen(text, options); },
      "where to serve, ADDRESS:PORT (127.0.0.1:8080)");
  auto tls = app.flag("--tls", options.tls,
                      "serve HTTPS, with a certificate that is made at the first start");
  app.option("--certificate", options.certificate.certificate,
             "PEM file of the certificate, and of those that vouch for it, instead of one's own")
      .names_file(".pem");
  app.option("--key", options.certificate.key, "PEM file of the certificate's private key")
      .names_file();
  app.flag("--plain", plain,
           "serve plain HTTP on a network whose every user may read the tokens and steer the team")
      .excludes(tls);
  galilean::add_domain_option(app, options.domain);
  app.option("--web", options.page_folder, "folder of the built page").names_folder();
  app.option("--programs", options.library_folder, "folder of the programs to choose from")
      .names_folder();
  app.option("--catalog", options.catalog_file,
             "JSON file of the components, used where no robot is asked for them")
      .names_file(".json");
  const auto data =
      app.option(
             "--data", options.data_folder,
             "folder that keeps the history of pushes, the tokens and the key that signs orders")
          .names_folder();
  app.option("--recordings", options.recordings_folder,
             "folder of the recordings that the page plays, and that are put there")
      .names_folder();
  app.option("--simulator", options.simulator,
             "simulator that tries programs, instead of galilean-sim")
      .names_file();
  app.option("--silent-after", silent_after_s,
             "how many seconds a robot may send nothing before it counts as silent")
      .positive();
  app.options(
      "--start", [&](const std::string& text) { return read_start(text, options); },
      "where a robot's odometry begins in the map, ROBOT:X,Y,HEADING in m and degrees");
  app.option("--allow-origin", options.allowed_origins,
             "another page that may use this monitor, as https://host[:port]")
      .not_empty();
  if (const auto code = app.parse(argc, argv)) return *code;
  if (const auto wrong = no_folder(options); !wrong.empty()) return app.refuse(wrong);
  options.shares_data_folder = !data.given();
  if (const auto why = wrong_certificate(options); !why.empty()) return app.refuse(why);
  if (const auto why = unprotected(options, plain); !why.empty()) return app.refuse(why);
  options.map.silent_after = galilean::from_seconds(silent_after_s);
  return run(options);
}
