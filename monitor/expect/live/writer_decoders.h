// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/wire/endpoints.h"
#include "core/wire/reader.h"
#include "monitor/expect/judge/samples.h"
#include "monitor/expect/recording/typed_decoder.h"
#include "monitor/wire/definitions.h"

namespace galilean::expect {

/// Decodes messages of the wire, each by the definition that its writer has, as far as the sink
/// wants them. For use by one thread.
class WriterDecoders {
 public:
  /// Requires: both outlive this.
  WriterDecoders(monitor::Definitions& definitions, SampleSink& sink)
      : definitions_(definitions), sink_(sink), typed_(sink) {}

  /// Returns whether the sink wants what this writer sends.
  [[nodiscard]] bool wants(const wire::EndpointInfo& writer) const;
  /// Gives a message to the sink. It may block for 3 s at the first message of a writer whose
  /// fields are wanted. Returns false if it is no whole message of its definition, or that is not
  /// known.
  [[nodiscard]] bool take(std::int64_t at_ns, const wire::EndpointInfo& writer,
                          const wire::Received& received);
  /// Returns sentences on what is not decoded, since the last call.
  [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  /// How the messages of one writer are given to the sink.
  struct Way {
    std::uint64_t writer = 0;  ///< a number that no other writer has
    std::string topic;
    bool counted = false;  ///< the sink wants to know of each message
    TypedDecoder::Decode typed = nullptr;
    bool fields_wanted = false;
    std::optional<monitor::MessageDecoder> fields;
  };
  [[nodiscard]] Way way_of(const wire::EndpointInfo& writer);

  monitor::Definitions& definitions_;
  SampleSink& sink_;
  TypedDecoder typed_;
  std::map<std::string, Way> ways_;  ///< by the writer's GUID
  std::uint64_t writers_ = 0;        ///< that were met
  std::vector<std::string> notes_;
};

}  // namespace galilean::expect
