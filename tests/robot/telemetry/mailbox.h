// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"

namespace galilean::robot {

/// The messages that came on one topic, for which a test can wait.
template <class M>
class Mailbox {
 public:
  Mailbox(wire::Participant& participant, const std::string& topic)
      : reader_(participant, topic, M::kRosType, 64) {
    reader_.on_data([this] { take(); });
    take();
  }

  /// Returns the oldest message for which `is_it` is true, and waits for one. Returns nothing if
  /// that takes too long.
  std::optional<M> wait_for(const std::function<bool(const M&)>& is_it) {
    constexpr auto kPatience = std::chrono::seconds(10);
    std::unique_lock lock(mutex_);
    std::optional<M> found;
    wake_.wait_for(lock, kPatience, [&] {
      for (const M& message : messages_)
        if (!found && is_it(message)) found = message;
      return found.has_value();
    });
    return found;
  }
  std::optional<M> wait() {
    return wait_for([](const M&) { return true; });
  }
  [[nodiscard]] std::vector<M> all() {
    const std::lock_guard lock(mutex_);
    return messages_;
  }

 private:
  void take() {
    const std::lock_guard lock(mutex_);
    reader_.take([this](const wire::Received& received) {
      M message;
      if (msg::decode_cdr(received.cdr, message)) messages_.push_back(std::move(message));
    });
    wake_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<M> messages_;
  wire::Reader reader_;
};

}  // namespace galilean::robot
