// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/faults.h"

#include <gtest/gtest.h>

namespace galilean::sim {
namespace {

TEST(Faults, ReadsDeviceRobotAndTime) {
  const auto fault = parse_fault("serial:io@20-30.5");
  ASSERT_TRUE(fault);
  const std::vector<DeviceFault> faults{fault.value()};
  EXPECT_FALSE(is_faulty(faults, FaultyDevice::kSerial, "io", 19.9));
  EXPECT_TRUE(is_faulty(faults, FaultyDevice::kSerial, "io", 20));
  EXPECT_FALSE(is_faulty(faults, FaultyDevice::kSerial, "io", 30.5));
  EXPECT_FALSE(is_faulty(faults, FaultyDevice::kCamera, "io", 25));
  EXPECT_FALSE(is_faulty(faults, FaultyDevice::kSerial, "ganymede", 25));
}

TEST(Faults, RefusesWhatItCannotRead) {
  for (const char* text : {"", "camera", "camera:io", "gripper:io@1-2", "camera:io@5-5",
                           "camera:io@-1-5", "camera:io@a-b"})
    EXPECT_FALSE(parse_fault(text)) << text;
}

}  // namespace
}  // namespace galilean::sim
