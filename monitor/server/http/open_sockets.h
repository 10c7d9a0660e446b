// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "monitor/access/access.h"
#include "monitor/server/websocket/revocable.h"

namespace galilean::monitor {

/// The open WebSockets whose clients sent a token. A token is looked at when a socket opens, but it
/// may be revoked or expire while the socket is open.
class OpenSockets {
 public:
  /// Notes a session that was opened with the token of this digest, which gave `right`.
  void add(std::string digest, Right right, std::weak_ptr<Revocable> session);
  /// Closes the sessions whose tokens no longer give the right that they gave, and cuts those that
  /// the last call closed and that are still there.
  void end_withdrawn(const Access& access);
  /// Returns how many sessions were closed so.
  [[nodiscard]] std::uint64_t ended() const noexcept { return ended_; }

 private:
  struct Entry {
    std::string digest;
    Right right;
    std::weak_ptr<Revocable> session;
    bool is_closing = false;
  };
  /// Returns false if the session need not be looked at any more.
  [[nodiscard]] bool look_at(Entry& entry, const Access& access);

  std::vector<Entry> entries_;
  std::uint64_t ended_ = 0;
};

}  // namespace galilean::monitor
