// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/sequence_tally.h"
#include "monitor/record/paused_tally.h"

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
    bool exclusive = false;                         ///< the ownership
    auto operator<=>(const Kind&) const = default;  // NOLINT(modernize-use-nullptr): none here
  };
  struct Writer {
    wire::EndpointInfo info;
    wire::SequenceTally tally;
    /// Of those that did not come: how many were missed while a reader's queue was full.
    std::uint64_t overrun = 0;
    bool recorded = true;  ///< otherwise it is heard, and counted nowhere
    // For who receives the messages, to count what he wrote of a gap, and what he did not write:
    std::uint64_t filled = 0;     ///< events of a robot that fill a gap
    std::uint64_t unwritten = 0;  ///< for want of room
    std::uint64_t left_out = 0;   ///< because more was not asked for
    PausedTally paused;           ///< because the recording was paused
  };
  using Receive = std::function<void(const wire::Received&, Writer&)>;
  struct Setup {
    wire::Participant& participant;  ///< outlives the recording
    Kind kind;
    bool recorded = true;  ///< whether its writers are
    int depth = 1;         ///< messages that each reader keeps between two calls of `take`
    /// Finds a writer by EndpointInfo::handle. Nothing: it has left.
    std::function<std::optional<wire::EndpointInfo>(std::uint64_t)> find;
    std::function<void()> on_data;  ///< a thread of Cyclone calls it when there is data to take
  };

  [[nodiscard]] static Kind kind_of(const wire::EndpointInfo& writer);
  /// Returns what the reader for such a writer asks for.
  [[nodiscard]] static wire::EndpointQos asked_of(const wire::EndpointInfo& writer);

  explicit TopicRecording(Setup setup) : setup_(std::move(setup)) {}
  ~TopicRecording();
  TopicRecording(const TopicRecording&) = delete;
  TopicRecording& operator=(const TopicRecording&) = delete;

  /// Receives what this writer sends, too. Requires: kind_of(writer) is this kind.
  /// Errors: throws std::runtime_error if Cyclone refuses a reader.
  void follow(const wire::EndpointInfo& writer);
  /// Returns whether DDS has connected this writer with the reader for it. Requires: it is
  /// followed.
  [[nodiscard]] bool hears(const wire::EndpointInfo& writer) const;
  /// Calls `receive` for each message that came since the last call, and that has not come before.
  void take(const Receive& receive);
  [[nodiscard]] bool recorded() const noexcept { return setup_.recorded; }
  /// Returns all writers that were followed, those that have left, too, by their GUIDs.
  [[nodiscard]] const std::map<std::string, Writer>& writers() const noexcept { return writers_; }

 private:
  struct Offer {
    bool reliable = false, kept = false;             ///< kept for late joiners
    auto operator<=>(const Offer&) const = default;  // NOLINT(modernize-use-nullptr): none here
  };

  [[nodiscard]] static Offer offer_of(const wire::EndpointInfo& writer) noexcept;
  void read_what_is(const wire::EndpointInfo& writer);
  void take_from(wire::Reader& reader, Offer asked, const Receive& receive);
  Writer& writer_of(std::uint64_t handle);
  [[nodiscard]] wire::EndpointInfo writer_that_left(std::uint64_t handle) const;

  const Setup setup_;
  std::atomic<bool> ready_{false};
  std::map<std::string, Writer> writers_;                   ///< by GUID
  std::map<std::uint64_t, Writer*> writer_of_handle_;       ///< of `writers_`
  std::map<Offer, std::unique_ptr<wire::Reader>> readers_;  ///< the one that asks for least first
};

}  // namespace galilean::monitor
