// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monitor/map/groups/published_landmarks.h"

namespace galilean::monitor {

/// Lets groups learn from one another, although nobody knows which errors their estimates share.
///
///   law     Where one group knows the position of a landmark far better than another, the other
///           takes it in as a measurement. The measurement's error is never taken to be below a
///           fixed one, so that an estimate that goes back and forth does not become certain by
///           being repeated. Sure pairs count, of objects that were not moved between the two
///           estimates
///   reads   `landmarks` of landmarks_by_group, and `pairs` among them
void share_landmarks(const PublishedLandmarks& landmarks, const std::vector<DuplicatePair>& pairs);

}  // namespace galilean::monitor
