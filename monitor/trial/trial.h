// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "monitor/trial/child_process.h"
#include "monitor/trial/figures.h"

namespace galilean::monitor {

/// The programs to try, and the situation to start from.
struct TrialOrder {
  std::vector<bhdl::SourceFile> next;  ///< the new program, the main file first
  std::vector<bhdl::SourceFile> now;   ///< the program that runs; may be empty
  nlohmann::json situation;            ///< the result of situation_of
  std::string scenario;                ///< the arena: its walls, furniture and rules
  int seeds = 8;
  double duration_s = 120;  ///< simulated time of each run
  /// A run that takes so much longer than its simulated time hangs. Runs in order take a part of
  /// it.
  double patience_s = 30;
};

/// Runs the new program and the program that runs now in simulated contests, which continue from
/// the live team's situation. Both programs get the same seeds, so that they meet the same chances.
/// Each run is a process of `galilean sim --headless`, and two run at a time. The destructor ends
/// the processes, and so does a run that crashes or hangs: the trial fails then, and nothing else
/// does. For use on the io_context's thread.
class Trial {
 public:
  using Done = std::function<void(Result<TrialFigures>)>;

  /// Makes `folder` for its files; the destructor removes it. Calls `done` once, later, unless this
  /// object is destroyed before. Errors that `done` gets: the folder cannot be written, a simulator
  /// cannot be started, fails, does not end in time, or prints no report.
  Trial(boost::asio::io_context& io, std::filesystem::path simulator, std::filesystem::path folder,
        TrialOrder order, Done done);
  ~Trial();
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  [[nodiscard]] std::size_t finished_runs() const noexcept { return finished_; }
  [[nodiscard]] std::size_t all_runs() const noexcept { return all_; }

 private:
  static constexpr std::size_t kAtOnce = 2;
  struct Run {
    bool is_next = false;
    int seed = 1;
    std::unique_ptr<ChildProcess> process = nullptr;
    std::unique_ptr<boost::asio::steady_timer> patience = nullptr;
    /// A late call of the timer finds it gone.
    std::shared_ptr<bool> is_under_way = std::make_shared<bool>(true);
  };

  /// Runs a handler that is called from outside. If it throws, the trial ends with the exception as
  /// the reason.
  template <class Work>
  void attempt(Work work);
  [[nodiscard]] Result<void> write_files() const;
  [[nodiscard]] std::filesystem::path program_file(bool is_next) const;
  [[nodiscard]] std::filesystem::path output(const Run& run, const char* extension) const;
  [[nodiscard]] std::vector<std::string> command(const Run& run) const;
  void begin();
  void start_pending();
  void end_in_time(Run& run);
  void take(const Run& run, int exit_code);
  void fail(std::string why);
  void finish(Result<TrialFigures> result);
  [[nodiscard]] Result<TrialFigures> figures() const;

  boost::asio::io_context& io_;
  std::filesystem::path simulator_, folder_;
  TrialOrder order_;
  Done done_;
  std::deque<Run> waiting_;
  std::list<Run> running_;
  std::vector<nlohmann::json> now_, next_;  ///< the reports of finished runs
  std::size_t finished_ = 0;
  std::size_t all_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< late handlers find it false
};

}  // namespace galilean::monitor
