// SPDX-License-Identifier: BSD-3-Clause
#include "core/written_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean {
namespace {

namespace fs = std::filesystem;

class WrittenFiles : public testing::Test {
 protected:
  WrittenFiles() {
    std::ofstream(folder_ / "run.mcap") << "a recording";
    std::ofstream(folder_ / "other.mcap") << "a recording";
    fs::create_directory(folder_ / "sub");
    fs::create_symlink("run.mcap", folder_ / "link");
    fs::create_symlink("new.svg", folder_ / "link_to_nothing");
    fs::create_symlink("loop", folder_ / "loop");
    fs::create_hard_link(folder_ / "run.mcap", folder_ / "twin");
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string refusal(const std::vector<std::string>& written,
                                    const std::vector<std::string>& read) const {
    const auto right = check_written_files(written, read);
    return right ? "" : right.error().message;
  }

  TemporaryFolder folder_;
};

TEST_F(WrittenFiles, WhatIsReadIsNotWrittenHoweverItIsNamed) {
  for (const char* name : {"run.mcap", "./run.mcap", "sub/../run.mcap", "link", "twin"})
    EXPECT_EQ(refusal({path(name)}, {path("other.mcap"), path("run.mcap")}),
              path(name) + " is read here and cannot be written; choose another name");
  const auto from_here = fs::relative(path("run.mcap")).string();
  EXPECT_NE(refusal({from_here}, {path("run.mcap")}), "");
}

TEST_F(WrittenFiles, NothingIsWrittenTwiceThoughItIsNotThereYet) {
  EXPECT_EQ(
      refusal({path("a.svg"), path("sub/../a.svg")}, {}),
      path("sub/../a.svg") + " would be written twice; choose another name for one of the files");
  EXPECT_NE(refusal({path("new.svg"), path("link_to_nothing")}, {}), "");
}

TEST_F(WrittenFiles, NoFileIsCalledAsStandardOutput) {
  EXPECT_EQ(refusal({"", "-"}, {}),
            "'-' stands for standard output, which is not written here; name a file");
}

TEST_F(WrittenFiles, OtherFilesAreNobodysBusiness) {
  EXPECT_EQ(refusal({path("other.mcap"), path("new.svg")}, {path("run.mcap")}), "");
  EXPECT_EQ(refusal({"", "", path("a.svg")}, {"", path("none")}), "");
  EXPECT_EQ(refusal({"/dev/null", "/dev/null"}, {"/dev/null"}), "");
  EXPECT_EQ(refusal({path("loop")}, {path("run.mcap")}), "");
}

}  // namespace
}  // namespace galilean
