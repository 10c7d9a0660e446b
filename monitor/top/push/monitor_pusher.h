// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <thread>

#include "monitor/top/push/push_worker.h"

namespace galilean::monitor::top {

/// Pushes programs through a monitor, as `galilean swap` does, in a thread of its own. It asks the
/// monitor from time to time whether this user may push.
class MonitorPusher : public Pusher {
 public:
  /// `options` names the monitor, the token and the author.
  explicit MonitorPusher(PushOptions options);
  /// As above, with another way to the monitor, and another time for which an answer that was lost
  /// is asked for again. `ask` may be called after the destructor.
  MonitorPusher(PushOptions options, AskMonitor ask, Duration ask_again_for);
  /// Waits only a moment: a request that nobody answers goes on without this.
  ~MonitorPusher() override;

  [[nodiscard]] std::string hindrance() const override { return worker_->hindrance(); }
  void check(const PushWish& wish) override { worker_->check(wish); }
  void push(bool with_canary) override { worker_->push(with_canary); }
  void push_at_once(const PushWish& wish) override { worker_->push_at_once(wish); }
  void cancel() override { worker_->cancel(); }
  [[nodiscard]] PushReport report() const override { return worker_->report(); }
  void list() override { worker_->list(); }
  [[nodiscard]] PastPushes pushes() const override { return worker_->pushes(); }
  [[nodiscard]] std::optional<ToldLease> lease(const std::string& robot) const override {
    return worker_->lease(robot);
  }
  void change_lease(const std::string& deed, const std::string& robot,
                    const std::string& reason) override {
    worker_->change_lease(deed, robot, reason);
  }
  [[nodiscard]] std::string take_lease_refusal() override { return worker_->take_lease_refusal(); }

 private:
  std::shared_ptr<PushWorker> worker_;  ///< shared with the thread, which may outlive this
  std::thread thread_;
};

}  // namespace galilean::monitor::top
