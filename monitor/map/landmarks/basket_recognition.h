// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "monitor/map/landmarks/data_association.h"

namespace galilean::monitor {

/// Corrects a robot whose pose is far off, by a single basket. Baskets do not move, and they stand
/// apart from one another. A basket that is seen beside a known one is therefore the known one, and
/// the robot's pose is wrong.
///
///   law  A basket is recognized if it is seen within kBasketsApart_m of a known one. If the pose
///        is uncertain, the distance may be larger, provided that no other basket comes into
///        question. The robot is corrected after kStrangeFrames such frames in a row
class BasketRecognition {
 public:
  static constexpr double kBasketsApart_m = 1.2;  ///< no two baskets stand nearer to one another
  static constexpr int kStrangeFrames = 5;

  BasketRecognition(JointGaussian& joint, const RobotPoses& robots, const LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Associates the seen baskets that have no landmark yet with known baskets, and corrects `robot`
  /// by them.
  void recognize(const std::string& robot, std::vector<Observation>& observations);

 private:
  [[nodiscard]] std::optional<std::size_t> basket_beside(const Observation& basket,
                                                         const std::string& robot) const;
  void relocalize(const std::string& robot, const Landmark& basket, const Measurement& measurement);

  JointGaussian& joint_;
  const RobotPoses& robots_;
  const LandmarkStore& landmarks_;
  /// By robot: how many frames in a row showed a basket where none is known.
  std::map<std::string, int> strange_frames_;
};

}  // namespace galilean::monitor
