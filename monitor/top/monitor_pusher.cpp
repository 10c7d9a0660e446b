// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/monitor_pusher.h"

#include <cstdlib>

#include "bhdl/check.h"
#include "core/failure.h"
#include "monitor/commands/push_session.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/words.h"
#include "monitor/top/push_words.h"

namespace galilean::monitor::top {
namespace {

using nlohmann::json;
using Stage = PushReport::Stage;

constexpr auto kAskForRightsEach = std::chrono::seconds(5);
constexpr auto kLookEach = std::chrono::milliseconds(200);

/// Returns the path with the home folder in place of "~".
std::string with_home(const std::string& path) {
  const char* home = std::getenv("HOME");
  return home && path.starts_with("~/") ? home + path.substr(1) : path;
}

/// Returns the newest push that was done and brought another program than the one that runs.
std::string last_good_hash(const json& pushes, const std::string& runs_hash) {
  for (const auto& push : pushes.value("pushes", json::array())) {
    const auto hash = push.value("hash", "");
    if (push_state_of(push.value("state", "")) == PushState::kDone && hash != runs_hash &&
        !hash.empty())
      return hash;
  }
  return {};
}

}  // namespace

MonitorPusher::MonitorPusher(PushOptions options)
    : options_(std::move(options)),
      hindrance_("the monitor has not answered yet"),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

MonitorPusher::~MonitorPusher() = default;

std::string MonitorPusher::hindrance() const {
  const std::lock_guard lock(mutex_);
  return hindrance_;
}

PushReport MonitorPusher::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

void MonitorPusher::tell(PushReport report) {
  const std::lock_guard lock(mutex_);
  report_ = std::move(report);
}

void MonitorPusher::refuse(const std::string& why) {
  tell({Stage::kRefused, "Nothing was pushed", {{why, Style::kAlarm}}});
}

void MonitorPusher::check(const PushWish& wish) {
  tell({Stage::kChecking, "Push", {{"The monitor checks the program."}}});
  order([this, wish](const std::stop_token&) { check_now(wish); });
}

void MonitorPusher::push(bool with_canary) {
  tell({Stage::kPushing, "Push", {{"The push was ordered."}}});
  order([this, with_canary](const std::stop_token& stop) { push_now(with_canary, stop); });
}

void MonitorPusher::cancel() {
  const std::lock_guard lock(mutex_);
  if (report_.stage == Stage::kPushing)
    cancelled_ = true;
  else
    report_ = {};
}

void MonitorPusher::order(Job job) {
  {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
    cancelled_ = false;
  }
  woken_.notify_all();
}

void MonitorPusher::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (const auto asked = attempt([this] { ask_for_rights(); }); !asked) {
      const std::lock_guard lock(mutex_);
      hindrance_ = asked.error().message;
    }
    std::optional<Job> job;
    {
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, stop, kAskForRightsEach, [this] { return job_.has_value(); });
      job.swap(job_);
    }
    if (!job) continue;
    if (const auto done = attempt([&] { (*job)(stop); }); !done) refuse(done.error().message);
  }
}

Result<json> MonitorPusher::get(const std::string& path) const {
  const auto monitor = MonitorClient::at(options_.monitor, options_.token_file);
  if (!monitor) return monitor.error();
  const auto answer = monitor.value().get(path);
  if (!answer) return answer.error();
  if (!answer.value().ok()) return Error{answer.value().detail()};
  return answer.value().json;
}

void MonitorPusher::ask_for_rights() {
  const auto status = get("/api/status");
  std::string hindrance;
  if (!status)
    hindrance = status.error().message;
  else if (!status.value().value("may_steer", false))
    hindrance = "the monitor's operator token is needed to push; name its file with --token-file";
  const std::lock_guard lock(mutex_);
  hindrance_ = std::move(hindrance);
}

Result<std::vector<bhdl::SourceFile>> MonitorPusher::files_of(const PushWish& wish) {
  if (!wish.file.empty()) {
    // This only collects the includes. The monitor checks against the robots' catalogs.
    auto files = bhdl::check_file(with_home(wish.file), Catalog{}).files;
    if (files.empty()) return Error{wish.file + " cannot be read"};
    return files;
  }
  const auto pushes = get("/api/pushes");
  if (!pushes) return pushes.error();
  const auto hash = last_good_hash(pushes.value(), wish.runs_hash);
  if (hash.empty()) return Error{"the monitor knows no other program that was pushed"};
  const auto pushed = get("/api/pushed/" + hash);
  if (!pushed) return pushed.error();
  return files_from_json(pushed.value().value("files", json::array()));
}

void MonitorPusher::check_now(const PushWish& wish) {
  auto files = files_of(wish);
  if (!files) return refuse(files.error().message);
  const auto monitor = MonitorClient::at(options_.monitor, options_.token_file);
  if (!monitor) return refuse(monitor.error().message);
  json request{{"files", to_json(files.value())}};
  if (wish.robots.size() == 1) request["robot"] = wish.robots[0];
  if (!wish.runs.empty()) request["against"] = to_json(wish.runs);
  const auto answer = monitor.value().post("/api/check", request);
  if (!answer) return refuse(answer.error().message);
  if (!answer.value().ok()) return refuse(answer.value().detail());
  wish_ = wish;
  files_ = std::move(files).value();
  tell(report_of_check(answer.value().json, files_[0].path));
}

void MonitorPusher::push_now(bool with_canary, const std::stop_token& stop) {
  PushOptions options = options_;
  options.robots = wish_.robots;
  options.replaces = wish_.robots.size() == 1 ? wish_.runs_hash : "";
  if (with_canary) options.canary = wish_.canary;
  const auto monitor = MonitorClient::at(options_.monitor, options_.token_file);
  if (!monitor) return refuse(monitor.error().message);
  auto answer = monitor.value().post("/api/push", push_request(files_, options));
  bool cancelled = false;
  while (answer && answer.value().ok()) {
    const PushReport report = report_of_push(answer.value().json);
    tell(report);
    if (report.stage != Stage::kPushing || stop.stop_requested()) return;
    const auto path = "/api/pushes/" + answer.value().json.value("id", "");
    std::unique_lock lock(mutex_);
    woken_.wait_for(lock, stop, kLookEach, [] { return false; });
    const bool cancels = cancelled_ && !cancelled;
    lock.unlock();
    if (cancels) {
      cancelled = true;
      static_cast<void>(monitor.value().post(path + "/cancel", {{"author", options_.author}}));
    }
    answer = monitor.value().get(path);
  }
  if (!answer) return refuse(answer.error().message);
  tell(report_of_refusal(answer.value().json, answer.value().detail()));
}

}  // namespace galilean::monitor::top
