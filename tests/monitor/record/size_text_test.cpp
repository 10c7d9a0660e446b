// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/size_text.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

TEST(SizeText, IsANumberOfBytesOrHasAUnit) {
  EXPECT_EQ(bytes_of("0").value(), 0U);
  EXPECT_EQ(bytes_of("1500").value(), 1500U);
  EXPECT_EQ(bytes_of("500MB").value(), 500'000'000U);
  EXPECT_EQ(bytes_of("2 GB").value(), 2'000'000'000U);
  EXPECT_EQ(bytes_of("1.5kB").value(), 1500U);
  EXPECT_EQ(bytes_of("64KiB").value(), 65'536U);
  EXPECT_EQ(bytes_of("1GiB").value(), 1'073'741'824U);
}

TEST(SizeText, WhatIsNoSizeIsRefusedWithWhatToWrite) {
  for (const std::string text : {"", "MB", "-1MB", "nan", "inf", "1e30", "5 parsecs", "5 M B s"})
    EXPECT_FALSE(bytes_of(text)) << text;
  EXPECT_EQ(bytes_of("many").error().message,
            "'many' is no size: write a number and a unit, such as 500MB or 2GB");
}

TEST(SizeText, IsToldInTheLargestUnitOfWhichThereIsOne) {
  EXPECT_EQ(size_text(0), "0 bytes");
  EXPECT_EQ(size_text(999), "999 bytes");
  EXPECT_EQ(size_text(10'000), "10 kB");
  EXPECT_EQ(size_text(64'999'999), "64 MB");
}

}  // namespace
}  // namespace galilean::monitor
