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

/// Returns the DDS domain of this process. Tests that run side by side therefore do not hear one
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

/// What a command printed, and its exit code.
struct Ran {
  int exit_code = -1;
  std::string output;
};
[[nodiscard]] Ran run_command(const std::string& command);

/// A monitor on a port of its own. Its programs and its data are in a temporary folder.
class ServerFixture : public testing::Test {
 protected:
  using Headers = std::map<std::string, std::string>;

  void SetUp() override;
  void TearDown() override;
  /// Overrides options before the monitor starts.
  virtual void change(MonitorOptions& /*options*/) {}

  void write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(monitor->port()); }

  HttpAnswer request(boost::beast::http::verb verb, const std::string& target,
                     const std::string& body = {}, const Headers& headers = {});
  HttpAnswer get(const std::string& target);
  /// Returns a copy of the member `name` of what `target` answers. To loop over a member of
  /// as_json() itself would read it after it is gone.
  nlohmann::json list_in(const std::string& target, const char* name) {
    return get(target).as_json()[name];
  }
  /// Posts with the operator's token.
  HttpAnswer post(const std::string& target, const nlohmann::json& body);
  [[nodiscard]] Headers bearer(const std::string& file) const;
  nlohmann::json push_named(const std::string& id) { return get("/api/pushes/" + id).as_json(); }
  [[nodiscard]] static nlohmann::json files(const char* text);
  /// Asks until `condition` holds, for `patience` at most. Returns whether it held.
  [[nodiscard]] bool becomes_true(const std::function<bool()>& condition,
                                  std::chrono::seconds patience = std::chrono::seconds(5));
  void wait_for_robots(std::size_t count);

  const TemporaryFolder folder;
  const std::string catalog = catalog_to_json({});
  std::unique_ptr<Monitor> monitor;
  std::thread thread;
};

}  // namespace galilean::monitor
