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

/// Reads all topics of the team and writes their bytes untouched to an MCAP file, each from the
/// moment when somebody first writes it. Log time: when it was received, by this machine's clock.
/// Publish time: when it was sent, by its writer's clock. Topics are named as ROS 2 does:
/// /io/state.
///
/// One thread owns it and calls `pump` when `descriptor` is readable.
class Recorder {
 public:
  struct Selection {
    std::optional<std::regex> topics;  ///< records those in whose names it is found; none: all
    bool images = true;                ///< reading them makes robots encode them
  };

  Recorder(wire::Participant& participant, mcap::Writer& writer, Selection selection,
           std::function<void(const std::string&)> warn);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  /// Records all that came since the last call; never waits for more.
  [[nodiscard]] mcap::Failure pump();
  [[nodiscard]] std::size_t topics() const noexcept { return subscriptions_.size(); }

 private:
  struct Subscription;

  bool selected(const std::string& name, std::string_view ros_type) const;
  void subscribe_to_new();
  void subscribe(const std::string& topic, const wire::Schema& schema);
  std::uint16_t channel_for(const std::string& name, const wire::Schema& schema);
  mcap::Failure record(Subscription& subscription);

  wire::Participant& participant_;
  mcap::Writer& writer_;
  Selection selection_;
  std::function<void(const std::string&)> warn_;
  Wake wake_;
  std::map<std::string, std::uint16_t, std::less<>> schema_ids_;  ///< by ROS type
  std::set<std::string> settled_;  ///< topics that are recorded, or were decided against
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::atomic<bool> topics_changed_{true};
  wire::Discovery discovery_;
};

}  // namespace galilean::monitor
