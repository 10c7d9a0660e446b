// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/mcap_writer.h"
#include "tests/monitor/record/faulty_disk.h"

// MCAP's conformance suite (github.com/foxglove/mcap, tests/conformance) says which bytes a writer
// makes of an input in a variant. Our writer offers the variants with statistics, all indexes and
// summary offsets, and its chunks are compressed, so that files with messages are of no variant.
// The sizes and checksums here are those of the suite's files.

namespace galilean::mcap {
namespace {

Bytes written(const std::vector<Metadata>& metadata) {
  FaultyDisk disk;
  Writer writer(disk, {.profile = "", .library = ""});
  EXPECT_TRUE(writer.begin());
  for (const auto& each : metadata) EXPECT_TRUE(writer.write(each));
  EXPECT_TRUE(writer.end());
  return disk.bytes();
}

TEST(ConformanceBytes, NoDataWithStatisticsAndSummaryOffsets) {
  const Bytes file = written({});
  EXPECT_EQ(file.size(), 156u);
  EXPECT_EQ(crc32(file), 0x76dabc08u);
}

TEST(ConformanceBytes, OneMetadataWithItsIndexStatisticsAndSummaryOffsets) {
  const Bytes file = written({{"myMetadata", {{"foo", "bar"}}}});
  EXPECT_EQ(file.size(), 262u);
  EXPECT_EQ(crc32(file), 0x343f7bb5u);
}

}  // namespace
}  // namespace galilean::mcap
