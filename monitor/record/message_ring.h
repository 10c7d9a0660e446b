// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/endpoints.h"
#include "core/wire/reader.h"

namespace galilean::monitor {

/// Keeps the messages of the last seconds, in bounded memory.
class MessageRing {
 public:
  struct Held {
    std::shared_ptr<const wire::EndpointInfo> writer;
    Time at{};                ///< when it was received
    std::int64_t log_ns = 0;  ///< the same by the wall clock
    std::int64_t sent_ns = 0;
    std::uint64_t sequence = 0;
    std::vector<std::uint8_t> cdr;

    /// It is valid as long as this.
    [[nodiscard]] wire::Received received() const {
      return {cdr, sent_ns, writer->handle, sequence};
    }
  };

  /// Keeps what is not older than `span`, and of that the newest of so many bytes.
  MessageRing(Duration span, std::uint64_t most_bytes) : span_(span), most_bytes_(most_bytes) {}

  void add(const wire::EndpointInfo& writer, const wire::Received& received, Time at,
           std::int64_t log_ns);
  /// Forgets what is too old at `now`, or too much, and calls `take` with each before, the oldest
  /// first. Returns whether something was forgotten for want of memory.
  template <class Take>
  bool forget(Time now, const Take& take) {
    bool too_much = false;
    while (!held_.empty()) {
      const bool old = now - held_.front().at > span_;
      if (!old && bytes_ <= most_bytes_) break;
      too_much = too_much || !old;
      take(held_.front());
      pop();
    }
    return too_much;
  }
  /// Calls `take` with all, the oldest first, and forgets them.
  template <class Take>
  void give(const Take& take) {
    for (; !held_.empty(); pop()) take(held_.front());
  }

  [[nodiscard]] bool empty() const noexcept { return held_.empty(); }
  /// Requires: it is not empty.
  [[nodiscard]] const Held& oldest() const noexcept { return held_.front(); }

 private:
  [[nodiscard]] std::shared_ptr<const wire::EndpointInfo> shared(const wire::EndpointInfo& writer);
  void pop();

  Duration span_;
  std::uint64_t most_bytes_, bytes_ = 0;
  std::deque<Held> held_;
  /// One for all messages of a writer, by its GUID.
  std::map<std::string, std::weak_ptr<const wire::EndpointInfo>> writers_;
};

}  // namespace galilean::monitor
