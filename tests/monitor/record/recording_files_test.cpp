// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recording_files.h"

#include <gmock/gmock.h>

#include <fstream>

#include "monitor/mcap/mcap_reader.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

constexpr Time kStart{};
constexpr Duration kSpan = std::chrono::seconds(10);

class RecordingFilesTest : public testing::Test {
 protected:
  FilePlan plan() const { return {.out = folder / "run.mcap"}; }
  FilePlan split_plan() const {
    FilePlan split = plan();
    split.split_span = kSpan;
    return split;
  }
  void touch(const std::string& name) const { std::ofstream(folder / name) << "mine"; }
  bool is_there(const std::string& name) const { return std::filesystem::exists(folder / name); }
  static void write_message(RecordingFiles& files, std::uint64_t time_ns) {
    auto& writer = files.writer();
    const auto channel = writer.add_channel({.topic = "/t", .message_encoding = "cdr"});
    ASSERT_TRUE(writer.write(mcap::Message{channel, 1, time_ns, time_ns, {}}));
  }
  /// Begins and ends so many files.
  static void run_through(RecordingFiles& files, int count) {
    for (int i = 0; i < count; ++i) {
      ASSERT_TRUE(files.begin(kStart));
      ASSERT_TRUE(files.end());
    }
  }

  const TemporaryFolder folder;
};

TEST_F(RecordingFilesTest, ARecordingOfOneFileHasTheNameThatWasAskedFor) {
  RecordingFiles files(plan());
  run_through(files, 1);
  EXPECT_TRUE(is_there("run.mcap"));
  EXPECT_EQ(files.name(), (folder / "run.mcap").string());
}

TEST_F(RecordingFilesTest, AFileIsFullWhenItIsOldEnough) {
  RecordingFiles files(split_plan());
  ASSERT_TRUE(files.begin(kStart + kSpan));
  EXPECT_FALSE(files.is_full(kStart + 2 * kSpan - Duration(1)));
  EXPECT_TRUE(files.is_full(kStart + 2 * kSpan));
}

TEST_F(RecordingFilesTest, AFileIsFullWhenItIsLargeEnough) {
  FilePlan large = plan();
  large.split_bytes = 200;
  RecordingFiles files(large);
  ASSERT_TRUE(files.begin(kStart));
  EXPECT_FALSE(files.is_full(kStart));
  ASSERT_TRUE(files.writer().write(mcap::Metadata{"much", {{"text", std::string(200, 'x')}}}));
  EXPECT_TRUE(files.is_full(kStart));
}

TEST_F(RecordingFilesTest, SeveralAreNumberedAndNamedFromTheFirstToTheLast) {
  RecordingFiles files(split_plan());
  run_through(files, 3);
  for (const char* name : {"run_0.mcap", "run_1.mcap", "run_2.mcap"}) EXPECT_TRUE(is_there(name));
  EXPECT_EQ(files.name(),
            (folder / "run_0.mcap").string() + " to " + (folder / "run_2.mcap").string());
}

TEST_F(RecordingFilesTest, TheOldestGoWhenThereAreTooMany) {
  FilePlan few = split_plan();
  few.most_files = 2;
  RecordingFiles files(few);
  run_through(files, 4);
  EXPECT_FALSE(is_there("run_1.mcap"));
  EXPECT_TRUE(is_there("run_2.mcap"));
  EXPECT_TRUE(is_there("run_3.mcap"));
  EXPECT_EQ(files.totals().files, 4U);
}

TEST_F(RecordingFilesTest, AFileOfSomebodyElseIsNeitherEmptiedNorDeleted) {
  touch("run_1.mcap");
  FilePlan few = split_plan();
  few.most_files = 1;
  RecordingFiles files(few);
  run_through(files, 3);
  EXPECT_EQ(std::filesystem::file_size(folder / "run_1.mcap"), 4U);
  EXPECT_TRUE(is_there("run_3.mcap"));
}

TEST_F(RecordingFilesTest, TheFirstIsRefusedWhereOneOfItsNameIsThere) {
  touch("run_0.mcap");
  RecordingFiles files(split_plan());
  const auto begun = files.begin(kStart);
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().message, HasSubstr("run_0.mcap exists already"));
}

TEST_F(RecordingFilesTest, TotalsAreThoseOfAllFiles) {
  RecordingFiles files(split_plan());
  for (const std::uint64_t time_ns : {500, 700}) {
    ASSERT_TRUE(files.begin(kStart));
    write_message(files, time_ns);
    ASSERT_TRUE(files.end());
  }
  ASSERT_TRUE(files.begin(kStart));
  write_message(files, 900);
  const auto totals = files.totals();
  EXPECT_EQ(totals.messages, 3U);
  EXPECT_EQ(totals.start_ns, 500U);
  EXPECT_EQ(totals.end_ns, 900U);
  EXPECT_EQ(totals.files, 3U);
}

TEST_F(RecordingFilesTest, AreNotCompressedWhereThatIsAskedFor) {
  FilePlan plain = plan();
  plain.compression = mcap::Compression::kNone;
  RecordingFiles files(plain);
  ASSERT_TRUE(files.begin(kStart));
  write_message(files, 500);
  ASSERT_TRUE(files.end());
  const auto source = mcap::FileSource::open(folder / "run.mcap");
  const auto summary = mcap::summarize(source.value()).value();
  EXPECT_EQ(summary.compressions.at(""), 1U);
  EXPECT_EQ(summary.statistics.messages, 1U);
}

}  // namespace
}  // namespace galilean::monitor
