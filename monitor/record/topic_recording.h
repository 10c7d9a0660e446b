// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "monitor/record/sequence_tally.h"

namespace galilean::monitor {

/// Receives the messages of one type on one topic, each once. There is a reader for each quality of
/// service that writers offer, which asks for just that: a reader that asked for more would miss
/// the lesser writers, and one that asked for less would miss what the better ones keep for late
/// joiners, and send again. For use by one thread.
class TopicRecording {
 public:
  /// What one reader can match.
  struct Kind {
    std::string topic;     ///< as on DDS: "rt/io/state"
    std::string dds_type;  ///< "galilean_msgs::msg::dds_::RobotState_"
    bool keyed = false;
    bool exclusive = false;  ///< the ownership
    auto operator<=>(const Kind&) const = default;
  };
  struct Writer {
    wire::EndpointInfo info;
    SequenceTally tally;
    std::uint64_t unwritten = 0;  ///< for who receives the messages: how many he did not write
  };
  using Receive = std::function<void(const wire::Received&, Writer&)>;

  [[nodiscard]] static Kind kind_of(const wire::EndpointInfo& writer);

  /// It keeps `depth` messages of each reader between two calls of `take`. A thread of Cyclone
  /// calls `on_data` when there are some to take. Requires: the participant outlives this.
  TopicRecording(wire::Participant& participant, Kind kind, int depth,
                 std::function<void()> on_data);
  ~TopicRecording();
  TopicRecording(const TopicRecording&) = delete;
  TopicRecording& operator=(const TopicRecording&) = delete;

  /// Receives what this writer sends, too. Requires: kind_of(writer) is this kind.
  /// Errors: throws std::runtime_error if Cyclone refuses a reader.
  void follow(const wire::EndpointInfo& writer);
  /// Calls `receive` for each message that came since the last call, and that has not come before.
  void take(const Receive& receive);
  /// Returns all writers that were followed, those that have left, too, by their GUIDs.
  [[nodiscard]] const std::map<std::string, Writer>& writers() const noexcept { return writers_; }

 private:
  struct Offer {
    bool reliable = false, kept = false;  ///< kept for late joiners
    auto operator<=>(const Offer&) const = default;
  };

  [[nodiscard]] static Offer offer_of(const wire::EndpointInfo& writer) noexcept;
  void read_what_is(Offer offered);
  [[nodiscard]] bool takes_from(Offer asked, std::uint64_t writer) const;
  Writer& writer_of(std::uint64_t handle);
  [[nodiscard]] wire::EndpointInfo unknown_writer(std::uint64_t handle) const;

  wire::Participant& participant_;
  const Kind kind_;
  const int depth_;
  const std::function<void()> on_data_;
  std::atomic<bool> ready_{false};
  std::map<std::string, Writer> writers_;                   ///< by GUID
  std::map<std::uint64_t, Writer*> writer_of_handle_;       ///< of `writers_`
  std::map<Offer, std::unique_ptr<wire::Reader>> readers_;  ///< the one that asks for least first
};

}  // namespace galilean::monitor
