#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/ingest/channel.h"
#include "monitor/map/team_map.h"

namespace galilean::monitor {

/// Keeps the team's map on a thread of its own, and publishes it: objects and frames 5 times a
/// second, the floor once a second, markers only while somebody reads them.
class MapService {
 public:
  struct Options {
    std::map<std::string, Pose2> starts;  ///< origins of robots' odom frames in the map
    Duration silent_after = std::chrono::seconds(2);
  };

  /// Tells the map what one type of message says.
  using Note = void (*)(TeamMap&, const std::vector<std::uint8_t>& cdr, Time at);

  MapService(wire::Participant& participant, const Clock& clock, const Options& options);
  ~MapService();
  MapService(const MapService&) = delete;
  MapService& operator=(const MapService&) = delete;

  /// Takes any message; those that tell nothing of the map are let pass. Never waits for the map.
  void receive(const Message& message);
  /// What was published last.
  struct Newest {
    msg::OccupancyGrid grid;
    msg::ObjectMap objects;
  };
  /// Nothing while no robot has told where it is.
  [[nodiscard]] std::optional<Newest> newest() const;
  /// What the last update took, with the messages of the 20 ms before it: what they are late by.
  [[nodiscard]] double update_s() const noexcept { return update_s_; }

 private:
  /// Without the channel, which lives no longer than who reads it.
  struct Arrived {
    Note note;
    Payload cdr;
    Time at;
  };
  static constexpr std::size_t kMostWaiting = 4096;

  void run();
  /// Waits. Nothing: the service ends.
  [[nodiscard]] std::optional<std::vector<Arrived>> arrived_until(
      std::chrono::steady_clock::time_point end);
  void take_in(const std::vector<Arrived>& arrived);
  void publish(Time now, bool with_floor);
  void publish_floor(std::int64_t stamp_ns);
  void keep(msg::ObjectMap objects);

  const Clock& clock_;
  TeamMap map_;
  wire::Writer<msg::ObjectMap> objects_;
  wire::Writer<msg::OccupancyGrid> grid_;
  wire::Writer<msg::MarkerArray> markers_;
  wire::Writer<msg::TFMessage> tf_;

  mutable std::mutex mutex_;  ///< of all below
  std::condition_variable ended_;
  std::vector<Arrived> waiting_;
  Newest newest_;
  bool ending_ = false;

  std::atomic<double> update_s_ = 0;
  std::thread thread_;
};

}  // namespace galilean::monitor
