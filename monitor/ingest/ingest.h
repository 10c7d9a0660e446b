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

/// Reads every topic of the domain whose type is one of the messages. What is costly to make,
/// pictures and markers, is read only while somebody wants it, so that it is made only then.
///
/// One thread owns it: construction, `poll` and `want` happen there, and so do the callbacks.
/// Cyclone's threads do nothing but call `wake` (once until the next `poll`), which must hand over
/// to the owner: post to an io_context, or notify a condition variable.
class Ingest {
 public:
  using Wake = std::function<void()>;
  using ReadAtOnce = std::function<bool(const Channel&)>;

  /// Set before the first poll. Any may be empty.
  struct Callbacks {
    std::function<void(const Channel&)> channel;  ///< seen for the first time
    std::function<void(const Message&)> message;
    std::function<void(const std::string&)> problem;  ///< a topic that cannot be read, and why
  };

  /// `read_at_once` says which topics are read without being asked for.
  Ingest(wire::Participant& participant, Callbacks callbacks, Wake wake,
         ReadAtOnce read_at_once = all_but_costly);
  ~Ingest();
  Ingest(const Ingest&) = delete;
  Ingest& operator=(const Ingest&) = delete;

  /// Takes what came since the last time; never waits.
  void poll();
  /// Begins or ceases to read a topic that is not read at once. Calls need not be paired.
  void want(std::uint32_t channel_id, bool wanted);

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
