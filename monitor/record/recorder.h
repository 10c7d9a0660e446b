// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/wake.h"
#include "core/wire/discovery.h"
#include "core/wire/participant.h"
#include "core/wire/schemas.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::monitor {

/// Reads all topics of the team and writes their bytes unchanged to an MCAP file. A topic is read
/// as soon as it has a writer. A message's log time is when it was received, by this machine's
/// clock. Its publish time is when it was sent, by its writer's clock. Topics have their ROS names:
/// /io/state.
///
/// For use by one thread, which calls `pump` when `descriptor` is readable.
class Recorder {
 public:
  struct Selection {
    std::optional<std::regex> topics;  ///< must match a part of a topic's name; none: all topics
    bool images = true;                ///< costly, because robots encode images only for readers
  };

  /// `warn` gets a sentence for each topic that cannot be recorded.
  /// Requires: `writer` has begun. Both references outlive this.
  Recorder(wire::Participant& participant, mcap::Writer& writer, Selection selection,
           std::function<void(const std::string&)> warn);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  /// Records the messages that came since the last call. Never waits for more.
  /// Errors: the file cannot be written.
  [[nodiscard]] Result<void> pump();
  [[nodiscard]] std::size_t topics() const noexcept { return subscriptions_.size(); }

 private:
  struct Subscription;

  bool selected(const std::string& name, std::string_view ros_type) const;
  void subscribe_to_new();
  void subscribe(const std::string& topic, const wire::Schema& schema);
  std::uint16_t channel_for(const std::string& name, const wire::Schema& schema);
  Result<void> record(Subscription& subscription);

  wire::Participant& participant_;
  mcap::Writer& writer_;
  Selection selection_;
  std::function<void(const std::string&)> warn_;
  Wake wake_;
  std::map<std::string, std::uint16_t, std::less<>> schema_ids_;  ///< by ROS type
  std::set<std::string> settled_;  ///< topics that are recorded, not selected or not known
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::atomic<bool> topics_changed_{true};
  wire::Discovery discovery_;
};

}  // namespace galilean::monitor
