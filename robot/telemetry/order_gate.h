// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "core/clock.h"
#include "core/orders/order_check.h"
#include "core/orders/order_memory.h"
#include "core/result.h"
#include "core/signing/trusted_keys.h"
#include "core/wire/reader.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

/// Lets orders through that are signed by a key that this robot trusts, or all of them where the
/// robot was given no keys. It counts those that it refuses, and tells each of their senders once
/// among the robot's problems. Any thread but the control loop may call it.
class OrderGate {
 public:
  using Times = std::function<CheckTimes()>;
  /// Where an order came from.
  struct Origin {
    std::uint64_t writer = 0;  ///< wire::Received::writer
    /// Asks DDS who that is. It is called in the thread of on_round().
    std::function<std::optional<wire::Sender>()> sender;
  };

  /// A problem ends when its sender had no order refused for so long.
  static constexpr Duration kForgetAfter = std::chrono::minutes(5);
  static constexpr std::size_t kMostSenders = 16;  ///< further ones are told as one
  static constexpr std::size_t kMostWaiting = 64;  ///< further ones are counted without a name

  /// Returns the times of this machine, whose uptime begins now.
  [[nodiscard]] static Times machine_times();

  /// Requires: `clock` and `problems` outlive this.
  OrderGate(std::optional<TrustedKeys> trust, const Clock& clock, ThreadProblems& problems,
            Times times = machine_times(), OrderMemory memory = {});

  /// `place` is the order_place() at which it came, and `what` names it, as order_words.h does.
  /// Errors: the order is not to be carried out.
  template <class M>
  [[nodiscard]] Result<void, OrderRefusal> admit(const M& order, const std::string& place,
                                                 const std::string& what, Origin origin) {
    if (!check_) return {};
    const std::lock_guard lock(mutex_);
    auto accepted = check_->accept(order, place, times_());
    if (!accepted) note(what + " by ", accepted.error().why, std::move(origin));
    if (accepted && memory_.keep) memory_.keep(check_->numbers());
    return accepted;
  }

  /// Tells what was refused since the last call, and ends problems that are old. Call it often, in
  /// a thread that is none of DDS. Requires: those who asked to be admitted still live.
  void on_round();

 private:
  struct Refused {
    std::string what, why;
    Origin origin;
  };
  struct Tally {
    std::uint64_t refused = 0;
    Time last{};
  };

  void note(std::string what, std::string why, Origin origin);
  void tell(const Refused& refused);
  void tell_unnamed(std::uint64_t number);
  [[nodiscard]] std::string name_of(const Origin& origin);
  void count(const std::string& sender, const std::string& sentence, std::uint64_t more);
  void forget_old();

  std::optional<OrderCheck> check_;
  const Clock& clock_;
  ThreadProblems& problems_;
  const Times times_;
  const OrderMemory memory_;
  std::mutex mutex_;  // of check_, waiting_ and unnamed_
  std::deque<Refused> waiting_;
  std::uint64_t unnamed_ = 0;
  // The thread of on_round() alone uses these.
  std::map<std::uint64_t, std::string> names_;  ///< of senders, by their writers
  std::map<std::string, Tally> tallies_;        ///< by senders
};

}  // namespace galilean::robot
