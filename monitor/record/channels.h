// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <tuple>

#include "core/wire/endpoints.h"
#include "monitor/mcap/mcap_writer.h"
#include "monitor/wire/definitions.h"

namespace galilean::monitor {

/// In which language a recording defines its messages.
enum class SchemaLanguage {
  kMessage,  ///< that of .msg files, "ros2msg", which most readers know
  kIdl       ///< IDL
};

/// Gives each topic of a recording its channels: one for each definition of its messages. For use
/// by one thread.
class Channels {
 public:
  /// `warn` gets a sentence for each topic whose messages are recorded without a definition.
  /// Requires: `writer` and `definitions` outlive this.
  Channels(mcap::Writer& writer, Definitions& definitions, SchemaLanguage language,
           std::function<void(const std::string&)> warn)
      : writer_(writer), definitions_(definitions), language_(language), warn_(std::move(warn)) {}

  /// Returns the channel for a message of an endpoint. At the first one of a definition it asks the
  /// domain for it, and may block for 3 s.
  [[nodiscard]] std::uint16_t of(const wire::EndpointInfo& end, std::span<const std::uint8_t> cdr);

 private:
  /// A schema's encoding and text. Both are empty where there is no definition.
  struct Text {
    std::string encoding, text;
  };

  Text schema_text(const wire::EndpointInfo& end, bool xcdr2);
  std::uint16_t schema_of(const wire::EndpointInfo& end, bool xcdr2);

  mcap::Writer& writer_;
  Definitions& definitions_;
  SchemaLanguage language_;
  std::function<void(const std::string&)> warn_;
  std::map<std::tuple<std::string, std::string, bool>, std::uint16_t>
      schemas_;  ///< by type, its hash, and whether it is encoded in XCDR2
  std::map<std::tuple<std::string, std::string, std::string, bool>, std::uint16_t>
      channels_;  ///< the topic before these
};

}  // namespace galilean::monitor
