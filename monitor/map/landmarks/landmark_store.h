// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "monitor/map/estimation/robot_poses.h"
#include "monitor/map/landmarks/landmark.h"
#include "monitor/map/landmarks/landmark_ids.h"

namespace galilean::monitor {

/// The landmarks of a map, each with its block in the joint distribution. Adds and removes both
/// together. When it is full, a new landmark replaces the least certain one.
class LandmarkStore {
 public:
  static constexpr std::size_t kMaxLandmarks = 160;

  LandmarkStore(JointGaussian& joint, const RobotPoses& robots, LandmarkIds& ids)
      : joint_(joint), robots_(robots), ids_(ids) {}
  LandmarkStore(const LandmarkStore&) = delete;
  LandmarkStore& operator=(const LandmarkStore&) = delete;

  /// Adds a landmark that `robot` measured at `in_robot` (x forward, y left). Its position depends
  /// on the robot's pose. A landmark that is given its `id` is confirmed; 0 takes the next number.
  void add(const std::string& object_class, const std::string& robot, const Gaussian2& in_robot,
           double certainty, Time now, std::uint64_t id = 0);
  /// Moves a landmark to where `robot` measures it now. Its old position is forgotten, so that the
  /// measurement corrects nothing else.
  void relocate(Landmark& landmark, const std::string& robot, const Gaussian2& in_robot);
  /// Lets certainties decay, and removes what expired.
  void decay(Time now);
  void remove(std::uint64_t id);
  void remove_if(const std::function<bool(const Landmark&)>& matches);
  /// Makes one landmark of two that are the same object: corrects all that depends on either, and
  /// removes `duplicate`. Numbers that are not there are let pass.
  void merge(std::uint64_t kept, std::uint64_t duplicate);

  [[nodiscard]] const std::vector<Landmark>& all() const noexcept { return landmarks_; }
  [[nodiscard]] std::vector<Landmark>& all() noexcept { return landmarks_; }
  /// Returns the landmark's position in the map frame.
  [[nodiscard]] Gaussian2 position(const Landmark& landmark) const;
  /// Returns the bounding box of all positions [m].
  [[nodiscard]] Eigen::AlignedBox2d extent_m() const;

 private:
  Landmark* find(std::uint64_t id);
  void make_room();

  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkIds& ids_;
  std::vector<Landmark> landmarks_;
};

}  // namespace galilean::monitor
