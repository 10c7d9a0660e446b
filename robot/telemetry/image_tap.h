#pragma once

#include <array>
#include <atomic>
#include <span>
#include <vector>

#include "core/latest.h"
#include "robot/executive/tick_observer.h"

namespace galilean::robot {

/// The pictures of a robot that others may look at.
enum class ImageChannel : std::uint8_t { kCamera, kSuperred, kSupergreen, kSuperblue, kDark };
inline constexpr std::size_t kImageChannels = 5;

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
  ImageTap();

  void on_event(const Event&) noexcept override {}
  void on_tick(const TickView& view) noexcept override;

  /// Reader.
  void want(ImageChannel channel, bool wanted) noexcept;
  /// Reader: false if there was no new picture since.
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

  [[nodiscard]] Channel& of(ImageChannel channel) noexcept;

  std::array<Channel, kImageChannels> channels_;
};

}  // namespace galilean::robot
