// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/result.h"

namespace galilean::monitor {

/// A monitor's answer to a request.
struct MonitorAnswer {
  int status = 0;
  nlohmann::json json;  ///< discarded if the body is no JSON

  [[nodiscard]] bool ok() const noexcept { return status >= 200 && status < 300; }
  /// Returns the sentence that says why the monitor refused.
  [[nodiscard]] std::string detail() const;
};

/// Why a request has no answer.
struct Unanswered : Error {
  bool was_sent = false;  ///< the monitor may have got the request, and may do what it asks for
};

/// A client of a monitor's HTTP interface, for commands in a terminal. Each request waits for its
/// answer, at most kTimeout_s seconds.
class MonitorClient {
 public:
  static constexpr int kTimeout_s = 20;

  /// Errors: `url` is no address of a monitor, such as http://127.0.0.1:8080 or 127.0.0.1:8080.
  [[nodiscard]] static Result<void> check_address(const std::string& url);
  /// `url` is the monitor's address, as check_address takes it. `token_file` holds the token to
  /// send. If it is empty, this user's operator token is sent, but only to a monitor on this
  /// machine.
  /// Errors: `url` is no such address, or the token cannot be read.
  [[nodiscard]] static Result<MonitorClient> at(const std::string& url,
                                                const std::string& token_file);

  /// Both return the monitor's answer, also if it is a refusal.
  /// Errors: nobody answers in time, the answer is no HTTP, or it is a success without the JSON
  /// object that a monitor sends.
  [[nodiscard]] Result<MonitorAnswer, Unanswered> get(const std::string& path) const;
  [[nodiscard]] Result<MonitorAnswer, Unanswered> post(const std::string& path,
                                                       const nlohmann::json& body) const;

 private:
  MonitorClient(std::string url, std::string host, std::string port)
      : url_(std::move(url)), host_(std::move(host)), port_(std::move(port)) {}
  /// Returns the bytes of a request.
  [[nodiscard]] std::string message(const std::string& method, const std::string& path,
                                    const std::string& body) const;
  [[nodiscard]] Result<MonitorAnswer, Unanswered> request(const std::string& method,
                                                          const std::string& path,
                                                          const std::string& body) const;

  std::string url_;
  std::string host_;
  std::string port_;
  std::string token_;  ///< empty if none is sent
};

}  // namespace galilean::monitor
