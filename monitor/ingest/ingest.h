// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/cut_off_watch.h"
#include "core/wire/discovery.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "monitor/ingest/channel.h"
#include "monitor/ingest/intake.h"
#include "monitor/ingest/kept_bytes.h"
#include "monitor/ingest/robot_roster.h"

namespace galilean::monitor {

/// Reads every ROS topic of the domain whose type is one of the project's messages. Pictures and
/// markers are costly to make, and robots make them only for readers. These are therefore read only
/// while a client wants them.
///
/// Whoever writes to DDS can name any robots and topics. Ingest therefore takes the messages of
/// kMostRobots robots, the first that sent a valid one (RobotRoster says who gives a place up), and
/// reads so many topics, of all and of each process. It counts what is beyond, names the first of
/// it, and ignores it. KeptBytes bounds how long the messages are.
///
/// One call of `poll` takes in at most kMostNewTopics topics and kMostAtOnce messages of each
/// topic, and turns to no further topic after kLongestTurn. It then wakes the thread for the rest,
/// so that a flood does not keep it from its other work.
///
/// Of a robot's changes of state and answers to pushes none may be missed. They are told apart by
/// their writers' numbers: what DDS sends again is dropped, what fills a gap in which the robot
/// could not be heard is marked, and what is lost is counted.
///
/// For use by one thread, which also runs the callbacks. Cyclone's threads only call `wake`, at
/// most once between two calls of `poll`. `wake` must make the owner's thread call `poll`: it posts
/// to an io_context or notifies a condition variable.
class Ingest {
 public:
  static constexpr std::size_t kMostRobots = RobotRoster::kMost;
  static constexpr std::size_t kMostTopics = 6144;
  static constexpr std::size_t kMostTopicsOfProcess = 2048;
  static constexpr std::size_t kMostNewTopics = 16;
  static constexpr std::size_t kMostAtOnce = 8;
  static constexpr Duration kLongestTurn = std::chrono::milliseconds(4);

  using Wake = std::function<void()>;
  using ReadAtOnce = std::function<bool(const Channel&)>;

  /// Called by `poll` and `want`. All but `message` may be empty.
  struct Callbacks {
    std::function<void(const Channel&)> channel;  ///< called when a topic is first seen
    std::function<void(const Message&)> message;
    std::function<void(const std::string&)> problem;  ///< says which topic cannot be read, and why
    /// Called when a robot gave its place to another one, before that one's first message. What
    /// the robot sent is of no use any more.
    std::function<void(const std::string& robot)> forgotten = {};
  };

  /// `read_at_once` says which topics are always read, without a call of `want`.
  Ingest(wire::Participant& participant, Callbacks callbacks, Wake wake,
         ReadAtOnce read_at_once = all_but_costly);
  ~Ingest();
  Ingest(const Ingest&) = delete;
  Ingest& operator=(const Ingest&) = delete;

  /// Takes messages and topics that came since the last call. Never waits. Where not all were
  /// taken, it has called `wake`.
  void poll();
  /// Begins or ends the reading of a topic that is not always read. Calls need not be paired, and
  /// an unknown id is ignored.
  void want(std::uint32_t channel_id, bool wanted);
  /// Leaves a topic's messages with its reader, or takes them again. Of a state the reader keeps
  /// the newest, which a `poll` after that takes. An unknown id is ignored.
  void rest(std::uint32_t channel_id, bool rests);

  /// Returns how it stands with what comes in.
  [[nodiscard]] Intake intake() const;

  /// Returns false for pictures and markers.
  [[nodiscard]] static bool all_but_costly(const Channel& channel);

 private:
  struct Signals;
  struct Source;

  void discover();
  void add(const wire::Publication& publication);
  void open(Source& source);
  void take(Source& source);
  /// Returns whether there is room for a topic of this process, and notes it.
  [[nodiscard]] bool has_room_for(const wire::Publication& publication);
  /// Returns whether the message is of a robot that is followed, or of none.
  [[nodiscard]] bool follows(const wire::Received& received);
  /// Notes a state or an event of a robot, and sets whether the event fills a gap. Returns false if
  /// it is an event that has come before.
  [[nodiscard]] bool account(Source& source, const wire::Received& received, bool& filled);
  /// Returns whether there is room to keep the message, and counts it.
  [[nodiscard]] bool has_room_for(Source& source, const wire::Received& received);

  wire::Participant& participant_;
  Callbacks callbacks_;
  ReadAtOnce read_at_once_;
  std::shared_ptr<Signals> signals_;
  std::vector<std::unique_ptr<Source>> sources_;  ///< at index channel id - 1
  std::size_t next_ = 0;                          ///< the source that the next turn begins with
  std::map<std::string, Source*> by_topic_;
  std::map<std::string, std::size_t> topics_of_;  ///< how many are read, by their first process
  std::size_t topics_not_read_ = 0;
  KeptBytes kept_bytes_;
  RobotRoster robots_;
  std::map<std::string, wire::CutOffWatch, std::less<>> cut_offs_;  ///< by robot, of `robots_`
  std::string beyond_;  ///< why messages of further robots are refused; it names the first
  SteadyClock clock_;
  std::unique_ptr<wire::Discovery> discovery_;
};

}  // namespace galilean::monitor
