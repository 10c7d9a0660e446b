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
#include "robot/telemetry/targets.h"

namespace galilean::robot {

/// Hands each message of a topic that is meant for this robot to `obey`, one at a time, in a thread
/// of DDS. Whoever sent it is obeyed, because anybody who sees a robot go wrong must be able to
/// stop it.
template <class M>
class OrderReader {
 public:
  using Obey = std::function<void(const M&)>;

  /// Errors: throws std::runtime_error if DDS refuses the topic.
  OrderReader(wire::Participant& participant, const std::string& topic, std::string robot,
              Obey obey, const Worker::Report& report)
      : robot_(std::move(robot)), obey_(std::move(obey)), reader_(participant, topic, M::kRosType) {
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
      if (msg::decode_cdr(received.cdr, message) && is_meant(robot_, message.targets))
        obey_(message);
    });
  }

  std::string robot_;
  Obey obey_;
  std::mutex taking_;
  wire::Reader reader_;
};

}  // namespace galilean::robot
