// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/renderer.h"

#include <algorithm>

#include "sim/camera/disc_painter.h"
#include "sim/camera/face_painter.h"
#include "sim/camera/floor_painter.h"

namespace galilean::sim {
namespace {

/// Returns true if `a` must be painted before `b`, because it is farther away in the middle of the
/// columns that both cover. This is exact, because faces do not cross.
bool is_behind(const ProjectedFace& a, const ProjectedFace& b) noexcept {
  const float left = std::max(a.left_px, b.left_px);
  const float right = std::min(a.right_px, b.right_px);
  if (right - left < 0.5f) return false;
  const float middle = (left + right) / 2;
  return a.inverse_at(middle) < b.inverse_at(middle);
}

}  // namespace

Renderer::Renderer(const CameraGeometry& camera, const CameraRules& rules, Random random)
    : camera_(camera),
      noise_(rules.noise_levels, random.child("noise")),
      backdrop_(camera, noise_, random.child("backdrop")),
      random_(random.child("pictures")) {}

void Renderer::draw(const Scene& scene, std::size_t self, Frame& frame) {
  const Pose2& pose = scene.robot_poses[self];
  const View view(camera_, pose);
  Canvas canvas{frame, view, noise_, static_cast<std::uint32_t>(random_.bits())};
  backdrop_.paint(canvas, pose.heading_rad, static_cast<std::uint32_t>(random_.bits()));
  draw_lights(canvas, scene.lights);
  project(canvas, scene.walls);
  for (const auto& wall : in_view_) paint_face(canvas, *wall.face, wall.projected);
  draw_furniture(canvas, scene.furniture);
  gather_low(canvas, scene, self);
  draw_low(canvas);
}

void Renderer::project(const Canvas& canvas, const std::vector<Face>& faces) {
  in_view_.clear();
  for (const Face& face : faces)
    if (const auto projected = canvas.view.project(face.a_m, face.b_m))
      in_view_.push_back({&face, *projected});
}

void Renderer::draw_furniture(Canvas& canvas, const std::vector<Face>& faces) {
  project(canvas, faces);
  auto& left = in_view_;
  std::sort(left.begin(), left.end(), [](const FaceInView& a, const FaceInView& b) {
    return a.projected.inverse_left + a.projected.inverse_right <
           b.projected.inverse_left + b.projected.inverse_right;
  });
  for (std::size_t done = 0; done < left.size(); ++done) {
    auto next = left.begin() + static_cast<std::ptrdiff_t>(done);
    for (auto other = next + 1; other != left.end(); ++other)
      if (is_behind(other->projected, next->projected)) std::iter_swap(next, other);
    paint_face(canvas, *next->face, next->projected);
  }
  for (const auto& face : in_view_) mark_furniture(canvas, face.projected);
}

void Renderer::draw_lights(Canvas& canvas, const std::vector<Light>& lights) {
  const float eye_m = canvas.view.camera_height_m();
  for (const Light& light : lights) {
    // The floor is a dull mirror: a lamp's image lies where the angles to the eye and to the lamp
    // are equal.
    const float share = eye_m / (eye_m + static_cast<float>(light.height_m));
    const Eigen::Vector2f lamp = canvas.view.to_camera(light.position_m.cast<float>());
    paint_spot(canvas, {lamp * share, static_cast<float>(light.radius_m) * share * 1.3f, 255, 90});
    paint_spot(canvas, {lamp * share, static_cast<float>(light.radius_m) * share, 255, 215});
  }
}

void Renderer::gather(const Canvas& canvas, const std::vector<Disc>& discs) {
  for (const Disc& disc : discs) {
    const Eigen::Vector2f at = canvas.view.to_camera(disc.at_m);
    if (at.y() > 0) low_.push_back({at.y(), &disc, at, {}});
  }
}

void Renderer::gather(const Canvas& canvas, const Face* faces, std::size_t count, float depth_m) {
  for (std::size_t i = 0; i < count; ++i)
    if (const auto projected = canvas.view.project(faces[i].a_m, faces[i].b_m))
      low_.push_back({depth_m, nullptr, Eigen::Vector2f::Zero(), {&faces[i], *projected}});
}

void Renderer::gather_low(const Canvas& canvas, const Scene& scene, std::size_t self) {
  low_.clear();
  gather(canvas, scene.loose);
  gather(canvas, scene.chair_legs);
  for (const Face& seat : scene.chair_seats) {
    const Eigen::Vector2f middle = (seat.a_m + seat.b_m) / 2;
    gather(canvas, &seat, 1, canvas.view.to_camera(middle).y());
  }
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    if (i == self) continue;
    const Eigen::Vector2f at = canvas.view.to_camera(scene.robot_poses[i].position_m.cast<float>());
    gather(canvas, scene.robots[i].data(), scene.robots[i].size(), at.y());
  }
  std::sort(low_.begin(), low_.end(),
            [](const Low& a, const Low& b) { return a.depth_m > b.depth_m; });
}

void Renderer::draw_low(Canvas& canvas) {
  for (const Low& low : low_) {
    if (low.disc) {
      paint_spot(canvas, {low.in_camera_m, low.disc->radius_m * 1.35f, 0, 90});
      paint_disc(canvas, *low.disc, low.in_camera_m);
    } else {
      paint_face(canvas, *low.face.face, low.face.projected);
    }
  }
}

}  // namespace galilean::sim
