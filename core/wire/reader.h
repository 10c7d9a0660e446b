// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/wire/entity.h"

namespace galilean::wire {

class Participant;

/// One message as it came: valid during the callback only.
struct Received {
  std::span<const std::uint8_t> cdr;  ///< with its four-byte header
  std::int64_t sent_ns;               ///< by its writer's clock, since the Unix epoch
  std::uint64_t writer;               ///< for Reader::sender
};

/// Takes messages off one topic as bytes; msg::decode_cdr makes structs of them.
class Reader {
 public:
  /// `depth`: messages of each writer kept between two calls of `take`; 0: as the type's delivery
  /// says, which for a state is the newest alone.
  Reader(Participant& participant, const std::string& topic, const std::string& ros_type,
         int depth = 0);
  ~Reader();
  /// Calls `receive` for each message that came since, oldest first, in the calling thread.
  void take(const std::function<void(const Received&)>& receive);
  /// Called on a thread of Cyclone's when there is something to take. Set once.
  void on_data(std::function<void()> callback);
  /// Writers matched now.
  [[nodiscard]] int writers() const;
  /// The name that the process which wrote a message has joined the domain with. It is what that
  /// process announced to everybody, not a field of the message; DDS without its security does not
  /// prove it. Nothing if the writer has left.
  [[nodiscard]] std::optional<std::string> sender(const Received& received) const;

 private:
  Entity entity_;
  std::unique_ptr<std::function<void()>> callback_;
};

}  // namespace galilean::wire
