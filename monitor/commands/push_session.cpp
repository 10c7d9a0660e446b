// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/push_session.h"

#include <poll.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/plural.h"
#include "core/termination.h"
#include "core/visible_text.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;

void print_diagnostic(const json& diagnostic, std::ostream& out) {
  out << visible(diagnostic.value("file", "")) << ':' << diagnostic.value("line", 0) << ':'
      << diagnostic.value("column", 0) << ": " << visible(diagnostic.value("severity", "")) << ": "
      << visible(diagnostic.value("message", "")) << '\n';
  if (const auto hint = diagnostic.value("hint", ""); !hint.empty())
    out << "  hint: " << visible(hint) << '\n';
}

std::optional<PushState> state_of(const json& push) {
  return push_state_of(push.value("state", ""));
}

/// Prints the steps that changed since the last call.
class StepPrinter {
 public:
  void print(const json& push) {
    for (const auto& step : push.value("steps", json::array())) {
      const auto name = step.value("name", ""), word = step.value("state", "");
      const auto line =
          word + (step.value("detail", "").empty() ? "" : "  ") + step.value("detail", "");
      const auto state = step_state_of(word);
      const bool is_idle = state == StepState::kWaiting || state == StepState::kLeftOut;
      if (is_idle || said_[name] == line) continue;
      said_[name] = line;
      std::cout << std::left << std::setw(8) << visible(name) << visible(line) << std::endl;
    }
  }

 private:
  std::map<std::string, std::string> said_;
};

/// One push through a monitor, from the order to the end.
class PushSession {
 public:
  PushSession(const MonitorClient& monitor, std::string command, const PushOptions& options)
      : monitor_(monitor), command_(std::move(command)), options_(options) {}

  int push(const std::vector<bhdl::SourceFile>& files) {
    const auto request = push_request(files, options_);
    const auto id = request.value("id", "");
    const auto answer = ask_until_answered([&] { return monitor_.post("/api/push", request); },
                                           [this] { return waits_for_answer(); });
    if (!answer)
      return answer.error().was_sent ? tell_unknown(id, answer.error())
                                     : fail(answer.error().message);
    if (!answer.value().ok()) {
      let_go();
      return tell_refusal(answer.value());
    }
    json push = answer.value().json;
    for (show(push); state_of(push) == PushState::kRunning; show(push)) {
      if (is_interrupted()) cancel(push.value("id", ""));
      waited_since_.reset();
      const auto now =
          ask_until_answered([&] { return monitor_.get("/api/pushes/" + push.value("id", "")); },
                             [this] { return waits_for_answer(); }, true);
      if (!now) return tell_unknown(push.value("id", ""), now.error());
      if (!now.value().ok()) return fail(now.value().detail());
      push = now.value().json;
    }
    let_go();
    return tell_end(push);
  }

 private:
  int fail(const std::string& why) const {
    std::cerr << command_ << ": " << why << std::endl;
    return kFailed;
  }

  int tell_unknown(const std::string& id, const Unanswered& why) const {
    return fail(why.message + "; whether the program was pushed is not known: look for push " + id +
                " with 'galilean programs list --json' once a monitor answers");
  }

  /// Waits before a request is repeated. Returns false if its answer is not to be waited for any
  /// more.
  bool waits_for_answer() {
    constexpr int kAskAgainEach_ms = 500;
    const Time now = clock_.now();
    if (!waited_since_) waited_since_ = now;
    if (now - *waited_since_ > kAskAgainFor) return false;
    pollfd event{termination_.descriptor(), POLLIN, 0};
    return ::poll(&event, 1, kAskAgainEach_ms) == 0;
  }

  /// Ends the leases that this command took, so that the next who steers need not ask.
  void let_go() const { (void)monitor_.post("/api/lease", {{"do", "release"}}); }

  void show(const json& push) {
    if (!options_.json) steps_.print(push);
  }

  /// Waits 0.1 s, or less if Ctrl-C is pressed. Returns true once, after Ctrl-C was pressed.
  bool is_interrupted() {
    constexpr int kLookEach_ms = 100;
    if (cancelled_) return ::poll(nullptr, 0, kLookEach_ms) != 0;
    pollfd event{termination_.descriptor(), POLLIN, 0};
    ::poll(&event, 1, kLookEach_ms);
    return cancelled_ = termination_.asked();
  }

