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

/// The pictures of a robot that others may look at: the camera's, then those that the schemas of
/// its catalog make.
using ImageChannel = std::size_t;
inline constexpr ImageChannel kCameraChannel = 0;

/// One picture, out of the tick.
struct Picture {
  std::uint64_t frame = 0;
  Time captured{};
  std::vector<std::uint8_t> pixels;  ///< of the camera, red, green, blue; else one byte a pixel
};

/// Hands pictures to the one thread that encodes them: only those that somebody wants, at most some
/// ten a second, by a copy into room made before. Wait-free on both sides.
class ImageTap final : public TickObserver {
 public:
  explicit ImageTap(const Catalog& catalog);

  void on_event(const Event&) noexcept override {}
  void on_tick(const TickView& view) noexcept override;

  /// Reader: the name of each channel.
  [[nodiscard]] const std::vector<std::string>& channels() const noexcept { return names_; }
  /// Reader.
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
