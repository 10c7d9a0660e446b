// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "monitor/commands/monitor_client.h"
#include "monitor/commands/push_options.h"
#include "monitor/top/pusher.h"

namespace galilean::monitor::top {

/// Pushes programs through a monitor, as `galilean swap` does, in a thread of its own. It asks the
/// monitor from time to time whether this user may push.
class MonitorPusher : public Pusher {
 public:
  /// `options` names the monitor, the token and the author.
  explicit MonitorPusher(PushOptions options);
  ~MonitorPusher() override;

  [[nodiscard]] std::string hindrance() const override;
  void check(const PushWish& wish) override;
  void push(bool with_canary) override;
  void cancel() override;
  [[nodiscard]] PushReport report() const override;

 private:
  using Job = std::function<void(const std::stop_token&)>;

  void order(Job job);
  void run(const std::stop_token& stop);
  void ask_for_rights();
  void check_now(const PushWish& wish);
  void push_now(bool with_canary, const std::stop_token& stop);
  [[nodiscard]] Result<std::vector<bhdl::SourceFile>> files_of(const PushWish& wish);
  [[nodiscard]] Result<nlohmann::json> get(const std::string& path) const;
  void tell(PushReport report);
  void refuse(const std::string& why);

  PushOptions options_;
  PushWish wish_;                        ///< for the thread
  std::vector<bhdl::SourceFile> files_;  ///< what was checked; for the thread

  mutable std::mutex mutex_;
  std::condition_variable_any woken_;
  std::optional<Job> job_;  ///< under `mutex_`
  bool cancelled_ = false;  ///< under `mutex_`
  std::string hindrance_;   ///< under `mutex_`
  PushReport report_;       ///< under `mutex_`
  std::jthread thread_;
};

}  // namespace galilean::monitor::top
