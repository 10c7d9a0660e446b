// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "sim/camera/backdrop.h"
#include "sim/camera/canvas.h"
#include "sim/camera/scene.h"

namespace galilean::sim {

/// Draws what a robot's camera sees: the backdrop, walls and furniture back to front, then all low
/// things back to front, except where furniture hides them. It allocates only in its first
/// pictures.
class Renderer {
 public:
  Renderer(const CameraGeometry& camera, const CameraRules& rules, Random random);

  /// `self` is the robot whose camera it is. That robot is not drawn.
  void draw(const Scene& scene, std::size_t self, Frame& frame);

 private:
  struct FaceInView {
    const Face* face;
    ProjectedFace projected;
  };
  /// A low thing by its depth: a disc, or a face of a robot or of a seat.
  struct Low {
    float depth_m;
    const Disc* disc;
    Eigen::Vector2f in_camera_m;
    FaceInView face;
  };

  void project(const Canvas& canvas, const std::vector<Face>& faces);
  void draw_furniture(Canvas& canvas, const std::vector<Face>& faces);
  void draw_lights(Canvas& canvas, const std::vector<Light>& lights);
  void gather_low(const Canvas& canvas, const Scene& scene, std::size_t self);
  void gather(const Canvas& canvas, const std::vector<Disc>& discs);
  void gather(const Canvas& canvas, const Face* faces, std::size_t count, float depth_m);
  void draw_low(Canvas& canvas);

  CameraGeometry camera_;
  NoiseTable noise_;
  Backdrop backdrop_;
  Random random_;
  std::vector<FaceInView> in_view_;
  std::vector<Low> low_;
};

}  // namespace galilean::sim
