// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/recording_list.h"

#include <gmock/gmock.h>

#include "monitor/mcap/byte_sink.h"
#include "tests/monitor/recordings/written_recording.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class RecordingListTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<ListedRecording> all() {
    auto recordings = list.list();
    EXPECT_TRUE(recordings);
    return recordings.value();
  }
  [[nodiscard]] ListedRecording listed(const std::string& name) {
    for (const auto& recording : all())
      if (recording.name == name) return recording;
    ADD_FAILURE() << name << " is not listed";
    return {};
  }
  void age(const std::string& name, int hours) const {
    fs::last_write_time(inside / name,
                        fs::file_time_type::clock::now() - std::chrono::hours(hours));
  }

  TemporaryFolder inside;
  RecordingFolder folder{inside.path()};
  RecordingList list{folder};
};

TEST_F(RecordingListTest, TellsWhatEachHolds) {
  write_file(inside / "run.mcap", recording_of_states("io", 5));
  const auto run = listed("run.mcap");
  EXPECT_EQ(run.bytes, fs::file_size(inside / "run.mcap"));
  EXPECT_EQ(run.messages, 5u);
  EXPECT_EQ(run.start_ns, 1'700'000'000'000'000'000u);
  EXPECT_EQ(run.end_ns, 1'700'000'004'000'000'000u);
  EXPECT_THAT(run.robots, ElementsAre("io"));
  EXPECT_TRUE(run.complete);
  EXPECT_EQ(run.why, "");
}

TEST_F(RecordingListTest, BeginsWithTheNewest) {
  for (const char* name : {"a.mcap", "b.mcap", "c.mcap"})
    write_file(inside / name, recording_of_states("io", 1));
  age("a.mcap", 2);
  age("b.mcap", 1);
  age("c.mcap", 3);
  std::vector<std::string> names;
  for (const auto& each : all()) names.push_back(each.name);
  EXPECT_THAT(names, ElementsAre("b.mcap", "a.mcap", "c.mcap"));
}

TEST_F(RecordingListTest, SaysWhyOneCannotBeOpened) {
  write_file(inside / "empty.mcap", {});
  write_file(inside / "notes.mcap", {'n', 'o', 't', 'e', 's', ' ', 'o', 'f', ' ', 'i', 'o'});
  fs::create_directory(inside / "folder.mcap");
  fs::create_symlink("/etc/passwd", inside / "link.mcap");
  EXPECT_EQ(listed("empty.mcap").why, "'empty.mcap' is empty: nothing was recorded.");
  EXPECT_EQ(listed("notes.mcap").why, "'notes.mcap' is not an MCAP file.");
  EXPECT_THAT(listed("folder.mcap").why, HasSubstr("is a folder"));
  EXPECT_THAT(listed("link.mcap").why, HasSubstr("leads out"));
  for (const auto& each : all()) EXPECT_FALSE(each.complete) << each.name;
}

TEST_F(RecordingListTest, SaysOfWhatIsNoRecordingWhatIsWrongWithIt) {
  const mcap::Bytes magic(std::begin(mcap::kMagic), std::end(mcap::kMagic));
  write_file(inside / "eight.mcap", magic);
  auto junk = magic;
  junk.resize(5000, 0x5A);
  write_file(inside / "junk.mcap", junk);
  auto header = recording_of_states("io", 1);
  header.resize(sizeof mcap::kMagic + mcap::kRecordHead + header[sizeof mcap::kMagic + 1]);
  write_file(inside / "header.mcap", header);
  write_file(inside / "a\u202Eb.mcap", recording_of_states("io", 1));
  write_file(inside / "good.mcap", recording_of_states("io", 1));
  EXPECT_EQ(all().size(), 5U);
  EXPECT_EQ(listed("eight.mcap").why,
            "'eight.mcap' ends behind the first bytes of an MCAP file: nothing was recorded.");
  EXPECT_EQ(listed("junk.mcap").why,
            "'junk.mcap' has no header that can be read behind the first bytes, and is no "
            "recording.");
  EXPECT_EQ(listed("header.mcap").why,
            "'header.mcap' has nothing that can be read behind its header.");
  EXPECT_THAT(listed("aU+202Eb.mcap").why, HasSubstr("characters that can be seen"));
  EXPECT_EQ(listed("good.mcap").why, "");
}

TEST_F(RecordingListTest, ACutOneIsListedAsFarAsItGoes) {
  auto bytes = recording_of_states("io", 20);
  bytes.resize(bytes.size() / 3);  // the index is longer than the messages
  write_file(inside / "cut.mcap", bytes);
  const auto cut = listed("cut.mcap");
  EXPECT_FALSE(cut.complete);
  EXPECT_EQ(cut.why, "");
  EXPECT_GT(cut.messages, 2u);
  EXPECT_LT(cut.messages, 20u);
  EXPECT_THAT(cut.robots, ElementsAre("io"));
}

TEST_F(RecordingListTest, ADamagedOneIsNotComplete) {
  write_file(inside / "dam.mcap", damaged_recording());
  for (int again = 0; again < 2; ++again) EXPECT_FALSE(listed("dam.mcap").complete);
  EXPECT_EQ(listed("dam.mcap").messages, 20u) << "as the file states it";
}

TEST_F(RecordingListTest, LooksAgainAtWhatHasChanged) {
  write_file(inside / "run.mcap", recording_of_states("io", 2));
  EXPECT_EQ(listed("run.mcap").messages, 2u);
  write_file(inside / "run.mcap", recording_of_states("europa", 7));
  EXPECT_EQ(listed("run.mcap").messages, 7u);
  EXPECT_THAT(listed("run.mcap").robots, ElementsAre("europa"));
}

TEST_F(RecordingListTest, OneThatIsBeingWrittenIsNotComplete) {
  auto sink = mcap::FileSink::create((inside / "now.mcap").string(), false);
  ASSERT_TRUE(sink);
  ASSERT_TRUE(sink.value().write(recording_of_states("io", 3)));
  EXPECT_FALSE(listed("now.mcap").complete);
  EXPECT_EQ(listed("now.mcap").messages, 3u);
}

}  // namespace
}  // namespace galilean::monitor
