#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/robot/perceptual/vision_test.h"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace galilean::robot {
namespace {

class AllocationTest : public VisionTest {};

TEST_F(AllocationTest, VisionAllocatesNothingNotEvenInItsFirstPicture) {
  forget_target(0.033);
  const auto finder = detector({{"threshold", 60.0}, {"companion_image", "green"s}});
  Perspective{.cylinders = {can({0, 1}), can({0.3, 2})}}.draw(frame_grabber.camera,
                                                              frame_grabber.picture);
  const long before = allocations;
  for (int i = 0; i < 10; ++i) {
    ++frame_grabber.picture.number;
    advance();
    look_->run(tick);
    finder->run(tick);
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(target().valid_at(tick.now));
}

}  // namespace
}  // namespace galilean::robot
