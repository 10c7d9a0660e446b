// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>

#include <boost/beast/http/verb.hpp>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "monitor/server/monitor.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {

/// Returns a DDS domain of this process, so that tests that run at the same time do not hear one
/// another.
[[nodiscard]] int test_domain();

inline constexpr const char* kProgram = "states:\n  state:\n    name: \"start\"\n  end\nend\n";
inline constexpr const char* kBroken =
    "states:\n  state:\n    nme: \"start\"\n  end\n  nonsense\nend\n";

struct HttpAnswer {
  unsigned status = 0;
  std::string body;
  std::string type;
  [[nodiscard]] nlohmann::json as_json() const {
    return nlohmann::json::parse(body, nullptr, false);
  }
};

/// The output of a command, and how it ended.
struct Ran {
  int exit_code = -1;
  std::string output;
};
[[nodiscard]] Ran run_command(const std::string& command);

/// A monitor on a port of its own, with two programs to choose from, in a temporary folder.
class ServerFixture : public testing::Test {
 protected:
  using Headers = std::map<std::string, std::string>;

  void SetUp() override;
  void TearDown() override;
  /// Changes the options with which the monitor of this test starts.
  virtual void change(MonitorOptions& /*options*/) {}

  void write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(monitor->port()); }

  HttpAnswer request(boost::beast::http::verb verb, const std::string& target,
                     const std::string& body = {}, const Headers& headers = {});
  HttpAnswer get(const std::string& target);
  /// Posts as the operator.
  HttpAnswer post(const std::string& target, const nlohmann::json& body);
  [[nodiscard]] Headers bearer(const std::string& file) const;
  nlohmann::json push_named(const std::string& id) { return get("/api/pushes/" + id).as_json(); }
  [[nodiscard]] static nlohmann::json files(const char* text);
  /// Asks until the condition is true, for a limited time. Returns whether it became true.
  [[nodiscard]] bool becomes_true(const std::function<bool()>& condition,
                                  std::chrono::seconds patience = std::chrono::seconds(5));
  void wait_for_robots(std::size_t count);

  const TemporaryFolder folder;
  const std::string catalog = catalog_to_json({});
  std::unique_ptr<Monitor> monitor;
  std::thread thread;
};

}  // namespace galilean::monitor
