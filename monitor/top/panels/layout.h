// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "monitor/top/model/view.h"
#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

inline constexpr int kLeastColumns = 80, kLeastRows = 24;

/// What fills the lower part of the screen: all panels, or one beside the map, or the map alone.
enum class Tab : std::uint8_t { kAll, kMachine, kVariables, kWhy, kMap };
[[nodiscard]] Tab after(Tab tab) noexcept;

/// The lines above the first one that each panel shows.
struct Scrolls {
  int machine = 0, variables = 0, why = 0;

  bool operator==(const Scrolls&) const = default;
};

/// What a screen shows besides the team.
struct Surroundings {
  Tab tab = Tab::kAll;
  Scrolls scrolls = {};
  std::string banner = {};  ///< below the title: the order to stop all
  std::string footer = {};  ///< the last line; empty: the keys
  std::string remark = {};  ///< at the right of the title: what cannot be done, or which time it is
};

enum class Panel : std::uint8_t { kTeam, kMap, kMachine, kVariables, kWhy };
/// Where a panel, a robot's line of the team or a state's line of the machine is on the screen.
struct Region {
  Panel panel = Panel::kTeam;
  Area area;
  std::string robot = {};
  std::string state = {};
};

struct Screen {
  Canvas canvas;
  std::vector<Region> regions = {};
  Scrolls scrolls = {};                ///< put right where a panel has fewer lines
  std::vector<AlarmLine> alarms = {};  ///< those that it shows
};

/// Returns the whole dashboard for a screen of this size. A screen of less than 80 × 24 cells says
/// that it is too small.
[[nodiscard]] Screen lay_out(const View& view, const Surroundings& around, int columns, int rows);

}  // namespace galilean::monitor::top
