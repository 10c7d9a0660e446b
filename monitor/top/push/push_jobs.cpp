// SPDX-License-Identifier: BSD-3-Clause
// What the push worker does, one job after another.
#include <cstdlib>

#include "bhdl/check.h"
#include "core/failure.h"
#include "monitor/commands/push_session.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/words.h"
#include "monitor/top/push/push_words.h"
#include "monitor/top/push/push_worker.h"

namespace galilean::monitor::top {
namespace {

using nlohmann::json;
using Files = std::vector<bhdl::SourceFile>;
using Stage = PushReport::Stage;

/// Returns the path with the home folder in place of "~".
std::string with_home(const std::string& path) {
  const char* home = std::getenv("HOME");
  return home && path.starts_with("~/") ? home + path.substr(1) : path;
}

/// Returns whether each robot that answered took the program. One that is away says nothing of it.
bool was_taken(const json& push) {
  if (push_state_of(push.value("state", "")) == PushState::kDone) return true;
  bool any = false;
  for (const auto& reply : push.value("replies", json::array())) {
    const auto status = reply_status_of(reply.value("status", ""));
    if (status == ReplyStatus::kNoAnswer) continue;
    if (!status || !runs(*status)) return false;
    any = true;
  }
  return any;
}

/// Returns the newest push that was taken and brought another program than the one that runs.
std::string last_good_hash(const json& pushes, const std::string& runs_hash) {
  for (const auto& push : pushes.value("pushes", json::array())) {
    const auto hash = push.value("hash", "");
    if (hash != runs_hash && !hash.empty() && was_taken(push)) return hash;
  }
  return {};
}

}  // namespace

Result<Files, PushWorker::NoFiles> PushWorker::files_of(const PushWish& wish) const {
  if (!wish.file.empty()) {
    auto files = bhdl::read_program(with_home(wish.file));
    if (!files) return NoFiles{"the program cannot be read", files.error()};
    return std::move(files).value();
  }
  auto files = pushed_files(wish);
  if (!files) return NoFiles{files.error().message, {}};
  return std::move(files).value();
}

Result<Files> PushWorker::pushed_files(const PushWish& wish) const {
  auto hash = wish.hash;
  if (hash.empty()) {
    const auto pushes = get("/api/pushes");
    if (!pushes) return pushes.error();
    hash = last_good_hash(pushes.value(), wish.runs_hash);
  }
  if (hash.empty()) return Error{"the monitor knows no other program that was pushed"};
  const auto pushed = get("/api/pushed/" + hash);
  if (!pushed) return pushed.error();
  return files_from_json(pushed.value().value("files", json::array()));
}

void PushWorker::list_now() {
  PastPushes list;
  const auto done = attempt([&] {
    const auto answer = get("/api/pushes");
    list = answer ? PastPushes{true, "", past_pushes(answer.value())}
                  : PastPushes{false, answer.error().message, {}};
  });
  if (!done) list = {false, done.error().message, {}};
  const std::lock_guard lock(mutex_);
  pushes_ = std::move(list);
}

void PushWorker::finish_check(std::uint64_t number, PushReport report,
                              std::optional<Checked> checked) {
  const std::lock_guard lock(mutex_);
  if (number != newest_check_) return;
  report_ = std::move(report);
  checked_ = std::move(checked);
}

void PushWorker::check_now(const PushWish& wish, std::uint64_t number) {
  if (is_outdated(number)) return;
  const auto refuse = [&](const std::string& why) {
    finish_check(number, report_of_refusal({}, why), {});
  };
  const auto done = attempt([&] {
    auto files = files_of(wish);
    if (!files)
      return finish_check(
          number,
          report_of_refusal({{"diagnostics", files.error().diagnostics}}, files.error().why), {});
    json request{{"files", to_json(files.value())}};
    if (wish.robots.size() == 1) request["robot"] = wish.robots[0];
    if (!wish.runs.empty()) request["against"] = to_json(wish.runs);
    const auto answer = ask_("/api/check", request);
    if (!answer) return refuse(answer.error().message);
    if (!answer.value().ok()) return refuse(answer.value().detail());
    auto report = report_of_check(answer.value().json, files.value()[0].path);
    finish_check(number, std::move(report), Checked{wish, std::move(files).value()});
  });
  if (!done) refuse(done.error().message);
}

void PushWorker::push_now(const Checked& checked, bool with_canary) {
  if (take_cancel()) return tell(report_of_refusal({}, "it was cancelled before it was sent"));
  PushOptions options = options_;
  options.robots = checked.wish.robots;
  options.replaces = checked.wish.replaces;
  if (!checked.wish.reason.empty()) options.author += " (" + checked.wish.reason + ")";
  if (with_canary) options.canary = checked.wish.canary;
  const auto done = attempt([&] { follow(push_request(checked.files, options)); });
  if (!done) tell(report_of_silence(report(), done.error().message));
}

Result<MonitorAnswer, Unanswered> PushWorker::ask_again(const std::string& path,
                                                        const std::optional<json>& body,
                                                        bool was_sent) {
  std::optional<Time> since;
  return ask_until_answered([&] { return ask_(path, body); },
                            [&] {
                              const Time now = clock_.now();
                              if (!since) since = now;
                              return now - *since < ask_again_for_ && pause();
                            },
                            was_sent);
}

void PushWorker::follow(const json& request) {
  auto answer = ask_again("/api/push", request, false);
  if (!answer)
    return tell(answer.error().was_sent ? report_of_silence(report(), answer.error().message)
                                        : report_of_refusal({}, answer.error().message));
  if (!answer.value().ok())
    return tell(report_of_refusal(answer.value().json, answer.value().detail()));
  const auto path = "/api/pushes/" + answer.value().json.value("id", "");
  for (;;) {
    tell(report_of_push(answer.value().json));
    if (report().stage != Stage::kPushing || !pause()) return;
    if (take_cancel()) static_cast<void>(ask_(path + "/cancel", json{{"author", options_.author}}));
    answer = ask_again(path, {}, true);
    if (!answer) return tell(report_of_silence(report(), answer.error().message));
    if (!answer.value().ok()) return tell(report_of_silence(report(), answer.value().detail()));
  }
}

}  // namespace galilean::monitor::top
