// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/upload.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/monitor/recordings/written_recording.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class UploadTest : public testing::Test {
 protected:
  [[nodiscard]] std::size_t files() const {
    std::error_code none;
    const auto at = fs::directory_iterator(inside.path() / "recordings", none);
    return none ? 0 : static_cast<std::size_t>(std::distance(begin(at), end(at)));
  }
  [[nodiscard]] mcap::Bytes content(const std::string& name) const {
    std::ifstream in(inside.path() / "recordings" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  TemporaryFolder inside;
  RecordingFolder folder{inside.path() / "recordings"};
  const mcap::Bytes recording = recording_of_states("io", 5);
  const Upload::Limits limits{.most_bytes = 1'000'000, .least_free_bytes = 0};
};

TEST_F(UploadTest, IsThereWhenItIsWholeAndNotBefore) {
  auto upload = Upload::begin(folder, "run.mcap", recording.size(), limits);
  ASSERT_TRUE(upload) << upload.error().message;
  for (std::size_t at = 0; at < recording.size(); at += 7)
    ASSERT_TRUE(upload.value().append(
        std::span(recording).subspan(at, std::min<std::size_t>(7, recording.size() - at))));
  EXPECT_TRUE(folder.names().value().empty());
  ASSERT_TRUE(upload.value().finish());
  EXPECT_EQ(content("run.mcap"), recording);
  EXPECT_EQ(files(), 1u);
}

TEST_F(UploadTest, OneThatBreaksOffLeavesNothing) {
  {
    auto upload = Upload::begin(folder, "run.mcap", recording.size(), limits);
    ASSERT_TRUE(upload);
    ASSERT_TRUE(upload.value().append(std::span(recording).first(100)));
    EXPECT_EQ(files(), 1u) << "the draft";
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(UploadTest, NeverTakesTheNameOfAnother) {
  fs::create_directories(folder.path());
  write_file(folder.path() / "run.mcap", {1, 2, 3});
  EXPECT_EQ(Upload::begin(folder, "run.mcap", {}, limits).error().why, NotKept::Why::kExists);
  auto first = Upload::begin(folder, "both.mcap", {}, limits);
  auto second = Upload::begin(folder, "both.mcap", {}, limits);
  ASSERT_TRUE(first && second);
  ASSERT_TRUE(first.value().append(recording) && second.value().append(recording));
  EXPECT_TRUE(first.value().finish());
  const auto late = second.value().finish();
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().why, NotKept::Why::kExists);
  EXPECT_EQ(content("run.mcap"), (mcap::Bytes{1, 2, 3}));
  EXPECT_EQ(content("both.mcap"), recording);
}

TEST_F(UploadTest, IsRefusedBeyondTheLimits) {
  const auto why = [&](std::optional<std::uint64_t> bytes, const Upload::Limits& within) {
    return Upload::begin(folder, "run.mcap", bytes, within).error().why;
  };
  EXPECT_EQ(why(1'000'001, limits), NotKept::Why::kTooLarge);
  EXPECT_EQ(why({}, {.most_bytes = 1'000'000, .least_free_bytes = UINT64_MAX / 2}),
            NotKept::Why::kNoRoom);
  auto liar = Upload::begin(folder, "run.mcap", 10, {.most_bytes = 50, .least_free_bytes = 0});
  ASSERT_TRUE(liar);
  const auto more = liar.value().append(recording);
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().why, NotKept::Why::kTooLarge);
}

TEST_F(UploadTest, TakesRecordingsOnly) {
  EXPECT_EQ(Upload::begin(folder, "../run.mcap", {}, limits).error().why, NotKept::Why::kNoName);
  auto text = Upload::begin(folder, "text.mcap", {}, limits);
  ASSERT_TRUE(text);
  const mcap::Bytes hello{'h', 'e', 'l', 'l', 'o'};
  EXPECT_EQ(text.value().append(hello).error().why, NotKept::Why::kNoRecording);
  auto empty = Upload::begin(folder, "empty.mcap", 0, limits);
  ASSERT_TRUE(empty);
  EXPECT_EQ(empty.value().finish().error().message, "'empty.mcap' is not an MCAP file.");
}

TEST_F(UploadTest, LooksAtWhatCameBeforeItHasItsName) {
  const mcap::Bytes magic(std::begin(mcap::kMagic), std::end(mcap::kMagic));
  auto junk = magic;
  junk.resize(5000, 0x5A);
  auto header = recording;
  header.resize(sizeof mcap::kMagic + mcap::kRecordHead + header[sizeof mcap::kMagic + 1]);
  auto junk_behind_header = header;
  junk_behind_header.resize(5000, 0x5A);
  for (const auto& bytes : {magic, junk, header, junk_behind_header}) {
    auto upload = Upload::begin(folder, "bad.mcap", bytes.size(), limits);
    ASSERT_TRUE(upload && upload.value().append(bytes));
    const auto done = upload.value().finish();
    ASSERT_FALSE(done) << bytes.size() << " bytes";
    EXPECT_EQ(done.error().why, NotKept::Why::kNoRecording);
    EXPECT_THAT(done.error().message, testing::StartsWith("'bad.mcap' "));
  }
  EXPECT_EQ(files(), 0U) << "the drafts are removed";
}

TEST_F(UploadTest, ACutRecordingIsKeptAndSaidToBeCut) {
  auto bytes = recording_of_states("io", 20);
  auto whole = Upload::begin(folder, "whole.mcap", {}, limits);
  ASSERT_TRUE(whole && whole.value().append(bytes));
  EXPECT_EQ(whole.value().finish().value().note, "");
  bytes.resize(bytes.size() / 3);
  auto cut = Upload::begin(folder, "cut.mcap", {}, limits);
  ASSERT_TRUE(cut && cut.value().append(bytes));
  const auto kept = cut.value().finish();
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_FALSE(kept.value().complete);
  EXPECT_THAT(kept.value().note, HasSubstr("'cut.mcap' was kept, but is not whole: "));
  EXPECT_EQ(content("cut.mcap"), bytes);
}

TEST_F(UploadTest, ADamagedRecordingIsKeptAndSaidToBeDamaged) {
  auto upload = Upload::begin(folder, "dam.mcap", {}, limits);
  ASSERT_TRUE(upload && upload.value().append(damaged_recording()));
  const auto kept = upload.value().finish();
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_FALSE(kept.value().complete);
  EXPECT_THAT(kept.value().note, HasSubstr("'dam.mcap' was kept, but is not whole: "));
}

TEST_F(UploadTest, TakesOnlyNamesThatCanBeSeen) {
  for (const char* name : {"a\u202Eb.mcap", "a\u200B.mcap", "a\tb.mcap", "a\xFF.mcap", " a.mcap",
                           ".a.mcap", "a/b.mcap", "a\\b.mcap"}) {
    const auto upload = Upload::begin(folder, name, {}, limits);
    ASSERT_FALSE(upload) << name;
    EXPECT_EQ(upload.error().why, NotKept::Why::kNoName) << name;
  }
}

TEST_F(UploadTest, DraftsOfAKilledMonitorAreRemovedAndOthersAreNot) {
  auto upload = Upload::begin(folder, "run.mcap", {}, limits);
  ASSERT_TRUE(upload && upload.value().append(recording));
  write_file(folder.path() / ".old.mcap.77-1.part", {1});
  write_file(folder.path() / ".notes.part", {1});
  remove_abandoned_uploads(folder);
  EXPECT_FALSE(fs::exists(folder.path() / ".old.mcap.77-1.part"));
  EXPECT_TRUE(fs::exists(folder.path() / ".notes.part")) << "that is none of ours";
  EXPECT_TRUE(upload.value().finish());
}

}  // namespace
}  // namespace galilean::monitor
