// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/wire/bounds.h"
#include "core/wire/entity.h"

namespace galilean::wire {

class Participant;
class Refusals;
struct EndpointQos;
struct UntypedTopic;

/// One message as it was received. It is valid during the callback only.
struct Received {
  std::span<const std::uint8_t> cdr;  ///< with its four-byte header
  std::int64_t sent_ns;               ///< by its writer's clock, since the Unix epoch
  std::uint64_t writer;               ///< for Reader::sender; EndpointInfo::handle
  /// The writer's number of the message, from 1, of which none is used twice; 0: unknown, as it is
  /// to readers that are neither of an untyped topic nor Numbered.
  std::uint64_t sequence = 0;
  /// The robot that the message says it is of. It is empty if it names none, and on untyped topics.
  std::string_view robot = {};
};

/// A process that sends, as discovery knows it. It announces its name to the whole domain: that is
/// not a field of the message, and without DDS security nothing proves that it is true.
struct Sender {
  std::string name;  ///< with which it joined the domain
  std::string
      address;  ///< where it is heard, such as "192.168.1.7"; empty: in this process, or unknown

  bool operator==(const Sender&) const = default;
};

/// Asks a reader for the numbers that writers give to their messages.
struct Numbered {};

/// Receives the messages of one topic as bytes. msg::decode_cdr turns them into structs. A topic
/// that DDS Security does not permit to read is left out, and nothing comes.
///
/// This is the one door for messages: `take` hands none over that is outside of its type's bounds
/// (core/wire/idl/*.bounds). The participant's Refusals count those. The bytes of untyped topics
/// are handed over as they are, for recorders and tools that show what was sent.
class Reader {
 public:
  /// `depth` is how many messages of each writer are kept between two calls of `take`. With 0 it is
  /// what the type's delivery says, which for a state is the newest alone.
  Reader(Participant& participant, const std::string& topic, const std::string& ros_type,
         int depth = 0);
  /// Receives the messages of a type that this program need not know. `asked` is what the reader
  /// asks of its writers. It keeps `depth` messages between two calls of `take`. Errors: throws
  /// std::runtime_error if Cyclone refuses the topic.
  Reader(Participant& participant, const UntypedTopic& topic, const EndpointQos& asked, int depth);
  /// Receives the messages of one of this release's types, and hands each over with its writer's
  /// number of it. Errors: throws std::runtime_error if Cyclone refuses the topic, or if `ros_type`
  /// is not one of the messages.
  Reader(Participant& participant, const std::string& topic, const std::string& ros_type, Numbered);
  ~Reader();
  /// Calls `receive` for each valid message that came since the last call, in the calling thread.
  void take(const std::function<void(const Received&)>& receive);
  /// Does the same, and ends after `most` messages, valid or not, so that a writer that sends
  /// faster than its messages are handled does not hold the caller. Returns whether more may wait.
  [[nodiscard]] bool take_some(std::size_t most,
                               const std::function<void(const Received&)>& receive);
  /// Does the same with all messages, valid or not, for those who only pass the bytes on.
  void take_unchecked(const std::function<void(const Received&)>& receive);
  /// Sets the callback that Cyclone calls, on a thread of its own, when there is a message to take.
  /// Requires: no callback was set before.
  void on_data(std::function<void()> callback);
  /// Returns the number of writers that are matched now.
  [[nodiscard]] int writers() const;
  /// Returns whether this writer is matched now. `writer` is EndpointInfo::handle.
  [[nodiscard]] bool matches(std::uint64_t writer) const;
  /// Returns the writer's process, or nothing if the writer has left or announced no name. `writer`
  /// is Received::writer. Requires: the caller is no callback of on_data(), because this asks DDS.
  [[nodiscard]] std::optional<Sender> sender(std::uint64_t writer) const;
  /// Returns the writer's GUID, hexadecimal, which it keeps as long as it lives; or an empty string
  /// if it has left. `writer` is Received::writer, which is another one when DDS connects the same
  /// writer anew. Requires: as `sender` does.
  [[nodiscard]] std::string guid_of(std::uint64_t writer) const;

 private:
  /// Returns whether the message is within its bounds, and counts it if not. Sets its robot.
  [[nodiscard]] bool admits(Received& received) const;
  /// As take_some, without the bounds.
  [[nodiscard]] bool take_bytes(std::size_t most,
                                const std::function<void(const Received&)>& receive);

  std::string topic_;
  Refusals* refusals_ = nullptr;  ///< of the participant, which outlives this
  Bounds bounds_ = nullptr;       ///< nullptr: the topic is untyped
  Entity untyped_topic_;          // nothing for others, whose topic the participant owns
  Entity entity_;
  std::unique_ptr<std::function<void()>> callback_;
};

}  // namespace galilean::wire
