// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robot/devices/frame_source.h"
#include "sim/camera/renderer.h"

namespace galilean::sim {

/// The camera of one robot in the simulated world, as a frame source. `expose` takes a picture. The
/// next `grab` draws it straight into the robot's memory.
class SimulatedCamera final : public robot::FrameSource {
 public:
  SimulatedCamera(const Scene& scene, std::size_t robot, Renderer& renderer)
      : scene_(scene), robot_(robot), renderer_(renderer) {}

  void expose() noexcept { exposed_ = true; }

  bool grab(Frame& frame, Time) override {
    if (!exposed_) return false;
    renderer_.draw(scene_, robot_, frame);
    exposed_ = false;
    return true;
  }
  [[nodiscard]] std::string problem() const override { return {}; }

 private:
  const Scene& scene_;
  std::size_t robot_;
  Renderer& renderer_;
  bool exposed_ = false;
};

}  // namespace galilean::sim
