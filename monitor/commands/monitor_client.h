// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/result.h"

namespace galilean::monitor {

/// What a monitor said to a request.
struct MonitorAnswer {
  int status = 0;
  nlohmann::json json;

  [[nodiscard]] bool ok() const noexcept { return status >= 200 && status < 300; }
  /// Why it refused, in a sentence.
  [[nodiscard]] std::string detail() const;
};

/// A monitor, as commands in a terminal talk to it: over HTTP. Each request waits for its answer,
/// at most kPatience_s seconds.
class MonitorClient {
 public:
  static constexpr int kPatience_s = 20;

  /// `url` as in http://127.0.0.1:8080. `token_file`: who we are; empty: this user's operator
  /// token, which is told to nobody but this machine. The error says what is wrong with them.
  [[nodiscard]] static Result<MonitorClient> at(const std::string& url,
                                                const std::string& token_file);

  /// The errors say that nobody answered, and what to do.
  [[nodiscard]] Result<MonitorAnswer> get(const std::string& path) const;
  [[nodiscard]] Result<MonitorAnswer> post(const std::string& path,
                                           const nlohmann::json& body) const;

 private:
  MonitorClient(std::string url, std::string host, std::string port)
      : url_(std::move(url)), host_(std::move(host)), port_(std::move(port)) {}
  /// Returns the bytes of a request.
  [[nodiscard]] std::string message(const std::string& method, const std::string& path,
                                    const std::string& body) const;
  [[nodiscard]] Result<MonitorAnswer> request(const std::string& method, const std::string& path,
                                              const std::string& body) const;

  std::string url_;
  std::string host_;
  std::string port_;
  std::string token_;  ///< empty: none
};

}  // namespace galilean::monitor
