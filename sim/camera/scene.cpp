// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/scene.h"

#include <cmath>
#include <initializer_list>

namespace galilean::sim {
namespace {

using Vec2f = Eigen::Vector2f;
using Bands = std::initializer_list<Band>;

constexpr Colour kWallPaint{176, 172, 160};
constexpr Colour kWallBase{96, 92, 88};
constexpr Colour kSkirtBlue{38, 58, 150};
constexpr Colour kTableTop{196, 190, 178};
constexpr Colour kDeskSide{132, 106, 78};
constexpr Colour kDeskTop{158, 130, 98};
constexpr Colour kScreenCloth{142, 146, 152};
constexpr Colour kScreenFoot{84, 84, 88};
constexpr Colour kSeat{92, 78, 70};
constexpr Colour kTread{22, 22, 24};
constexpr Colour kAluminium{150, 152, 156};
constexpr Colour kRobotGreen{40, 170, 60};

Face make_face(const Vec2& a, const Vec2& b, Bands bands) {
  Face face{a.cast<float>(), b.cast<float>(), {}, 0, 1};
  for (const Band& band : bands) face.bands[face.band_count++] = band;
  // Light comes from one side of the hall, so that corners can be seen.
  const Vec2 along = (b - a).normalized();
  face.light = static_cast<float>(0.86 + 0.14 * (0.8 * along.x() - 0.6 * along.y()));
  return face;
}

/// Returns the corners counter-clockwise from front left [m], in the arena frame.
std::array<Vec2, 4> corners(const Pose2& pose, const Vec2& size_m) {
  const Vec2 half = size_m / 2;
  std::array<Vec2, 4> found{Vec2(half.x(), half.y()), Vec2(-half.x(), half.y()),
                            Vec2(-half.x(), -half.y()), Vec2(half.x(), -half.y())};
  for (Vec2& corner : found) corner = pose.position_m + rotated(corner, pose.heading_rad);
  return found;
}

/// Returns the four sides of a box as seen from outside.
std::array<Face, 4> box_faces(const Pose2& pose, const Vec2& size_m, Bands bands) {
  const auto at = corners(pose, size_m);
  return {make_face(at[0], at[1], bands), make_face(at[1], at[2], bands),
          make_face(at[2], at[3], bands), make_face(at[3], at[0], bands)};
}

void add_walls(const ArenaRules& arena, std::vector<Face>& faces) {
  const Pose2 centre{{arena.width_m / 2, arena.depth_m / 2}, 0};
  const auto at = corners(centre, {arena.width_m, arena.depth_m});
  const auto top = static_cast<float>(arena.wall_height_m);
  // The walls are seen from inside, so that their corners go the other way round.
  for (std::size_t i = 0; i < 4; ++i)
    faces.push_back(make_face(at[(i + 1) % 4], at[i],
                              {{0, 0.08f, kWallBase}, {0.08f, top, kWallPaint, Texture::kPanels}}));
}

std::array<Face, 4> furniture_faces(const Furniture& box) {
  const auto top = static_cast<float>(box.height_m);
  switch (box.kind) {
    case FurnitureKind::kTable:
      return box_faces(
          box.pose, box.size_m,
          {{0, top - 0.03f, kSkirtBlue, Texture::kFolds}, {top - 0.03f, top, kTableTop}});
    case FurnitureKind::kDesk:
      return box_faces(box.pose, box.size_m,
                       {{0, top - 0.04f, kDeskSide}, {top - 0.04f, top, kDeskTop}});
    case FurnitureKind::kScreen:
      break;
  }
  return box_faces(box.pose, box.size_m,
                   {{0, 0.05f, kScreenFoot}, {0.05f, top, kScreenCloth, Texture::kPanels}});
}

void add_chair(const Chair& chair, const Pose2& pose, Scene& scene) {
  const auto seat = static_cast<float>(chair.seat_height_m);
  const Vec2 size(chair.pitch_m + 0.05, chair.pitch_m + 0.05);
  for (const Face& face : box_faces(pose, size, {{seat - 0.05f, seat, kSeat}}))
    scene.chair_seats.push_back(face);
  for (const Vec2& leg : chair_legs_m(chair.pitch_m)) {
    const Vec2 at = pose.position_m + rotated(leg, pose.heading_rad);
    scene.chair_legs.push_back(
        {at.cast<float>(), static_cast<float>(kChairLegRadius_m), seat - 0.05f, DiscKind::kLeg});
  }
}

std::array<Face, 4> robot_faces(const Pose2& pose) {
  return box_faces(pose, {kChassisLength_m, kChassisWidth_m},
                   {{0, 0.06f, kTread},
                    {0.06f, 0.26f, kRobotGreen},
                    {0.26f, static_cast<float>(kChassisHeight_m), kAluminium}});
}

DiscKind disc_kind(PieceKind kind) {
  return static_cast<DiscKind>(kind);
}

}  // namespace

Scene scene_of(const Scenario& scenario) {
  Scene scene;
  add_walls(scenario.arena, scene.walls);
  for (const auto& box : scenario.furniture)
    for (const Face& face : furniture_faces(box)) scene.furniture.push_back(face);
  scene.lights = scenario.lights;
  return scene;
}

void look_at(const World& world, Scene& scene) {
  scene.loose.clear();
  for (const auto& piece : world.objects().pieces()) {
    if (!piece.body) continue;
    const PieceShape& shape = shape_of(piece.kind);
    scene.loose.push_back({from_b2(piece.body->GetPosition()).cast<float>(),
                           static_cast<float>(shape.radius_m), static_cast<float>(shape.height_m),
                           disc_kind(piece.kind)});
  }
  for (const b2Body* basket : world.objects().baskets())
    scene.loose.push_back({from_b2(basket->GetPosition()).cast<float>(),
                           static_cast<float>(kBasketRadius_m), static_cast<float>(kBasketHeight_m),
                           DiscKind::kBasket});
  scene.chair_seats.clear();
  scene.chair_legs.clear();
  for (std::size_t i = 0; i < world.scenario().chairs.size(); ++i)
    add_chair(world.scenario().chairs[i], pose_of(*world.objects().chairs()[i]), scene);
  scene.robots.clear();
  scene.robot_poses.clear();
  for (std::size_t i = 0; i < world.robot_count(); ++i) {
    scene.robot_poses.push_back(world.robot(i).pose());
    scene.robots.push_back(robot_faces(scene.robot_poses.back()));
  }
}

}  // namespace galilean::sim
