// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/map_drawing.h"

#include <cmath>

#include "monitor/logs/figures/map_extent.h"

namespace galilean::logs {
namespace {

constexpr double kMapSide = 900, kMapLegend = 40;  // pixels
constexpr const char* kFreeColour = "#e8eef2";
constexpr const char* kOccupiedColour = "#505050";
constexpr const char* kThingColour = "#b8860b";
constexpr double kThingSide = 5, kRingRadius = 5;

/// Places metres on the picture.
struct MapScale {
  explicit MapScale(const MapExtent& of)
      : extent(of), pixels_per_m(kMapSide / std::max(of.width_m(), of.height_m())) {}
  [[nodiscard]] DrawnPoint at(const DrawnPoint& point_m) const {
    return {(point_m.x - extent.left_m) * pixels_per_m,
            kMapLegend + (extent.top_m - point_m.y) * pixels_per_m};
  }
  MapExtent extent;
  double pixels_per_m;
};

const char* floor_colour(int cell) {
  if (cell < 0) return nullptr;
  if (cell <= kFreeTo) return kFreeColour;
  return cell >= kOccupiedFrom ? kOccupiedColour : nullptr;
}

/// Draws neighbours of one colour in a row as one rectangle.
void draw_floor(const MapFloor& floor, const MapScale& scale, Drawing& to) {
  const double side = floor.resolution_m * scale.pixels_per_m;
  for (std::size_t row = 0; row < floor.height; ++row)
    for (std::size_t begin = 0, end = 0; begin < floor.width; begin = end) {
      const auto colour_at = [&](std::size_t column) {
        return floor_colour(floor.cells[row * floor.width + column]);
      };
      const char* colour = colour_at(begin);
      while (end < floor.width && colour_at(end) == colour) ++end;
      if (!colour) continue;
      const auto corner =
          scale.at({floor.origin_m.x + static_cast<double>(begin) * floor.resolution_m,
                    floor.origin_m.y + static_cast<double>(row + 1) * floor.resolution_m});
      to.shapes.push_back(
          Patch{corner.x, corner.y, side * static_cast<double>(end - begin), side, colour});
    }
}

Stroke ring_around(const DrawnPoint& centre, const char* colour) {
  constexpr int kCorners = 16;
  Stroke ring{{}, colour, 2};
  for (int i = 0; i <= kCorners; ++i) {
    const double angle_rad = 2 * M_PI * i / kCorners;
    ring.points.push_back({centre.x + kRingRadius * std::cos(angle_rad),
                           centre.y + kRingRadius * std::sin(angle_rad)});
  }
  return ring;
}

void draw_track(const std::string& robot, const MapTrack& track, const char* colour,
                const MapScale& scale, Drawing& to) {
  if (track.points_m().empty()) return;
  Stroke way{{}, colour, 2};
  for (const auto& point : track.points_m()) way.points.push_back(scale.at(point));
  const auto begin = way.points.front(), end = way.points.back();
  to.shapes.push_back(std::move(way));
  to.shapes.push_back(ring_around(begin, colour));
  to.shapes.push_back(
      Patch{end.x - kRingRadius, end.y - kRingRadius, 2 * kRingRadius, 2 * kRingRadius, colour});
  to.shapes.push_back(
      Label{.x = end.x + 2 * kRingRadius, .y = end.y + 4, .text = robot, .colour = colour});
}

/// Draws a bar of a metre, with its label.
void draw_metre(const MapScale& scale, Drawing& to) {
  const double y = kMapLegend - 12;
  to.shapes.push_back(Stroke{{{10, y}, {10 + scale.pixels_per_m, y}}, "#000000", 3});
  to.shapes.push_back(Label{.x = 10, .y = y - 6, .text = "1 m"});
}

}  // namespace

std::string source_text(MapTracks::Source source) {
  if (source == MapTracks::Source::kTeamMap) return "tracks as the team's map has them";
  if (source == MapTracks::Source::kTruth) return "tracks as the simulator has them";
  return "tracks by dead reckoning, each in its robot's own frame: where robots are to each other "
         "is not known";
}

Drawing map_drawing(const MapTracks& tracks) {
  const MapScale scale{MapExtent(tracks)};
  Drawing drawing{std::ceil(scale.extent.width_m() * scale.pixels_per_m),
                  std::ceil(kMapLegend + scale.extent.height_m() * scale.pixels_per_m),
                  {}};
  if (tracks.floor) draw_floor(*tracks.floor, scale, drawing);
  for (const auto& thing : tracks.things) {
    const auto at = scale.at(thing.at_m);
    drawing.shapes.push_back(
        Patch{at.x - kThingSide / 2, at.y - kThingSide / 2, kThingSide, kThingSide, kThingColour});
  }
  std::size_t robots = 0;
  for (const auto& [robot, track] : tracks.tracks)
    draw_track(robot, track, kColours[robots++ % kColours.size()], scale, drawing);
  draw_metre(scale, drawing);
  return drawing;
}

}  // namespace galilean::logs
