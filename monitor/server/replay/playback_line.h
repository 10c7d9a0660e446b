// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/clock.h"
#include "monitor/server/replay/playback_messages.h"

namespace galilean::monitor {

/// What a viewer tells its playback.
struct Subscribe {
  std::uint32_t subscription_id = 0, channel_id = 0;
};
struct Unsubscribe {
  std::uint32_t subscription_id = 0;
};
using PlaybackOrder = std::variant<Subscribe, Unsubscribe, PlaybackRequest>;

/// What a playback tells its viewer at once.
struct ForViewer {
  std::vector<Frame> frames;    ///< all of them arrive, in their order
  std::optional<Frame> time;    ///< replaces one that still waits
  std::string end_reason = {};  ///< a sentence if the playback is over, and the connection with it
};

/// The line between a viewer, on the io_context's thread, and its playback, which reads the disk on
/// a thread of its own. What is on its way to the viewer is bounded: a viewer that does not read
/// makes its playback wait.
class PlaybackLine {
 public:
  /// So much may wait for the viewer [bytes]; a larger message waits alone.
  static constexpr std::size_t kMostWaitingBytes = std::size_t{1} << 20;
  static constexpr std::size_t kMostOrders = 10'000;

  /// `deliver` is called on the playback's thread.
  explicit PlaybackLine(std::function<void(ForViewer)> deliver) : deliver_(std::move(deliver)) {}

  // For the viewer.
  /// Returns false if more orders wait than a playback keeps.
  [[nodiscard]] bool order(PlaybackOrder order);
  /// So much has gone on its way to the viewer.
  void taken(std::size_t bytes);
  /// Ends the playback as soon as it looks.
  void leave();

  // For the playback.
  /// Waits for orders, or for `most`; where there is no room, for room alone, because orders are
  /// answered. Returns false if the viewer has left.
  [[nodiscard]] bool wait(Duration most);
  [[nodiscard]] std::vector<PlaybackOrder> take_orders();
  [[nodiscard]] bool has_room();
  void send(ForViewer what);

 private:
  std::function<void(ForViewer)> deliver_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<PlaybackOrder> orders_;
  std::size_t waiting_bytes_ = 0;
  bool left_ = false;
};

}  // namespace galilean::monitor
