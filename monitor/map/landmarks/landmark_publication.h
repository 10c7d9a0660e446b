// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/map/landmarks/landmark_store.h"

namespace galilean::monitor {

/// Returns whether another landmark, whose position is known better, may be the same object: a
/// publication of both would count the object twice.
[[nodiscard]] bool is_duplicate_candidate(const JointGaussian& joint,
                                          const LandmarkStore& landmarks, const Landmark& landmark);
/// Returns whether a landmark is published: it is confirmed, its certainty is above 0, its position
/// is known well enough to be shown, and it is no duplicate candidate.
[[nodiscard]] bool is_published(const JointGaussian& joint, const LandmarkStore& landmarks,
                                const Landmark& landmark);

}  // namespace galilean::monitor
