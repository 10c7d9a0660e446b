// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "monitor/map/landmarks/data_association.h"

namespace galilean::monitor {

/// Corrects a robot that is far off by a single basket. Baskets stay where they are and stand
/// apart, so that a basket that is seen where none is known, but beside one that is known, is that
/// one, and the robot is elsewhere than it is believed to be.
///
///   law  A basket is recognized if it is seen within kBasketsApart_m of a known one. A robot that
///        is known to be lost may be further off, if no other basket comes into question. The robot
///        is corrected after kStrangeFrames such frames in a row
class BasketRecognition {
 public:
  static constexpr double kBasketsApart_m = 1.2;  ///< no two baskets stand nearer to one another
  static constexpr int kStrangeFrames = 5;

  BasketRecognition(JointGaussian& joint, const RobotPoses& robots, const LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Associates baskets that have no landmark yet with the known basket that they are, and corrects
  /// `robot` by them.
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
