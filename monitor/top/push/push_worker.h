// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/source/diagnostic.h"
#include "core/clock.h"
#include "monitor/commands/monitor_client.h"
#include "monitor/commands/push_options.h"
#include "monitor/top/push/pusher.h"

namespace galilean::monitor::top {

/// Sends a request to the monitor: GET where there is no body, else POST. Waits for the answer.
using AskMonitor = std::function<Result<MonitorAnswer, Unanswered>(
    const std::string& path, const std::optional<nlohmann::json>& body)>;

/// Checks and pushes programs through a monitor in the thread that calls `run`. Any thread may call
/// the other functions, and none of them waits for the monitor.
class PushWorker {
 public:
  /// An answer that was lost is asked for again for so long.
  PushWorker(PushOptions options, AskMonitor ask, Duration ask_again_for);

  /// Works until `end` is called.
  void run();
  /// Lets `run` return once its present request is answered.
  void end();
  /// Waits until `run` has returned. Returns false if it has not within `most`.
  [[nodiscard]] bool wait_for_end(std::chrono::milliseconds most);

  // As Pusher's.
  [[nodiscard]] std::string hindrance() const;
  void check(const PushWish& wish);
  void push(bool with_canary);
  void push_at_once(const PushWish& wish);
  void cancel();
  [[nodiscard]] PushReport report() const;
  void list();
  [[nodiscard]] PastPushes pushes() const;
  [[nodiscard]] std::optional<ToldLease> lease(const std::string& robot) const;
  void change_lease(const std::string& deed, const std::string& robot, const std::string& reason);
  [[nodiscard]] std::string take_lease_refusal();

 private:
  using Job = std::function<void()>;
  /// A program that passed its check.
  struct Checked {
    PushWish wish;
    std::vector<bhdl::SourceFile> files;
  };
  /// Why there is no program to push.
  struct NoFiles {
    std::string why;
    std::vector<bhdl::Diagnostic> diagnostics;  ///< of files that cannot be read
  };

  void add(Job job);
  /// Asks whether this user may steer, and who steers which robot. It is a word, which keeps what
  /// this user holds.
  void ask_for_rights();
  void list_now();
  void check_now(const PushWish& wish, std::uint64_t number);
  void finish_check(std::uint64_t number, PushReport report, std::optional<Checked> checked);
  void begin_push(Checked checked, bool with_canary);
  void push_now(const Checked& checked, bool with_canary);
  void follow(const nlohmann::json& request);
  /// Asks until there is an answer, as ask_until_answered does.
  [[nodiscard]] Result<MonitorAnswer, Unanswered> ask_again(
      const std::string& path, const std::optional<nlohmann::json>& body, bool was_sent);
  /// Returns whether another check was ordered, or this one was cancelled.
  [[nodiscard]] bool is_outdated(std::uint64_t check) const;
  /// Waits until it is time to ask for the push's state again. Returns false at the end.
  [[nodiscard]] bool pause();
  /// Returns true once after the push was cancelled.
  [[nodiscard]] bool take_cancel();
  /// Returns the program with all that it includes.
  [[nodiscard]] Result<std::vector<bhdl::SourceFile>, NoFiles> files_of(const PushWish& wish) const;
  [[nodiscard]] Result<std::vector<bhdl::SourceFile>> pushed_files(const PushWish& wish) const;
  [[nodiscard]] Result<nlohmann::json> get(const std::string& path) const;
  void tell(PushReport report);

  const PushOptions options_;
  const AskMonitor ask_;
  const Duration ask_again_for_;
  const SteadyClock clock_;

  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable woken_;
  std::deque<Job> jobs_;
  bool cancelled_ = false;
  bool ends_ = false, ended_ = false;
  std::string hindrance_ = "the monitor has not answered yet";
  PushReport report_;
  PastPushes pushes_;
  std::map<std::string, ToldLease> leases_;  ///< by robot
  std::string lease_refusal_;
  std::uint64_t newest_check_ = 0;  ///< only the answer of this check counts
  std::optional<Checked> checked_;
};

}  // namespace galilean::monitor::top
