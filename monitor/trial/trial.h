// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
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

/// What is to be tried, and from where.
struct TrialOrder {
  std::vector<bhdl::SourceFile> next;  ///< the new program, the main file first
  std::vector<bhdl::SourceFile> now;   ///< the one that runs; none: nothing to compare with
  nlohmann::json situation;            ///< as situation_of gives it
  std::string scenario;                ///< the arena: its walls, furniture and rules
  int seeds = 8;
  double duration_s = 120;  ///< simulated
};

/// Both programs in simulated contests that go on from where the live team is, the same seeds for
/// both, each in a process of `galilean sim --headless`, two at a time. Everything of it ends with
/// this object.
class Trial {
 public:
  using Done = std::function<void(Result<TrialFigures>)>;

  /// `folder`: is made, and removed in the end. `done` is called once, later; never after this
  /// object has gone.
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
  };

  /// Runs a handler that is called from outside. If it throws, the trial ends with the exception as
  /// the reason.
  template <class Work>
  void attempt(Work work);
  [[nodiscard]] Result<void> lay_out() const;
  [[nodiscard]] std::filesystem::path program_file(bool is_next) const;
  [[nodiscard]] std::filesystem::path output(const Run& run, const char* extension) const;
  [[nodiscard]] std::vector<std::string> command(const Run& run) const;
  void begin();
  void start_some();
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
  std::vector<nlohmann::json> now_, next_;  ///< reports
  std::size_t finished_ = 0;
  std::size_t all_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< for words that come late
};

}  // namespace galilean::monitor
