// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "monitor/playback/seekable_player.h"
#include "monitor/recordings/recording_folder.h"
#include "monitor/server/replay/playback_line.h"
#include "monitor/server/replay/viewed_recording.h"

namespace galilean::monitor {

/// A playback of a recording for one viewer: it obeys the viewer's orders, and sends what is due.
/// `step` does what is to be done now, so that its owner waits in between. For use by one thread,
/// which may block on the disk.
class ViewerPlayback {
 public:
  /// Tells the viewer what there is, and stands at the recording's start, or so much later. It
  /// begins to play when the viewer subscribes to something or asks for it, and after a second in
  /// any case.
  /// Requires: `recording`, `line` and `real` outlive this.
  ViewerPlayback(const ViewedRecording& recording, PlaybackLine& line, const Clock& real,
                 Duration at);

  /// Obeys orders, and sends what is due as far as there is room. Returns how long nothing is to be
  /// done unless an order comes or there is room.
  [[nodiscard]] Duration step();

 private:
  void obey(const std::vector<PlaybackOrder>& orders);
  void obey(const PlaybackRequest& request, bool is_last_seek);
  void subscribe(const Subscribe& order);
  void unsubscribe(const Unsubscribe& order);
  void subscriptions_changed();
  void send_due();
  void tell_damage();
  void tell_state();
  void begin_to_play();
  void add(Frame frame) { batch_.frames.push_back(std::move(frame)); }
  void add_status(bool is_error, const std::string& sentence);
  void flush();
  [[nodiscard]] PlaybackState state() const;

  const ViewedRecording& recording_;
  PlaybackLine& line_;
  const Clock& real_;
  SeekablePlayer player_;
  DamageTeller damage_;
  std::map<std::uint32_t, const RecordedTopic*> topic_of_;                ///< by subscription id
  std::map<std::uint16_t, std::vector<std::uint32_t>> subscriptions_of_;  ///< by the file's channel
  std::optional<Time> plays_at_;  ///< until then nothing is played; nothing: it began
  bool wants_pause_ = false;
  Time next_time_{};
  PlaybackStatus told_ = PlaybackStatus::kBuffering;
  ForViewer batch_;
};

/// Opens a recording and plays it until the viewer leaves. `at` is where it begins, since the
/// recording's start.
void play_to_viewer(const RecordingFolder& folder, const std::string& name, Duration at,
                    PlaybackLine& line);

}  // namespace galilean::monitor
