// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "monitor/server/replay/playback_line.h"

namespace galilean::monitor {

/// The threads of playbacks, at most so many at once. For use by one thread.
class Playbacks {
 public:
  static constexpr std::size_t kMost = 8;

  Playbacks() = default;
  ~Playbacks() { finish(); }
  Playbacks(const Playbacks&) = delete;
  Playbacks& operator=(const Playbacks&) = delete;

  /// Runs `play` on a thread of its own, until it returns because the line's viewer has left.
  /// Returns false if kMost of them run already. An exception of `play` ends it, and the viewer is
  /// told.
  [[nodiscard]] bool begin(std::shared_ptr<PlaybackLine> line,
                           std::function<void(PlaybackLine&)> play);
  /// Returns how many run now.
  [[nodiscard]] std::size_t running() const noexcept;
  /// Ends all, and waits for it. Call it before the objects that they use are destroyed.
  void finish();

 private:
  struct Running {
    std::thread thread;
    std::shared_ptr<PlaybackLine> line;
    std::shared_ptr<std::atomic<bool>> over;
  };
  void forget_what_is_over();

  std::vector<Running> running_;
};

}  // namespace galilean::monitor
