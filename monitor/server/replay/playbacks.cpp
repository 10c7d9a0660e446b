// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/playbacks.h"

#include <algorithm>
#include <utility>

#include "monitor/background/guarded.h"

namespace galilean::monitor {

bool Playbacks::begin(std::shared_ptr<PlaybackLine> line, std::function<void(PlaybackLine&)> play) {
  forget_what_is_over();
  if (running_.size() >= kMost) return false;
  auto over = std::make_shared<std::atomic<bool>>(false);
  std::thread thread([line, over, play = std::move(play)] {
    const auto done = guarded("a playback", [&] { play(*line); });
    if (!done)
      (void)guarded("a playback's end", [&] {
        line->send(
            {.frames = {}, .end_reason = "The replay failed: " + done.error().message + "."});
      });
    *over = true;
  });
  running_.push_back({std::move(thread), std::move(line), std::move(over)});
  return true;
}

std::size_t Playbacks::running() const noexcept {
  return static_cast<std::size_t>(
      std::ranges::count_if(running_, [](const Running& each) { return !*each.over; }));
}

void Playbacks::forget_what_is_over() {
  std::erase_if(running_, [](Running& each) {
    if (!*each.over) return false;
    each.thread.join();
    return true;
  });
}

void Playbacks::finish() {
  for (const auto& each : running_) each.line->leave();
  for (auto& each : running_) each.thread.join();
  running_.clear();
}

}  // namespace galilean::monitor
