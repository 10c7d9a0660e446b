// SPDX-License-Identifier: BSD-3-Clause
// Reads random scenarios. One that is read has its numbers within their bounds and all that must
// stand in the arena inside it, also after it was enlarged. One that is not is refused in one line
// that names the file.
#include <cmath>
#include <string>

#include "sim/scenario/enlarge.h"
#include "sim/scenario/scenario.h"
#include "tests/fuzz/input.h"

namespace {

using namespace galilean::sim;
using galilean::Vec2;
using galilean::bhdl::must;

void check_places(const Scenario& scenario) {
  constexpr double kRounding_m = 1e-9;  // a place in a copy is a sum, the arena's size a product
  const auto is_inside = [&](const Vec2& at_m) {
    return at_m.minCoeff() >= 0 && at_m.x() <= scenario.arena.width_m + kRounding_m &&
           at_m.y() <= scenario.arena.depth_m + kRounding_m;
  };
  for (const auto& start : scenario.starts) {
    must(is_inside(start.position_m), "a robot starts in the arena");
    must(std::isfinite(start.heading_rad), "a robot has a heading");
  }
  for (const auto& basket_m : scenario.baskets_m) must(is_inside(basket_m), "a basket is inside");
  for (const auto& piece : scenario.placed) must(is_inside(piece.position_m), "a piece is inside");
}

void check_bounds(const Scenario& scenario) {
  must(scenario.arena.width_m >= 1 && scenario.arena.width_m <= 60, "an arena has a width");
  must(scenario.arena.depth_m >= 1 && scenario.arena.depth_m <= 60, "an arena has a depth");
  for (const int pieces : scenario.strewn) must(pieces >= 0 && pieces <= 500, "pieces are few");
  for (const auto& box : scenario.furniture)
    must(box.size_m.minCoeff() >= 0.04 && box.size_m.maxCoeff() <= 1000 && box.height_m <= 10,
         "furniture has a size");
  must(scenario.rules.duration_s >= 1 && scenario.rules.duration_s <= 86400, "a contest ends");
  must(scenario.camera.rate_hz >= 1 && scenario.camera.rate_hz <= 60, "a camera has a rate");
  must(!scenario.starts.empty(), "there is a place for a robot");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scenario = scenario_from_json(text, "a.json");
  if (!scenario) {
    const auto& why = scenario.error().message;
    must(why.starts_with("a.json: "), "an error names its file");
    must(why.find('\n') == why.npos, "an error is one line");
    return 0;
  }
  check_bounds(scenario.value());
  check_places(scenario.value());
  constexpr std::size_t kRobots = 7;
  const auto larger = enlarged_for(scenario.value(), kRobots);
  must(larger.starts.size() >= kRobots, "each robot has a place");
  check_places(larger);
  return 0;
}
