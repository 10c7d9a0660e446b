// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/recording_folder.h"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

#include "monitor/recordings/recording_name.h"
#include "tests/monitor/recordings/written_recording.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class RecordingFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(inside.path() / "below.mcap");
    write_file(outside / "secret.mcap", recording_of_states("secret", 1));
    write_file(inside / "run.mcap", recording_of_states("io", 3));
  }
  [[nodiscard]] NotOpened::Why why(const std::string& name) const {
    const auto opened = folder.open(name);
    EXPECT_FALSE(opened) << name;
    return opened ? NotOpened::Why::kUnreadable : opened.error().why;
  }

  TemporaryFolder inside, outside;
  RecordingFolder folder{inside.path()};
};

TEST_F(RecordingFolderTest, OpensWhatIsInIt) {
  const auto opened = folder.open("run.mcap");
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened.value().bytes, fs::file_size(inside / "run.mcap"));
  std::uint8_t magic[8];
  EXPECT_TRUE(opened.value().source->read(0, magic));
  fs::remove(inside / "run.mcap");
  EXPECT_TRUE(opened.value().source->read(8, magic)) << "who deletes it takes nothing away";
  EXPECT_EQ(why("run.mcap"), NotOpened::Why::kNotThere);
}

TEST_F(RecordingFolderTest, NoNameLeadsOutOfIt) {
  const auto out = outside.path().filename().string();
  const std::vector<std::string> names{"..",
                                       "../" + out + "/secret.mcap",
                                       "/etc/passwd",
                                       (outside / "secret.mcap").string(),
                                       "./run.mcap",
                                       "",
                                       std::string("run.mcap\0.mcap", 14),
                                       ".hidden.mcap",
                                       "run.txt",
                                       ".mcap",
                                       std::string(300, 'a') + ".mcap",
                                       "a\nb.mcap",
                                       "a\u202Eb.mcap",
                                       "a\u00A0b.mcap",
                                       "a\u200B.mcap",
                                       "a\xFF.mcap",
                                       "a\\b.mcap",
                                       " run.mcap"};
  for (const auto& name : names) {
    EXPECT_EQ(why(name), NotOpened::Why::kNotThere) << name;
    EXPECT_FALSE(check_recording_name(name)) << name;
  }
}

TEST_F(RecordingFolderTest, NoLinkLeadsOutOfIt) {
  fs::create_symlink(outside / "secret.mcap", inside / "absolute.mcap");
  fs::create_symlink("../" + outside.path().filename().string() + "/secret.mcap",
                     inside / "relative.mcap");
  fs::create_symlink("circle.mcap", inside / "circle.mcap");
  fs::create_symlink("nothing.mcap", inside / "dangling.mcap");
  for (const char* name : {"absolute.mcap", "relative.mcap", "circle.mcap", "dangling.mcap"})
    EXPECT_EQ(why(name), NotOpened::Why::kNotThere) << name;
  EXPECT_THAT(folder.open("relative.mcap").error().message, HasSubstr("leads out"));
}

TEST_F(RecordingFolderTest, WhatIsNoFileIsSaidAtOnce) {
  EXPECT_EQ(why("below.mcap"), NotOpened::Why::kNoFile);
  ASSERT_EQ(mkfifo((inside / "pipe.mcap").c_str(), 0600), 0);
  EXPECT_EQ(why("pipe.mcap"), NotOpened::Why::kNoFile) << "it is not waited for a writer";
  EXPECT_EQ(folder.open("below.mcap").error().message, "'below.mcap' is a folder, and no file.");
}

TEST_F(RecordingFolderTest, ListsNamesOfRecordingsAlone) {
  write_file(inside / "notes.txt", {1});
  write_file(inside / ".draft.mcap.1-1.part", {1});
  EXPECT_THAT(folder.names().value(), ElementsAre("below.mcap", "run.mcap"));
}

TEST_F(RecordingFolderTest, NamesThatCannotBeSeenWholeAreListedAndSaidToBeWrong) {
  write_file(inside / "gpj.\u202Epacm.mcap", recording_of_states("io", 1));
  EXPECT_EQ(folder.names().value().size(), 3U);
  EXPECT_EQ(folder.open("gpj.\u202Epacm.mcap").error().message,
            "A recording's name has only characters that can be seen, and "
            "'gpj.U+202Epacm.mcap' has others; rename the file.");
  EXPECT_TRUE(check_recording_name("Überall 木 (2).mcap"));
}

TEST_F(RecordingFolderTest, ASocketIsNoFile) {
  const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (inside / "socket.mcap").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(folder.open("socket.mcap").error().message, "'socket.mcap' is a socket, and no file.");
  close(descriptor);
}

TEST_F(RecordingFolderTest, NeedNotBeThere) {
  const RecordingFolder nowhere(inside / "nowhere");
  EXPECT_TRUE(nowhere.names().value().empty());
  EXPECT_EQ(nowhere.open("run.mcap").error().why, NotOpened::Why::kNotThere);
  const RecordingFolder file(inside / "run.mcap");
  EXPECT_FALSE(file.names()) << "it is a file";
}

}  // namespace
}  // namespace galilean::monitor
