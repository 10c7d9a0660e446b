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
#include "monitor/record/channel_metadata.h"
#include "monitor/wire/definitions.h"

namespace galilean::monitor {

/// In which language a recording defines its messages.
enum class SchemaLanguage {
  kMessage,  ///< that of .msg files, "ros2msg", which most readers know
  kIdl       ///< IDL
};

/// Gives each writer's messages a channel of their own, so that their numbers tell what is missing
/// of them, and what each writer keeps for late joiners can be told apart. For use by one thread.
class Channels {
 public:
  struct Setup {
    mcap::Writer& writer;      ///< outlives the channels
    Definitions& definitions;  ///< outlives the channels
    SchemaLanguage language = SchemaLanguage::kMessage;
    bool leaves_out_pictures = false;  ///< pictures may be left out, which their numbers show
    /// Gets a sentence for each topic whose messages are recorded without a definition.
    std::function<void(const std::string&)> warn;
  };
  /// Writers beyond so many share one channel for each topic and definition: a file can have 65535.
  static constexpr std::size_t kMostOfOneWriter = 20'000;

  explicit Channels(Setup setup) : setup_(std::move(setup)) {}

  /// Returns the channel for a message of an endpoint. At the first one of a definition it asks the
  /// domain for it, and may block for 3 s.
  [[nodiscard]] std::uint16_t of(const wire::EndpointInfo& end, std::span<const std::uint8_t> cdr);
  /// Gives later messages other channels than those before, so that no reader takes the numbers
  /// that a pause leaves out for missing messages.
  void begin_part();

 private:
  /// A schema's encoding and text. Both are empty where there is no definition.
  struct Text {
    std::string encoding, text;
  };

  std::uint16_t add(const wire::EndpointInfo& end, bool xcdr2, bool shared);
  [[nodiscard]] std::string sequence_gaps(const wire::EndpointInfo& end, bool shared) const;
  Text schema_text(const wire::EndpointInfo& end, bool xcdr2);
  std::uint16_t schema_of(const wire::EndpointInfo& end, bool xcdr2);

  Setup setup_;
  std::uint64_t part_ = 1;
  std::size_t of_one_writer_ = 0;  ///< channels, in all parts
  std::map<std::tuple<std::string, std::string, bool>, std::uint16_t>
      schemas_;  ///< by type, its hash, and whether it is encoded in XCDR2
  std::map<std::pair<std::string, bool>, std::uint16_t>
      channels_;  ///< by the writer's GUID, and as above
  std::map<std::tuple<std::string, std::string, std::string, bool>, std::uint16_t>
      shared_;  ///< by the topic, and as `schemas_`
};

}  // namespace galilean::monitor
