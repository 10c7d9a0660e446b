#include <gtest/gtest.h>

#include "monitor/map/team_map.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

constexpr double kCameraView_rad = 73.5 * kPi / 180;

TEST(Squads, ATeamThatFitsIntoOneIsNotDivided) {
  Squads squads(4);
  for (const double x_m : {0.0, 30.0, 60.0, 90.0}) {
    const std::string robot = std::to_string(x_m);
    squads.join(robot, {{x_m, 0}, 0}).poses.move(robot, {{x_m, 0}, 0}, false, Time(1s));
  }
  EXPECT_EQ(squads.all().size(), 1U);
}

TEST(Squads, ALargerTeamIsDividedByNearness) {
  Squads squads(2);
  const auto join = [&](const std::string& robot, double x_m) -> Squad& {
    Squad& squad = squads.join(robot, {{x_m, 0}, 0});
    squad.poses.move(robot, {{x_m, 0}, 0}, false, Time(1s));
    return squad;
  };
  join("a", 0);
  join("b", 1);
  Squad &c = join("c", 2), &d = join("d", 30);
  EXPECT_NE(&c, &d) << "too far away";
  EXPECT_EQ(&join("e", 4), &c);
  EXPECT_EQ(&join("f", 28), &d);
  EXPECT_EQ(&join("c", 50), &c) << "it stays where it is";
}

/// Two robots, each a squad of its own: they share nothing but what they tell one another.
class DividedTeamTest : public testing::Test {
 protected:
  /// `robot` stands at `truly` and its odometer at 0: what it sees of the landmarks, exactly.
  [[nodiscard]] static msg::Sightings frame(const std::string& robot, const Pose2& truly,
                                            const std::vector<Vec2>& trash,
                                            double view_rad = kCameraView_rad) {
    msg::Sightings result;
    result.robot = robot;
    result.view_angle_rad = static_cast<float>(view_rad);
    for (const Vec2& at_m : trash) {
      const Vec2 seen_m = rotated(at_m - truly.position_m, -truly.heading_rad);
      msg::Sighting& item = result.items.emplace_back();
      item.object_class = "trash";
      item.x_m = seen_m.x();
      item.y_m = seen_m.y();
      item.variance_xx = item.variance_yy = 4e-4;
      item.range_m = static_cast<float>(seen_m.norm());
      item.azimuth_rad = static_cast<float>(std::atan2(seen_m.y(), seen_m.x()));
      item.left_px = item.top_px = item.right_px = item.bottom_px = 100;
    }
    return result;
  }
  void look(const msg::Sightings& frame, int frames = 10) {
    for (int i = 0; i < frames; ++i) {
      now += 100ms;
      map.note(frame, now);
      map.update(now);
    }
  }
  msg::ObjectMap told() {
    map.update(now);
    return map.objects(now, now.time_since_epoch().count());
  }
  [[nodiscard]] Vec2 robot_m(std::size_t index) {
    const auto robot = told().robots.at(index);
    return {robot.x_m, robot.y_m};
  }

  TeamMap map{2s, 1};
  Time now{1s};
  const Pose2 io{{0, 0}, 0}, ganymede{{2, 0}, kPi};
};

TEST_F(DividedTeamTest, ACanThatTwoSquadsSeeIsOne) {
  map.start_at("io", io);
  map.start_at("ganymede", ganymede);
  look(frame("io", io, {{1, 0}}));
  const auto before = told().objects;
  ASSERT_EQ(before.size(), 1U);
  look(frame("ganymede", ganymede, {{1.03, 0.02}}));
  const auto after = told().objects;
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].id, before[0].id);
  EXPECT_EQ(after[0].seen_by, (std::vector<std::string>{"ganymede", "io"}));
}

TEST_F(DividedTeamTest, TwoCansFifteenCentimetresApartStayTwo) {
  map.start_at("io", io);
  map.start_at("ganymede", ganymede);
  for (int i = 0; i < 10; ++i) {
    look(frame("io", io, {{1, 0.075}, {1, -0.075}}), 1);
    look(frame("ganymede", ganymede, {{1, 0.065}, {0.99, -0.085}}), 1);
  }
  const auto seen = told().objects;
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].seen_by.size(), 2U);
  EXPECT_NEAR(std::abs(seen[0].y_m - seen[1].y_m), 0.15, 0.03);
}

/// Nobody said where either starts: the map is callisto's, and io stands elsewhere in it.
class UnplacedSquadTest : public DividedTeamTest {
 protected:
  UnplacedSquadTest() {
    for (int i = 0; i < 40; ++i) both_look(trash);
  }
  void both_look(const std::vector<Vec2>& io_sees) {
    look(frame("callisto", {}, trash, 7), 1);
    look(frame("io", elsewhere, io_sees, 7), 1);
  }

  const Pose2 elsewhere{{3.4, 1.5}, 2.1};
  const std::vector<Vec2> trash{{1.3, 2.1}, {2.9, 1.2}, {5.5, 2.7}, {6.3, 4.4}, {2.2, 5.1},
                                {4.1, 4.9}, {0.7, 4.2}, {3.6, 3.4}, {4.8, 0.6}, {7.4, 5.2}};
};

