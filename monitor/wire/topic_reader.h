// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "monitor/wire/definitions.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// A topic on the wire. It has an end at least.
struct FoundTopic {
  std::string dds_topic;
  std::vector<wire::EndpointInfo> ends;  ///< its writers, or its readers while it has no writer
};

/// Receives the messages of a topic, of whatever types, and decodes each by the definition that its
/// writer has. For use by one thread.
class TopicReader {
 public:
  /// Where it learns who writes, and what.
  struct Wire {
    wire::Participant& participant;
    wire::Endpoints& endpoints;
    Definitions& definitions;
  };
  /// A thread of Cyclone calls `on_data` when messages have come. Requires: what `wire` refers to
  /// outlives this. Errors: throws std::runtime_error if Cyclone refuses the topic.
  TopicReader(Wire wire, FoundTopic topic, const std::function<void()>& on_data);

  /// Calls `receive` for each message that came since the last call. Messages of types with keys
  /// have no sequence, because what ends a key has a number, too, and is no message.
  void take(const std::function<void(const wire::Received&)>& receive);
  /// Learns the definitions that the present ends have. It may block.
  /// Errors: there is none of them; the error is a sentence.
  [[nodiscard]] Result<void> prepare();
  /// It may block at the first message of a writer. Requires: `take` is calling `receive` with this
  /// message. Errors: the writer's definition is not to be had, or this is no whole message of it;
  /// the error is a sentence.
  [[nodiscard]] Result<MessageTree> decode(const wire::Received& received);
  /// Returns what users should know of definitions that were learned since the last call, in
  /// sentences.
  [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  using Decoder = std::shared_ptr<const MessageDecoder>;
  struct TypeReader {
    std::string dds_type;
    bool keyed = false;
    std::unique_ptr<wire::Reader> reader;
  };

  Result<Decoder> decoder_of(std::uint64_t writer);
  Result<Decoder> decoder_for(const wire::EndpointInfo& end);

  Wire wire_;
  FoundTopic topic_;
  std::vector<TypeReader> readers_;            ///< one for each name of a type
  std::string taken_type_;                     ///< of the messages that are taken now
  std::map<std::uint64_t, Decoder> decoders_;  ///< by writer
  /// One of them by the type's name, for a writer that has left before it could be asked.
  std::map<std::string, Decoder> any_;
  std::vector<std::string> notes_;
};

}  // namespace galilean::monitor
