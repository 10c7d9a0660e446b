// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/result.h"
#include "monitor/commands/exchange.h"

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

  /// Errors: `url` is no address of a monitor, such as http://127.0.0.1:8080 or 127.0.0.1:8080,
  /// or https://lab:8080 where the monitor speaks TLS.
  [[nodiscard]] static Result<void> check_address(const std::string& url);
  /// `url` is the monitor's address, as check_address takes it. `token_file` holds the token to
  /// send. If it is empty, this user's operator token is sent, but only to a monitor on this
  /// machine. `trust` judges the certificate of a monitor at https://. If it is empty, that of this
  /// user's monitor is trusted on this machine, too.
  /// Errors: `url` is no such address, the token cannot be read, or `trust` is of no use there.
  [[nodiscard]] static Result<MonitorClient> at(const std::string& url,
                                                const std::string& token_file,
                                                ServerTrust trust = {});

  /// Both return the monitor's answer, also if it is a refusal.
  /// Errors: nobody answers in time, the answer is no HTTP, or it is a success without the JSON
  /// object that a monitor sends.
  [[nodiscard]] Result<MonitorAnswer, Unanswered> get(const std::string& path) const;
  [[nodiscard]] Result<MonitorAnswer, Unanswered> post(const std::string& path,
                                                       const nlohmann::json& body) const;

 private:
  MonitorClient(std::string url, MonitorAddress address, ServerTrust trust)
      : url_(std::move(url)), address_(std::move(address)), trust_(std::move(trust)) {}
  /// Returns the bytes of a request.
  [[nodiscard]] std::string message(const std::string& method, const std::string& path,
                                    const std::string& body) const;
  [[nodiscard]] Result<MonitorAnswer, Unanswered> request(const std::string& method,
                                                          const std::string& path,
                                                          const std::string& body) const;

  std::string url_;
  MonitorAddress address_;
  ServerTrust trust_;
  std::string token_;  ///< empty if none is sent
};

}  // namespace galilean::monitor