TEST_F(UnplacedSquadTest, IsFoundByWhatItSaw) {
  EXPECT_LT(robot_m(0).norm(), 0.05) << "its frame is the map's";
  EXPECT_LT((robot_m(1) - elsewhere.position_m).norm(), 0.05);
  EXPECT_EQ(told().objects.size(), trash.size());
}

TEST_F(UnplacedSquadTest, WhatAnotherSquadMissesInPlainViewIsForgotten) {
  auto with_another = trash;
  with_another.push_back(elsewhere.position_m + Vec2(1.2, 0.9));
  look(frame("callisto", {}, with_another, 7));
  EXPECT_EQ(told().objects.size(), with_another.size());
  look(frame("io", elsewhere, trash, 7), 30);
  EXPECT_EQ(told().objects.size(), trash.size());
}

TEST_F(UnplacedSquadTest, WhereARobotStandsLiesNoTrashOfAnotherSquad) {
  auto with_another = trash;
  with_another.push_back(elsewhere.position_m + 0.3 * unit_vector(elsewhere.heading_rad));
  look(frame("callisto", {}, with_another, 7));
  EXPECT_EQ(told().objects.size(), with_another.size());
  msg::RobotState there;
  there.robot = "io";
  there.x_m = 0.3;
  map.note(there, now += 1s);
  EXPECT_EQ(told().objects.size(), trash.size());
}

/// Both believe to stand at 0, and io does: its frame is the map's.
class NeighboursTest : public testing::Test {
 protected:
  NeighboursTest() {
    learns.placed = true;
    note("io", knows, {0, 0});
    note("ganymede", learns, truly_m);
  }
  void note(const std::string& robot, Squad& squad, const Vec2& stands_m) {
    squad.poses.move(robot, {}, false, now);
    for (const Vec2& at_m : {Vec2(1, 0.5), Vec2(1.2, -0.3), Vec2(0.8, 0.1)})
      squad.landmarks.add_contact("trash", robot, {at_m - stands_m, 1e-4 * Mat2::Identity()}, 1,
                                  now, squads.next_id());
  }
  void teach() {
    const auto notes = squads_notes(squads);
    Neighbours::teach(notes, same_pairs(notes));
  }

  Squads squads{1};
  Squad& knows = squads.join("io", {});
  Squad& learns = squads.join("ganymede", {});
  const Vec2 truly_m{0.1, 0.05};
  const Time now{1s};
};

TEST_F(NeighboursTest, ASquadBelievesAnotherThatKnowsFarBetter) {
  teach();
  EXPECT_LT((learns.poses.pose("ganymede").position_m - truly_m).norm(), 0.05);
  EXPECT_EQ(knows.poses.pose("io").position_m.norm(), 0);
}

TEST_F(NeighboursTest, HearsayIsNeverAsSureAsWhatOneSawOneself) {
  for (int i = 0; i < 100; ++i) teach();
  const double variance_m2 = learns.poses.position("ganymede").covariance_m2.trace();
  EXPECT_GT(variance_m2, 2 * 0.025 * 0.025);
  EXPECT_GT(variance_m2, 4 * knows.poses.position("io").covariance_m2.trace());
}

TEST(Carried, WhatIsPickedUpLeavesTheFloorWhoeverNotedIt) {
  Squads squads(1);
  squads.start_at("io", {});
  squads.start_at("ganymede", {{0.6, 0}, kPi});
  const Time now{1s};
  constexpr double kNear_m2 = 1e-4;
  for (const std::string robot : {"io", "ganymede"}) {
    Squad& squad = squads.join(robot, {});
    squad.poses.move(robot, {}, false, now);
    for (int i = 0; i < 3; ++i)
      squad.landmarks.add_contact("trash", robot, {{0.3, 0}, kNear_m2 * Mat2::Identity()}, 1, now,
                                  squads.next_id());
    for (int i = 0; i < 2; ++i) squad.landmarks.remove(squad.landmarks.all().front().id);
  }
  auto notes = squads_notes(squads);
  const auto pairs = same_pairs(notes);
  const auto told = united(std::move(notes), pairs);
  ASSERT_EQ(told.size(), 1U);
  Carried carried(squads);
  carried.note("io", true, told, now);
  ASSERT_EQ(carried.all().size(), 1U);
  EXPECT_EQ(carried.all().at("io").id, told[0].id);
  EXPECT_EQ(carried.all().at("io").seen_by.size(), 2U);
  EXPECT_TRUE(squads_notes(squads).empty());
  carried.note("io", false, told, now);
  EXPECT_EQ(squads_notes(squads).size(), 1U) << "put down where no basket is";
}

// A leg of a table, say, which nobody took for trash.
TEST(Carried, WhatBreaksTheBeamAndStoodOnNoMapIsNotPutDown) {
  Squads squads(4);
  const Time now{1s};
  squads.join("io", {}).poses.move("io", {}, false, now);
  Carried carried(squads);
  carried.note("io", true, {}, now);
  EXPECT_EQ(carried.all().size(), 1U);
  carried.note("io", false, {}, now);
  EXPECT_TRUE(carried.all().empty());
  EXPECT_TRUE(squads.of("io").landmarks.all().empty());
}

}  // namespace
}  // namespace galilean::monitor
