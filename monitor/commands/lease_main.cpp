// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/command_line/command_line.h"
#include "core/json_text.h"
#include "core/termination.h"
#include "core/visible_text.h"
#include "monitor/commands/monitor_client.h"
#include "monitor/commands/push_options.h"

namespace {

using namespace galilean::monitor;
using galilean::Error, galilean::Result, galilean::visible;
using nlohmann::json;

constexpr const char* kCommand = "galilean lease";
constexpr int kLookEach_ms = 500;

int fail(const std::string& why) {
  std::cerr << kCommand << ": " << why << std::endl;
  return galilean::kFailed;
}

Result<json> answer_of(const Result<MonitorAnswer, Unanswered>& answer) {
  if (!answer) return Error{answer.error().message};
  if (!answer.value().ok()) return Error{answer.value().detail()};
  return answer.value().json;
}

/// Returns each robot's lease by its name; null where nobody holds it.
Result<json> leases_of(const MonitorClient& monitor) {
  const auto status = answer_of(monitor.get("/api/status"));
  if (!status) return status.error();
  auto leases = json::object();
  for (const auto& robot : status.value().value("robots", json::array()))
    leases[robot.value("name", "")] = robot.value("lease", json());
  return leases;
}

std::string name_in(const json& lease, const char* member) {
  const auto found = lease.find(member);
  return found == lease.end() || !found->is_object() ? "" : visible(found->value("name", ""));
}

bool is_yours(const json& lease) {
  return lease.is_object() && lease.value("yours", false);
}

std::string words_of(const json& lease) {
  if (!lease.is_object()) return "nobody";
  auto words = is_yours(lease) ? "you" : name_in(lease, "holder");
  if (const auto asker = name_in(lease, "asker"); !asker.empty())
    words += "; " + asker + " asks, and gets it in " +
             std::to_string(lease.value("answer_within_s", 0)) + " s";
  return words;
}

int list(const MonitorClient& monitor, bool as_json) {
  const auto leases = leases_of(monitor);
  if (!leases) return fail(leases.error().message);
  if (as_json) {
    std::cout << galilean::json_text({{"leases", leases.value()}}, 1) << std::endl;
    return EXIT_SUCCESS;
  }
  for (const auto& [robot, lease] : leases.value().items())
    std::cout << visible(robot) << "  " << words_of(lease) << '\n';
  return EXIT_SUCCESS;
}

Result<json> change(const MonitorClient& monitor, const char* deed,
                    const std::vector<std::string>& robots, const std::string& reason) {
  return answer_of(
      monitor.post("/api/lease", {{"do", deed}, {"robots", robots}, {"reason", reason}}));
}

/// Holds what it has, and waits for what it asked for, until Ctrl-C or until it has lost all.
class Hold {
 public:
  Hold(const MonitorClient& monitor, const std::vector<std::string>& robots)
      : monitor_(monitor), open_(robots.begin(), robots.end()) {}

  int run() {
    while (!open_.empty()) {
      const auto leases = leases_of(monitor_);
      if (!leases) return fail(leases.error().message);
      for (const auto& robot : std::set(open_)) look(robot, leases.value().value(robot, json()));
      if (is_interrupted()) return let_go();
    }
    return galilean::kFailed;
  }

 private:
  void look(const std::string& robot, const json& lease) {
    const bool is_asked = lease.is_object() && lease.value("asked_by_you", false);
    if (is_yours(lease)) return look_at_own(robot, lease);
    if (is_asked) return;
    std::cerr << kCommand << ": " << visible(robot)
              << (held_.contains(robot) ? " is not yours any more; " : " is not given to you; ")
              << (lease.is_object() ? words_of(lease) + " holds it" : "nobody holds it")
              << std::endl;
    open_.erase(robot);
  }

  void look_at_own(const std::string& robot, const json& lease) {
    if (held_.insert(robot).second)
      std::cerr << visible(robot) << " is yours until Ctrl-C." << std::endl;
    const auto asker = name_in(lease, "asker");
    if (asker.empty()) {
      said_.erase(robot);
    } else if (said_.insert(robot).second) {
      std::cerr << asker << " asks for " << visible(robot) << ": give it with 'galilean lease give "
                << "--robot " << visible(robot) << "'." << std::endl;
    }
  }

  bool is_interrupted() {
    pollfd event{termination_.descriptor(), POLLIN, 0};
    ::poll(&event, 1, kLookEach_ms);
    return termination_.asked();
  }

  int let_go() {
    const auto done = change(monitor_, "release", {open_.begin(), open_.end()}, "");
    if (!done) return fail(done.error().message);
    return EXIT_SUCCESS;
  }

  galilean::Termination termination_;
  const MonitorClient& monitor_;
  std::set<std::string> open_, held_, said_;
};

/// Asks for leases, or takes them over, and holds them.
int obtain(const MonitorClient& monitor, const char* deed, const std::vector<std::string>& robots,
           const std::string& reason) {
  Hold hold(monitor, robots);  // first, because a signal must not end it in between
  const auto done = change(monitor, deed, robots, reason);
  if (!done) return fail(done.error().message);
  return hold.run();
}

int answer(const MonitorClient& monitor, const std::vector<std::string>& robots, bool refuses,
           const std::string& reason) {
  const auto done = change(monitor, refuses ? "refuse" : "give", robots, reason);
  return done ? EXIT_SUCCESS : fail(done.error().message);
}

}  // namespace

int main(int argc, char** argv) {
  PushOptions options;
  std::vector<std::string> robots;
  std::string reason;
  bool as_json = false, refuses = false;
  galilean::CommandLine app("Tells who may steer a robot through a monitor, and takes turns.",
                            kCommand);
  app.require_command();
  app.share_options();
  add_monitor_option(app, options);
  const auto robots_of = [&](galilean::CommandLine& command) {
    command.option("--robot", robots, "of these robots").not_empty().required();
  };
  auto listing = app.command("list", "list who holds which robot, and who asks for it");
  listing.flag("--json", as_json, "as JSON");
  auto asking = app.command("ask", "ask the holder, wait for the answer, and hold it until Ctrl-C");
  robots_of(asking);
  asking.option("--reason", reason, "why, as the holder reads it");
  auto giving = app.command("give", "give it to the one who asks you for it");
  robots_of(giving);
  giving.flag("--refuse", refuses, "say that you keep it instead");
  giving.option("--reason", reason, "why, as all operators read it");
  auto taking = app.command("take", "take it over at once, and hold it until Ctrl-C");
  robots_of(taking);
  taking.option("--reason", reason, "why, as all operators read it").required();
  if (const auto code = app.parse(argc, argv)) return *code;
  const auto monitor = MonitorClient::at(options.monitor, options.token_file, options.trust);
  if (!monitor) return fail(monitor.error().message);
  if (listing.chosen()) return list(monitor.value(), as_json);
  if (giving.chosen()) return answer(monitor.value(), robots, refuses, reason);
  return obtain(monitor.value(), asking.chosen() ? "ask" : "take", robots, reason);
}
