// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cassert>
#include <memory>
#include <utility>

#include "robot/executive/running_program.h"
#include "robot/executive/spsc_ring.h"

namespace galilean::robot {

/// Exchanges programs between the thread that builds them and the control loop. Neither thread
/// waits. A new program waits in one place. Replaced programs go back to the builder, which
/// destroys them.
class Exchange {
 public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  ~Exchange() { delete waiting_.load(); }

  /// Builder. Call `collect` before each `offer`.
  [[nodiscard]] bool waiting() const noexcept { return waiting_.load() != nullptr; }
  /// Builder: lets a program wait for the control loop. Requires: !waiting().
  void offer(std::unique_ptr<RunningProgram> program) noexcept {
    assert(!waiting());
    waiting_.store(program.release(), std::memory_order_release);
  }
  /// Builder: destroys the programs that came back.
  void collect() noexcept {
    while (retired_.pop()) {
    }
  }

  /// Control: takes the program that waits. Returns null if none does.
  [[nodiscard]] std::unique_ptr<RunningProgram> take() noexcept {
    return std::unique_ptr<RunningProgram>(waiting_.exchange(nullptr, std::memory_order_acq_rel));
  }
  /// Control: hands a replaced program back to the builder.
  void retire(std::unique_ptr<RunningProgram> program) noexcept {
    [[maybe_unused]] const bool taken = retired_.push(std::move(program));
    assert(taken);
  }

 private:
  /// Between two offers, and so between two collections, at most three programs are replaced.
  static constexpr std::size_t kMostReplaced = 4;

  std::atomic<RunningProgram*> waiting_{nullptr};
  SpscRing<std::unique_ptr<RunningProgram>, kMostReplaced> retired_;
};

}  // namespace galilean::robot
