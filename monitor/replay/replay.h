// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/termination.h"
#include "core/wire/endpoints.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/replay/choice.h"
#include "monitor/replay/playback.h"
#include "monitor/replay/player.h"
#include "monitor/replay/stage.h"

namespace galilean::monitor {

/// What is asked of `galilean replay`.
struct ReplayOptions {
  std::string file;
  double rate = 1;
  double from_s = 0;
  std::optional<double> until_s;
  Choice choice;
  std::optional<double> clock_hz;  ///< how often /clock tells the recording's time; nothing: never
  bool loop = false;
  bool anyway = false;
  int domain = -1;
};

/// Plays a recording to a domain, once or again and again, and says what it does.
class Replay {
 public:
  /// Requires: `options`, `recording`, `summary` and `termination` outlive this.
  Replay(const ReplayOptions& options, const mcap::ByteSource& recording,
         const mcap::Summary& summary, Tracks tracks, Termination& termination);

  /// Returns the program's exit code. Throws std::runtime_error if Cyclone refuses a topic.
  int run();

 private:
  /// What was played so far, and from where it goes on.
  struct Played {
    Duration from{};
    bool goes_on = false, to_its_end = true;
    std::uint64_t messages = 0;
    std::vector<mcap::Damage> damages = {};
    std::vector<mcap::TimeRange> silences = {};
  };
  using ClockWriter = wire::Writer<msg::Clock>;

  bool may_begin();
  bool clock_is_free(const std::vector<wire::EndpointInfo>& there) const;
  void say_what_comes(const std::vector<wire::EndpointInfo>& there) const;
  void begin();
  void warn_of_newcomers();
  bool pass();
  void play(Played& played);
  void tell_clock();
  void tell_damage(const std::vector<mcap::Damage>& damages,
                   const std::vector<mcap::TimeRange>& silences);
  [[nodiscard]] Pace pace(Duration from) const;

  const ReplayOptions& options_;
  const mcap::ByteSource& recording_;
  const mcap::Summary& summary_;
  Tracks tracks_;
  SteadyClock clock_;
  Playback playback_;
  std::unique_ptr<wire::Participant> participant_;
  std::unique_ptr<wire::Endpoints> others_;
  std::set<std::string> known_namesakes_;        ///< live ones that were told of
  std::unique_ptr<Stage> stage_;                 ///< of this pass; nothing between two
  std::unique_ptr<ClockWriter> recorded_clock_;  ///< nothing: nobody asked for it
  const Player* player_ = nullptr;               ///< nothing: nothing is played now
  std::uint64_t told_ns_ = 0;                    ///< what /clock told last; 0: nothing yet
  bool told_damage_ = false;
  bool damaged_ = false;
};

/// Writes the sentence as this program's error. Returns the exit code 1.
int fail_replay(const std::string& sentence);

/// Returns a text such as "5.9 s".
[[nodiscard]] std::string seconds_text(double duration_s);

}  // namespace galilean::monitor
