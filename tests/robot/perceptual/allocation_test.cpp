// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/count_allocations.h"
#include "tests/robot/perceptual/vision_test.h"

namespace galilean::robot {
namespace {

class AllocationTest : public VisionTest {};

TEST_F(AllocationTest, VisionAllocatesNothingNotEvenInItsFirstPicture) {
  forget_target(0.033);
  const auto finder = detector({{"threshold", 60.0}, {"companion_image", "green"s}});
  Perspective{.cylinders = {can({0, 1}), can({0.3, 2})}}.draw(frame_grabber.camera,
                                                              frame_grabber.picture);
  long allocations = 0;
  for (int i = 0; i < 10; ++i) {
    ++frame_grabber.picture.number;
    advance();
    const AllocationCount count;
    look_->run(tick);
    finder->run(tick);
    allocations += count.so_far();
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_TRUE(target().valid_at(tick.now));
}

}  // namespace
}  // namespace galilean::robot
