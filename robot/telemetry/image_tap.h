// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "core/catalog/catalog.h"
#include "core/latest.h"
#include "robot/executive/tick_observer.h"

namespace galilean::robot {

/// The number of a picture that viewers may get. The camera's is the first. The pictures that the
/// schemas of the robot's catalog make follow.
using ImageChannel = std::size_t;
inline constexpr ImageChannel kCameraChannel = 0;

/// One picture, copied out of the tick.
struct Picture {
  std::uint64_t frame = 0;
  Time captured{};
  std::vector<std::uint8_t> pixels;  ///< the camera's: red, green, blue; others: one byte a pixel
};

/// Hands pictures to the one thread that encodes them. It copies only wanted pictures, at most
/// about ten a second, into memory that was allocated before. It is wait-free on both sides.
class ImageTap final : public TickObserver {
 public:
  explicit ImageTap(const Catalog& catalog);

  void on_event(const Event&) noexcept override {}
  void on_tick(const TickView& view) noexcept override;

  /// Reader: returns the name of each channel.
  [[nodiscard]] const std::vector<std::string>& channels() const noexcept { return names_; }
  /// Reader: sets whether the channel's pictures are copied.
  void want(ImageChannel channel, bool wanted) noexcept;
  /// Reader: takes the newest picture over. Returns false if there was none since the last call.
  bool take(ImageChannel channel) noexcept;
  [[nodiscard]] const Picture& newest(ImageChannel channel) const noexcept;

 private:
  struct Channel {
    explicit Channel(std::size_t bytes);
    void offer(std::span<const std::uint8_t> pixels, std::uint64_t frame, Time captured) noexcept;

    Latest<Picture> pictures;
    std::atomic<bool> wanted{false};
    std::uint64_t last_frame = 0;
    Time last_captured{};
  };

  std::vector<std::string> names_;
  std::deque<Channel> channels_;  ///< in the order of the names; they cannot be moved
};

}  // namespace galilean::robot