  void cancel(const std::string& id) {
    const auto answer =
        monitor_.post("/api/pushes/" + id + "/cancel", {{"author", options_.author}});
    if (!answer)
      fail(answer.error().message);
    else if (!answer.value().ok())
      fail(answer.value().detail());
  }

  int tell_refusal(const MonitorAnswer& answer) const {
    const auto diagnostics = answer.json.value("diagnostics", json::array());
    if (options_.json) {
      auto told = answer.json;
      told["ok"] = false;
      std::cout << json_text(told) << std::endl;
    } else {
      for (const auto& diagnostic : diagnostics) print_diagnostic(diagnostic, std::cerr);
      std::cerr << command_ << ": " << answer.detail() << std::endl;
      if (answer.json.contains("leases"))
        std::cerr << "  hint: 'galilean lease ask --robot NAME' asks for it, 'galilean lease take' "
                     "takes it over\n";
    }
    return kFailed;
  }

  int tell_end(json push) const {
    const auto state = state_of(push);
    const bool is_done = state == PushState::kDone || state == PushState::kToldLater;
    if (options_.json) {
      push["ok"] = is_done;
      std::cout << json_text(push) << std::endl;
    } else {
      for (const auto& reply : push.value("replies", json::array())) print_reply(reply);
      tell_notes(push);
    }
    return is_done ? EXIT_SUCCESS : kFailed;
  }

  /// Prints what the steps and the replies do not tell.
  void tell_notes(const json& push) const {
    if (state_of(push) == PushState::kInterrupted)
      std::cerr
          << command_
          << ": the push was interrupted, because its monitor ended; 'galilean programs list' "
             "tells it as confirmed once all its robots have told that they run it"
          << std::endl;
    if (const auto why = push.value("not_kept", ""); !why.empty())
      std::cerr << command_
                << ": warning: the history does not hold all of this yet: " << visible(why)
                << std::endl;
  }

  Termination termination_;
  SteadyClock clock_;
  std::optional<Time> waited_since_;  ///< since when an answer is asked for again
  const MonitorClient& monitor_;
  std::string command_;
  PushOptions options_;
  StepPrinter steps_;
  bool cancelled_ = false;
};

}  // namespace

nlohmann::json push_request(const std::vector<bhdl::SourceFile>& files,
                            const PushOptions& options) {
  json request{
      {"id", new_id()},           {"files", to_json(files)},      {"targets", options.robots},
      {"author", options.author}, {"replaces", options.replaces}, {"canary", options.canary}};
  if (options.tries || options.tries_only)
    request["try"] = {{"only", options.tries_only}, {"even_if_worse", options.even_if_worse}};
  if (options.probation_s) request["probation_s"] = *options.probation_s;
  return request;
}

Result<MonitorAnswer, Unanswered> ask_until_answered(
    const std::function<Result<MonitorAnswer, Unanswered>()>& ask,
    const std::function<bool()>& pause, bool was_sent) {
  constexpr int kCannotNow = 503;
  for (;;) {
    auto answer = ask();
    // A monitor that cannot look the first request up says nothing of it.
    if (answer && !(was_sent && answer.value().status == kCannotNow)) return answer;
    if (!answer) was_sent = was_sent || answer.error().was_sent;
    if (was_sent && pause()) continue;
    if (answer) return Unanswered{{answer.value().detail()}, was_sent};
    return Unanswered{{answer.error().message}, was_sent};
  }
}

void print_reply(const json& reply) {
  const auto word = reply.value("status", "");
  const auto status = reply_status_of(word);
  std::cout << std::left << std::setw(14) << visible(reply.value("robot", "")) << std::setw(12)
            << visible(word);
  if (status != ReplyStatus::kNoAnswer)
    std::cout << std::fixed << std::setprecision(1) << reply.value("latency_ms", 0.0) << " ms";
  if (status == ReplyStatus::kRunning)
    std::cout << "  kept "
              << plural(reply.value("kept_variables", json::array()).size(), "variable")
              << ", swapped in a tick of " << reply.value("swap_tick_us", 0.0) << " us";
  if (const auto message = reply.value("message", ""); !message.empty())
    std::cout << "  " << visible(message);
  std::cout << '\n';
  for (const auto& diagnostic : reply.value("diagnostics", json::array())) {
    std::cout << "  ";
    print_diagnostic(diagnostic, std::cout);
  }
}

int push_through(const MonitorClient& monitor, const std::string& command,
                 const std::vector<bhdl::SourceFile>& files, const PushOptions& options) {
  return PushSession(monitor, command, options).push(files);
}

}  // namespace galilean::monitor
