// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/push/push_worker.h"

#include "core/failure.h"
#include "core/visible_text.h"

namespace galilean::monitor::top {
namespace {

using nlohmann::json;
using Stage = PushReport::Stage;

constexpr auto kAskForRightsEach = std::chrono::seconds(2);
constexpr auto kLookEach = std::chrono::milliseconds(200);

std::string name_in(const json& lease, const char* member) {
  const auto found = lease.find(member);
  return found == lease.end() || !found->is_object() ? "" : visible(found->value("name", ""));
}

std::map<std::string, ToldLease> leases_in(const json& status) {
  std::map<std::string, ToldLease> leases;
  for (const auto& robot : status.value("robots", json::array())) {
    const auto lease = robot.value("lease", json());
    if (!lease.is_object()) continue;
    leases[robot.value("name", "")] = {.holder = name_in(lease, "holder"),
                                       .asker = name_in(lease, "asker"),
                                       .is_yours = lease.value("yours", false),
                                       .is_asked_by_you = lease.value("asked_by_you", false)};
  }
  return leases;
}

}  // namespace

PushWorker::PushWorker(PushOptions options, AskMonitor ask, Duration ask_again_for)
    : options_(std::move(options)), ask_(std::move(ask)), ask_again_for_(ask_again_for) {}

std::string PushWorker::hindrance() const {
  const std::lock_guard lock(mutex_);
  return hindrance_;
}

PushReport PushWorker::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

void PushWorker::tell(PushReport report) {
  const std::lock_guard lock(mutex_);
  report_ = std::move(report);
}

void PushWorker::check(const PushWish& wish) {
  const std::lock_guard lock(mutex_);
  checked_.reset();
  report_ = {Stage::kChecking, "Push", {{"The monitor checks the program."}}};
  add([this, wish, number = ++newest_check_] { check_now(wish, number); });
}

void PushWorker::push(bool with_canary) {
  const std::lock_guard lock(mutex_);
  if (checked_) begin_push(*std::exchange(checked_, std::nullopt), with_canary);
}

void PushWorker::push_at_once(const PushWish& wish) {
  const std::lock_guard lock(mutex_);
  if (report_.stage == Stage::kPushing) return;
  ++newest_check_;  // A check that still runs ends for nobody.
  checked_.reset();
  begin_push({wish, wish.files}, false);
}

/// Requires: mutex_ is locked.
void PushWorker::begin_push(Checked checked, bool with_canary) {
  report_ = {Stage::kPushing, "Push", {{"The push was ordered."}}};
  cancelled_ = false;
  add([this, with_canary, checked = std::move(checked)] { push_now(checked, with_canary); });
}

void PushWorker::list() {
  const std::lock_guard lock(mutex_);
  pushes_.trouble.clear();
  add([this] { list_now(); });
}

PastPushes PushWorker::pushes() const {
  const std::lock_guard lock(mutex_);
  return pushes_;
}

std::optional<ToldLease> PushWorker::lease(const std::string& robot) const {
  const std::lock_guard lock(mutex_);
  const auto found = leases_.find(robot);
  if (found == leases_.end()) return {};
  return found->second;
}

void PushWorker::change_lease(const std::string& deed, const std::string& robot,
                              const std::string& reason) {
  const std::lock_guard lock(mutex_);
  add([this, body = json{{"do", deed}, {"robots", {robot}}, {"reason", reason}}] {
    std::string refusal;
    const auto done = attempt([&] {
      const auto answer = ask_("/api/lease", body);
      if (!answer)
        refusal = answer.error().message;
      else if (!answer.value().ok())
        refusal = answer.value().detail();
    });
    if (!done) refusal = done.error().message;
    const std::lock_guard answered(mutex_);
    lease_refusal_ = std::move(refusal);
  });
}

std::string PushWorker::take_lease_refusal() {
  const std::lock_guard lock(mutex_);
  return std::exchange(lease_refusal_, {});
}

/// Requires: mutex_ is locked.
void PushWorker::add(Job job) {
  jobs_.push_back(std::move(job));
  woken_.notify_all();
}

void PushWorker::cancel() {
  const std::lock_guard lock(mutex_);
  if (report_.stage == Stage::kPushing) {
    cancelled_ = true;
    return woken_.notify_all();
  }
  ++newest_check_;  // A check that still runs ends for nobody.
  checked_.reset();
  report_ = {};
}

void PushWorker::end() {
  const std::lock_guard lock(mutex_);
  ends_ = true;
  woken_.notify_all();
}

bool PushWorker::wait_for_end(std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  return woken_.wait_for(lock, most, [this] { return ended_; });
}

void PushWorker::run() {
  for (;;) {
    if (const auto asked = attempt([this] { ask_for_rights(); }); !asked) {
      const std::lock_guard lock(mutex_);
      hindrance_ = asked.error().message;
    }
    Job job;
    {
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, kAskForRightsEach, [this] { return !jobs_.empty() || ends_; });
      if (ends_) break;
      if (jobs_.empty()) continue;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
  }
  const std::lock_guard lock(mutex_);
  ended_ = true;
  woken_.notify_all();
}

Result<json> PushWorker::get(const std::string& path) const {
  const auto answer = ask_(path, {});
  if (!answer) return Error{answer.error().message};
  if (!answer.value().ok()) return Error{answer.value().detail()};
  return answer.value().json;
}

void PushWorker::ask_for_rights() {
  const auto status = get("/api/status");
  std::string hindrance;
  if (!status)
    hindrance = status.error().message;
  else if (!status.value().value("may_steer", false))
    hindrance = "the monitor's operator token is needed to push; name its file with --token-file";
  auto leases = status ? leases_in(status.value()) : std::map<std::string, ToldLease>();
  const std::lock_guard lock(mutex_);
  hindrance_ = std::move(hindrance);
  leases_ = std::move(leases);
}

bool PushWorker::is_outdated(std::uint64_t check) const {
  const std::lock_guard lock(mutex_);
  return check != newest_check_;
}

bool PushWorker::pause() {
  std::unique_lock lock(mutex_);
  woken_.wait_for(lock, kLookEach, [this] { return ends_ || cancelled_; });
  return !ends_;
}

bool PushWorker::take_cancel() {
  const std::lock_guard lock(mutex_);
  return std::exchange(cancelled_, false);
}

}  // namespace galilean::monitor::top
