// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/address.h"

#include <gtest/gtest.h>

namespace galilean::wire {
namespace {

TEST(Address, IsThatOfOneMachineWithoutPortAndInterface) {
  EXPECT_EQ(address_in("udp/239.255.0.1:7401@2,udp/192.168.1.7:7411@2"), "192.168.1.7");
  EXPECT_EQ(address_in("udp/127.0.0.1:7411@1"), "127.0.0.1");
  EXPECT_EQ(address_in("udp/10.0.0.1:7411"), "10.0.0.1");
  EXPECT_EQ(address_in("udp6/[ff02::1]:7401@2,udp6/[fe80::1]:7411@2"), "[fe80::1]");
}

TEST(Address, IsEmptyWhereThereIsNone) {
  for (const char* text : {"", ",", "localprocess", "udp/", "udp/239.255.0.1:7401@2", "/:"})
    EXPECT_EQ(address_in(text), "") << text;
}

}  // namespace
}  // namespace galilean::wire
