// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
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
#include "monitor/map/map_watch.h"
#include "monitor/map/team_map.h"

namespace galilean::monitor {

/// Keeps the team's map on a thread of its own, and publishes it: objects and transforms 5 times a
/// second, the occupancy grid once a second, markers only while somebody reads them. A message or
/// an update that fails is left out, and the next is taken.
class MapService {
 public:
  struct Options {
    std::map<std::string, Pose2> starts;  ///< poses of robots' odom frames in the map frame
    Duration silent_after = std::chrono::seconds(2);
  };

  /// Decodes a message of one type and adds it to the map, or has it forget the robot of which the
  /// bytes are the name.
  using Handler = void (*)(TeamMap&, const std::vector<std::uint8_t>& cdr, Time at);

  MapService(wire::Participant& participant, const Clock& clock, const Options& options);
  ~MapService();
  MapService(const MapService&) = delete;
  MapService& operator=(const MapService&) = delete;

  /// Takes in a message, and ignores it if it does not concern the map. Any thread may call this.
  /// It never waits for the map. If too many messages or bytes wait, it is dropped and counted.
  void receive(const Message& message);
  /// Forgets a robot that is gone, in its turn among the messages. Any thread may call this.
  void forget(const std::string& robot);
  /// The grid and the objects that were published last.
  struct Newest {
    msg::OccupancyGrid grid;
    msg::ObjectMap objects;
  };
  /// Returns nothing until a robot has said where it is.
  [[nodiscard]] std::optional<Newest> newest() const;
  /// Returns how long the last update took [s], including the messages of the 20 ms before it. The
  /// published messages are late by this time.
  [[nodiscard]] double update_s() const noexcept { return update_s_; }
  /// Returns what goes wrong with the map.
  [[nodiscard]] const MapWatch& watch() const noexcept { return watch_; }

 private:
  /// A waiting message without its channel, which may be gone before the message's turn comes.
  struct Arrived {
    Handler handler;
    Payload cdr;
    Time at;
  };
  static constexpr std::size_t kMostWaiting = 4096;
  static constexpr std::size_t kMostWaitingBytes = std::size_t{64} << 20;

  void run();
  /// Runs `work`. Returns false, and notes why, if it throws.
  template <class Work>
  [[nodiscard]] bool attempt(Work work);
  /// Waits until `end`, and returns what arrived. Returns nothing if the service ends.
  [[nodiscard]] std::optional<std::vector<Arrived>> arrived_until(
      std::chrono::steady_clock::time_point end);
  void take_in(const std::vector<Arrived>& arrived);
  void publish(Time now, bool with_grid);
  void publish_grid(std::int64_t stamp_ns);
  void keep(msg::ObjectMap objects);

  const Clock& clock_;
  MapWatch watch_;
  TeamMap map_;
  wire::Writer<msg::ObjectMap> objects_;
  wire::Writer<msg::OccupancyGrid> grid_;
  wire::Writer<msg::MarkerArray> markers_;
  wire::Writer<msg::TFMessage> tf_;

  mutable std::mutex mutex_;  ///< of all below
  std::condition_variable ended_;
  std::vector<Arrived> waiting_;
  std::size_t waiting_bytes_ = 0;
  Newest newest_;

  std::atomic<bool> ending_ = false;
  std::atomic<double> update_s_ = 0;
  std::thread thread_;
};

}  // namespace galilean::monitor
