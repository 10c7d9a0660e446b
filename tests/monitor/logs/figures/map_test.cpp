// SPDX-License-Identifier: BSD-3-Clause
// Where robots were, by what a recording has of that.
#include <gmock/gmock.h>

#include "monitor/logs/figures/map_drawing.h"
#include "monitor/logs/figures/plot.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Source = MapTracks::Source;

msg::RobotState state_at(double x_m) {
  msg::RobotState state;
  state.robot = "io";
  state.x_m = x_m;
  return state;
}

msg::ObjectMap team_map_at(double x_m) {
  msg::ObjectMap map;
  auto& robot = map.robots.emplace_back();
  robot.name = "io";
  robot.x_m = x_m;
  robot.y_m = 1;
  auto& thing = map.objects.emplace_back();
  thing.object_class = "trash";
  thing.x_m = 3;
  return map;
}

/// Three metres by two, of which the left column is occupied and the right one unknown.
msg::OccupancyGrid floor_of_the_team() {
  msg::OccupancyGrid grid;
  grid.info.resolution = 1;
  grid.info.width = 3;
  grid.info.height = 2;
  grid.data = {100, 0, -1, 100, 0, -1};
  return grid;
}

class MapTest : public LoggedTeam {
 protected:
  [[nodiscard]] Result<ReadTracks> tracks_of(expect::RecordedTeam& recorded) const {
    write("run.mcap", recorded.end());
    const auto recording = Recording::open(path("run.mcap"));
    return read_tracks(recording.value(), 0, std::nullopt);
  }
  expect::RecordedTeam team;
};

TEST_F(MapTest, TheTeamsMapCountsMoreThanWhatARobotReckons) {
  for (int i = 0; i < 3; ++i) {
    team.send(i, "/io/state", state_at(-i));
    team.send(i, "/team/objects", team_map_at(i));
    team.send(i, "/team/map", floor_of_the_team());
  }
  const auto read = tracks_of(team);
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto& tracks = read.value().tracks;
  EXPECT_EQ(tracks.source, Source::kTeamMap);
  EXPECT_THAT(tracks.tracks.at("io").points_m(),
              ElementsAre(DrawnPoint{0, 1}, DrawnPoint{1, 1}, DrawnPoint{2, 1}));
  ASSERT_EQ(tracks.things.size(), 1U);
  ASSERT_TRUE(tracks.floor.has_value());
  EXPECT_THAT(tracks.floor->cells, ElementsAre(100, 0, -1, 100, 0, -1));
}

TEST_F(MapTest, WithoutAMapRobotsReckonOrTheSimulatorTells) {
  team.send(0, "/io/state", state_at(1));
  EXPECT_EQ(tracks_of(team).value().tracks.source, Source::kDeadReckoning);
  expect::RecordedTeam simulated;
  msg::SimulationState state;
  auto& body = state.bodies.emplace_back();
  body.name = "io";
  body.kind = "robot";
  simulated.send(0, "/io/state", state_at(1));
  simulated.send(0, "/simulation/state", state);
  EXPECT_EQ(tracks_of(simulated).value().tracks.source, Source::kTruth);
}

TEST_F(MapTest, PlacesBeyondAllMeasureAreToldAndNotDrawn) {
  for (const double far_m : {1.7e308, 1e17}) {
    expect::RecordedTeam lost;
    lost.send(0, "/io/state", state_at(far_m));
    if (far_m > 1e300) lost.send(1, "/io/state", state_at(-far_m));
    write("run.mcap", lost.end());
    for (const bool as_picture : {false, true}) {
      PlotOptions options{.file = path("run.mcap"), .map = true};
      if (as_picture) options.pictures.svg = path("x.svg");
      const auto answer = answer_of([&] { return plot(options); });
      EXPECT_EQ(answer.code, 1) << far_m;
      EXPECT_THAT(answer.errors, HasSubstr("a map cannot show places from x = "));
    }
  }
}

TEST_F(MapTest, ARecordingWithoutRobotsHasNoTracks) {
  team.send(0, "/io/variables", msg::Variables{});
  const auto read = tracks_of(team);
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, HasSubstr("tells of no robot where it was"));
}

TEST(MapTrack, IsBoundedHoweverFarARobotGoes) {
  MapTrack track;
  for (int i = 0; i < 1'000'000; ++i) track.add({static_cast<double>(i), 0});
  EXPECT_LE(track.points_m().size(), MapTrack::kMostPoints);
  EXPECT_EQ(track.points_m().front().x, 0);
  EXPECT_GT(track.points_m().back().x, 990'000);
}

TEST(MapDrawing, TheFloorLiesBelowTheTracksAndYGoesUp) {
  MapTracks tracks;
  tracks.floor = MapFloor{.resolution_m = 1,
                          .width = 3,
                          .height = 2,
                          .origin_m = {},
                          .cells = {100, 0, -1, 100, 0, -1}};
  tracks.tracks["io"].add({0.5, 0.5});
  tracks.tracks["io"].add({1.5, 1.5});
  const auto drawing = map_drawing(tracks);
  ASSERT_TRUE(std::holds_alternative<Patch>(drawing.shapes.front()));
  for (const auto& shape : drawing.shapes)
    if (const auto* way = std::get_if<Stroke>(&shape); way && way->points.size() == 2) {
      if (way->colour == "#000000") continue;  // the metre
      EXPECT_LT(way->points[0].x, way->points[1].x);
      EXPECT_GT(way->points[0].y, way->points[1].y);
    }
  EXPECT_EQ(map_text(tracks, 10, 10),
            "a io; capital letters are at the end; a letter is 0.25 m wide\n"
            "\n"
            " ####..A.\n"
            " ####....\n"
            " ##a#....\n"
            " ####....\n");
}

}  // namespace
}  // namespace galilean::logs
