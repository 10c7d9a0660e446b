// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/map/map_service.h"
#include "monitor/tls/certificate.h"

namespace galilean::monitor {

/// The monitor's settings. An empty page, library or catalog path means the installed one.
struct MonitorOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;  ///< 0: any free port
  int domain = -1;            ///< the DDS domain; negative: that of ROS_DOMAIN_ID, else 0
  std::filesystem::path page_folder;
  std::filesystem::path library_folder;
  std::filesystem::path data_folder;  ///< keeps tokens, key, history of pushes and trials' files
  bool shares_data_folder = false;    ///< other monitors use it, too: the history is kept in a
                                      ///< folder within it, by domain and port
  std::filesystem::path recordings_folder;  ///< empty: "recordings" in the data folder
  std::filesystem::path catalog_file;
  std::filesystem::path simulator;  ///< galilean-sim's path; empty: the one beside this program
  std::vector<std::string> allowed_origins;
  bool tls = false;
  CertificateFiles certificate;  ///< with TLS; empty: one that the monitor makes for itself
  MapService::Options map;
};

/// The whole monitor. It passes messages from DDS to its clients, to the model of the team, to the
/// map, to the trials and to the pushes. It passes operators' orders to the robots.
class Monitor {
 public:
  /// Starts everything but the handling of requests, which `run` does.
  /// Errors: the port is taken, DDS does not start, or a folder cannot be used.
  [[nodiscard]] static Result<std::unique_ptr<Monitor>> make(const MonitorOptions& options);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept;
  /// Returns the operator's token if tokens were made at this start, else an empty string.
  [[nodiscard]] std::string new_operator_token() const;
  /// Returns the SHA-256 fingerprint of the certificate, or an empty string without TLS.
  [[nodiscard]] std::string fingerprint() const;
  /// Serves on the calling thread until `stop`, SIGINT or SIGTERM.
  void run();
  /// Ends `run`. May be called from any thread.
  void stop();

 private:
  struct Parts;
  explicit Monitor(std::unique_ptr<Parts> blocks);
  std::unique_ptr<Parts> parts_;
};

}  // namespace galilean::monitor
