// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "monitor/server/limits/limit_counts.h"
#include "monitor/server/limits/server_limits.h"

namespace galilean::monitor {

/// Counts the open connections, HTTP and WebSockets alike, and says who may open another. Where it
/// is full, the connection that has waited longest for a request is closed for the new one. Where
/// none waits, a few places are left that are reserved for an operator. For use on the io_context's
/// thread.
class Connections : public std::enable_shared_from_this<Connections> {
 public:
  /// One open connection. It is counted for as long as it lives.
  class Place {
   public:
    Place(std::shared_ptr<Connections> all, std::string address, bool is_reserved);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    /// The connection waits for a request from now on. `close` is called at most once, to make room
    /// for another connection.
    void wait(std::function<void()> close);
    /// The connection serves a request from now on, and is not closed for another.
    void serve();
    /// Returns whether only an operator's requests may be answered on it.
    [[nodiscard]] bool is_reserved() const noexcept { return is_reserved_; }
    /// Does `work`, which must not throw, when its turn comes among all connections' work; at once
    /// where they take no turns.
    void in_turn(std::function<void()> work) const;
    /// Counts so many bytes more that are kept of the message that is being read. The first
    /// kFreeBytes of a connection are not counted, so that others' messages delay no command.
    /// Returns false if all connections together keep as many as they may.
    [[nodiscard]] bool keep(std::size_t bytes);
    /// Nothing is kept of that message any more.
    void let_go();
    /// Counts what this connection reaches.
    [[nodiscard]] LimitCounts& limit_counts() const noexcept { return *all_->counts_; }
    [[nodiscard]] const ServerLimits& limits() const noexcept { return all_->limits_; }

   private:
    friend class Connections;
    std::shared_ptr<Connections> all_;
    std::string address_;
    bool is_reserved_;
    bool waits_ = false;
    std::size_t read_bytes_ = 0;        ///< of the message that is being read
    std::size_t kept_bytes_ = 0;        ///< those of them that are counted
    std::list<Place*>::iterator turn_;  ///< in waiting_, while it waits
    std::function<void()> close_;
  };

  /// What does a client's work when its turn comes.
  using InTurn = std::function<void(std::function<void()> work)>;
  static constexpr std::size_t kFreeBytes = std::size_t{64} << 10;

  Connections(const ServerLimits& limits, std::shared_ptr<LimitCounts> counts)
      : limits_(limits), counts_(std::move(counts)) {}

  /// Returns the place of a new connection from `address`; null if it must be closed at once.
  [[nodiscard]] std::shared_ptr<Place> admit(const std::string& address, bool is_loopback);
  /// Has connections' work done by `in_turn` from now on; with an empty one, at once.
  void take_turns_by(InTurn in_turn) { in_turn_ = std::move(in_turn); }
  /// Closes the connection that has waited longest for a request, so that what it takes is free.
  /// Returns whether there was one.
  bool close_waiting();
  [[nodiscard]] std::size_t open() const noexcept { return open_; }
  /// Returns how many connections were closed while they waited, to make room.
  [[nodiscard]] std::uint64_t closed_for_others() const noexcept { return closed_for_others_; }

 private:
  [[nodiscard]] bool make_room(const std::string* address, bool is_reserved);

  ServerLimits limits_;
  std::shared_ptr<LimitCounts> counts_;
  std::size_t open_ = 0;      ///< the reserved ones included
  std::size_t reserved_ = 0;  ///< of them
  std::uint64_t closed_for_others_ = 0;
  std::size_t kept_bytes_ = 0;  ///< of messages that are being read
  InTurn in_turn_;
  std::map<std::string, std::size_t> open_of_;  ///< by address, without the reserved ones
  std::list<Place*> waiting_;                   ///< the one that has waited longest first
};

}  // namespace galilean::monitor
