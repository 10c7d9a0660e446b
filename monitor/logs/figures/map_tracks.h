// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/logs/pictures/drawing.h"
#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// The floor as a team's map had it: cells from the lower left corner, row by row.
struct MapFloor {
  double resolution_m = 0;            ///< the side of a cell
  std::size_t width = 0, height = 0;  ///< cells
  DrawnPoint origin_m;                ///< the lower left corner
  std::vector<int> cells;             ///< 0 free to 100 occupied, -1 unknown
};

/// Where something was, in metres.
struct MapPlace {
  std::string name;
  DrawnPoint at_m;
};

/// Where a robot was, over time, in bounded memory.
class MapTrack {
 public:
  static constexpr std::size_t kMostPoints = 16'384;

  void add(const DrawnPoint& at_m);
  [[nodiscard]] const std::vector<DrawnPoint>& points_m() const noexcept { return points_m_; }

 private:
  std::vector<DrawnPoint> points_m_;
  std::size_t every_ = 1, passed_ = 0;  ///< of so many points, one is kept
};

/// What a recording tells of robots' ways.
struct MapTracks {
  /// Whose word it is: the team's map, the simulator's truth, or each robot's dead reckoning, whose
  /// frames have nothing to do with each other.
  enum class Source { kTeamMap, kTruth, kDeadReckoning };
  Source source = Source::kTeamMap;
  std::map<std::string, MapTrack> tracks;  ///< by robot
  std::vector<MapPlace> things;            ///< at the end
  std::optional<MapFloor> floor;           ///< at the end; of kTeamMap only
};

/// What was read, and the exit code that says whether all could be.
struct ReadTracks {
  MapTracks tracks;
  int code = 0;
};

/// Reads robots' tracks of a part of a recording. It takes the team's map if that was recorded,
/// else the simulator's truth, else dead reckoning. Tells on standard error what is damaged.
/// Errors: the recording has none of these.
[[nodiscard]] Result<ReadTracks> read_tracks(const Recording& recording, double from_s,
                                             std::optional<double> to_s);

}  // namespace galilean::logs
