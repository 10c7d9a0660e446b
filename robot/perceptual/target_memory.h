// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/schema/schema.h"
#include "core/static_vector.h"
#include "core/variable/variable.h"
#include "robot/vision/camera_model.h"

namespace galilean::robot {

/// A sighting that may be the target.
struct Candidate {
  Sighting sighting;
  double certainty = 0;
  bool range_is_bound = false;  ///< the picture ends before the object does, so that the true range
                                ///< is shorter
};
using Candidates = StaticVector<Candidate, Locate::kMaxSightings>;

/// The place from which the picture was taken.
struct View {
  const CameraModel& camera;
  Pose2 robot;
};

/// Decides which of several objects of a class a locate variable means, picture after picture.
/// - The nearest one, but the one of the picture before as long as no other is nearer by more than
///   `switch_distance_m`: it does not jump between two alike.
/// - What is remembered out of view gives way to what is nearer, or more certain than the memory.
/// - A remembered place that is in view and empty loses `miss_penalty` of its certainty a picture.
/// - Once the object's foot has left the picture at the bottom, its remembered place is kept: the
///   robot makes its final move to that.
class TargetMemory {
 public:
  double switch_distance_m = 0;
  double miss_penalty = 0;

  /// Requires: the nearest candidate stands first.
  void update(Variable<Locate>& target, Candidates& candidates, const View& view,
              const Tick& tick) const noexcept;

 private:
  [[nodiscard]] const Candidate* choose(const Variable<Locate>& target,
                                        const Candidates& candidates, const View& view,
                                        Time now) const noexcept;
};

}  // namespace galilean::robot
