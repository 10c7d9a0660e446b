// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/discovery.h"
#include "core/wire/participant.h"
#include "monitor/ingest/channel.h"

namespace galilean::monitor {

/// Reads every ROS topic of the domain whose type is one of the project's messages. Pictures and
/// markers are costly to make, and robots make them only for readers. These are therefore read only
/// while a client wants them.
///
/// For use by one thread, which also runs the callbacks. Cyclone's threads only call `wake`, at
/// most once between two calls of `poll`. `wake` must make the owner's thread call `poll`: it posts
/// to an io_context or notifies a condition variable.
class Ingest {
 public:
  using Wake = std::function<void()>;
  using ReadAtOnce = std::function<bool(const Channel&)>;

  /// Called by `poll` and `want`. `channel` and `problem` may be empty.
  struct Callbacks {
    std::function<void(const Channel&)> channel;  ///< called when a topic is first seen
    std::function<void(const Message&)> message;
    std::function<void(const std::string&)> problem;  ///< says which topic cannot be read, and why
  };

  /// `read_at_once` says which topics are always read, without a call of `want`.
  Ingest(wire::Participant& participant, Callbacks callbacks, Wake wake,
         ReadAtOnce read_at_once = all_but_costly);
  ~Ingest();
  Ingest(const Ingest&) = delete;
  Ingest& operator=(const Ingest&) = delete;

  /// Takes the messages and the topics that came since the last call. Never waits.
  void poll();
  /// Begins or ends the reading of a topic that is not always read. Calls need not be paired, and
  /// an unknown id is ignored.
  void want(std::uint32_t channel_id, bool wanted);
  /// Leaves a topic's messages with its reader, or takes them again. Of a state the reader keeps
  /// the newest, which the first `poll` after that takes. An unknown id is ignored.
  void rest(std::uint32_t channel_id, bool rests);

  /// Returns false for pictures and markers.
  [[nodiscard]] static bool all_but_costly(const Channel& channel);

 private:
  struct Signals;
  struct Source;

  void discover();
  void open(Source& source);

  wire::Participant& participant_;
  Callbacks callbacks_;
  ReadAtOnce read_at_once_;
  std::shared_ptr<Signals> signals_;
  std::vector<std::unique_ptr<Source>> sources_;  ///< at index channel id - 1
  std::map<std::string, Source*> by_topic_;
  std::unique_ptr<wire::Discovery> discovery_;
};

}  // namespace galilean::monitor
