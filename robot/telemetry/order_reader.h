// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include "core/failure.h"
#include "core/wire/messages.h"
#include "core/wire/reader.h"
#include "core/worker.h"
#include "robot/telemetry/order_gate.h"
#include "robot/telemetry/targets.h"

namespace galilean::robot {

/// Hands each message of a topic that is meant for this robot to `obey`, one at a time, in a thread
/// of DDS, if it is admitted.
template <class M>
class OrderReader {
 public:
  using Obey = std::function<void(const M&)>;
  /// Returns whether to obey. It has told why not.
  using Admit = std::function<bool(const M&, OrderGate::Origin)>;

  /// Without `admit`, whoever sent it is obeyed.
  /// Errors: throws std::runtime_error if DDS refuses the topic.
  OrderReader(wire::Participant& participant, const std::string& topic, std::string robot,
              Admit admit, Obey obey, const Worker::Report& report)
      : robot_(std::move(robot)),
        admit_(std::move(admit)),
        obey_(std::move(obey)),
        reader_(participant, topic, M::kRosType) {
    // A thread of DDS calls this function. An exception from it would end the process.
    const auto take_or_report = [this, report] {
      const auto taken = attempt([&] { take(); });
      static_cast<void>(attempt([&] { report(taken ? "" : taken.error().message); }));
    };
    reader_.on_data(take_or_report);
    take_or_report();
  }

 private:
  void take() {
    const std::lock_guard lock(taking_);
    reader_.take([this](const wire::Received& received) {
      M message;
      if (!msg::decode_cdr(received.cdr, message) || !is_meant(robot_, message.targets)) return;
      if (!admit_ || admit_(message, origin_of(received))) obey_(message);
    });
  }
  [[nodiscard]] OrderGate::Origin origin_of(const wire::Received& received) const {
    const std::uint64_t writer = received.writer;
    return {writer, [this, writer] { return reader_.sender(writer); }};
  }

  std::string robot_;
  Admit admit_;
  Obey obey_;
  std::mutex taking_;
  wire::Reader reader_;
};

}  // namespace galilean::robot
