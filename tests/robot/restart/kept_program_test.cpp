// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/kept_program.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bhdl/source/sha256.h"
#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Runs what then cannot write a byte to any file.
auto without_room(const auto& run) {
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &none);
  auto result = run();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  return result;
}

class KeptProgramTest : public testing::Test {
 protected:
  KeptProgramTest() {
    kept = {.robot = "io", .running = true, .pushed = true, .hash = "", .files = {}};
    kept.files.push_back({"my.bhdl", "; grüße \"\\ \t\nstate: name: \"x\" end\n"});
    kept.hash = bhdl::program_hash(kept.files);
  }
  [[nodiscard]] std::string text() const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::string& bytes) const {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
  }
  /// Returns why the file is refused. The test fails if it is not, or in more than one line.
  [[nodiscard]] std::string refused(const std::string& robot = "io") const {
    const auto read = read_kept_program(file, robot);
    EXPECT_FALSE(read);
    const std::string why = read ? "" : read.error().message;
    EXPECT_EQ(why.find('\n'), std::string::npos) << why;
    EXPECT_THAT(why, HasSubstr(file.string()));
    return why;
  }

  TemporaryFolder folder;
  fs::path file = kept_program_file(folder.path(), "io", 7);
  KeptProgram kept;
};

TEST_F(KeptProgramTest, WhatIsWrittenIsRead) {
  const auto none = read_kept_program(file, "io");
  ASSERT_TRUE(none);
  EXPECT_FALSE(none.value());
  for (const bool running : {true, false}) {
    kept.running = running;
    ASSERT_TRUE(write_kept_program(file, kept));
    const auto read = read_kept_program(file, "io");
    ASSERT_TRUE(read);
    ASSERT_TRUE(read.value());
    EXPECT_EQ(read.value()->robot, "io");
    EXPECT_EQ(read.value()->running, running);
    EXPECT_TRUE(read.value()->pushed);
    EXPECT_EQ(read.value()->hash, kept.hash);
    ASSERT_EQ(read.value()->files.size(), 1U);
    EXPECT_EQ(read.value()->files[0].path, "my.bhdl");
    EXPECT_EQ(read.value()->files[0].text, kept.files[0].text);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(file.parent_path()), {}), 1) << "no draft is left";
}

TEST_F(KeptProgramTest, WhatOperatorsOrderedIsReadAsItWasWritten) {
  for (const KeptOrders& orders : {KeptOrders{}, KeptOrders{"anna", false}, KeptOrders{"", true},
                                   KeptOrders{"jürgen \"the\" 2nd", true}}) {
    kept.orders = orders;
    ASSERT_TRUE(write_kept_program(file, kept));
    const auto read = read_kept_program(file, "io");
    ASSERT_TRUE(read);
    ASSERT_TRUE(read.value());
    EXPECT_EQ(read.value()->orders, orders);
  }
}

TEST_F(KeptProgramTest, AFileOfABuildThatKeptNoOrdersHasNone) {
  ASSERT_TRUE(write_kept_program(file, kept));
  auto old = nlohmann::json::parse(text());
  old.erase("held_by");
  old.erase("out_of_service");
  put(old.dump());
  const auto read = read_kept_program(file, "io");
  ASSERT_TRUE(read);
  ASSERT_TRUE(read.value());
  EXPECT_EQ(read.value()->hash, kept.hash);
  EXPECT_EQ(read.value()->orders, KeptOrders{});
}

TEST_F(KeptProgramTest, OrdersOfAnotherKindAreRefusedAndALongNameIsCut) {
  ASSERT_TRUE(write_kept_program(file, kept));
  const auto whole = nlohmann::json::parse(text());
  const std::vector<std::pair<std::string, nlohmann::json>> of_another_kind{
      {"held_by", 7}, {"held_by", nullptr}, {"out_of_service", "yes"}};
  for (const auto& [field, value] : of_another_kind) {
    auto changed = whole;
    changed[field] = value;
    put(changed.dump());
    EXPECT_THAT(refused(), HasSubstr("another format")) << field;
  }
  kept.orders.held_by = std::string(1 << 20, 'x') + "\n";
  ASSERT_TRUE(write_kept_program(file, kept));
  const auto read = read_kept_program(file, "io");
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value()->orders.held_by, std::string(KeptOrders::kMostHolderBytes, 'x'));
}

TEST_F(KeptProgramTest, WhereTheNewFileCannotBeWrittenWhatWasThereStays) {
  ASSERT_TRUE(write_kept_program(file, kept));
  const std::string before = text();
  kept.orders.held_by = "anna";
  const auto written = without_room([&] { return write_kept_program(file, kept); });
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr(file.string() + " cannot be written: "));
  EXPECT_EQ(text(), before);
}

TEST_F(KeptProgramTest, RobotsOfOtherDomainsKeepTheirOwn) {
  EXPECT_NE(kept_program_file(folder.path(), "io", 8), file);
  EXPECT_NE(kept_program_file(folder.path(), "ganymede", 7), file);
}

TEST_F(KeptProgramTest, AFileThatIsCutShortAnywhereIsRefused) {
  ASSERT_TRUE(write_kept_program(file, kept));
  const std::string whole = text();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    put(whole.substr(0, size));
    EXPECT_THAT(refused(), HasSubstr("cut short")) << size;
  }
}

TEST_F(KeptProgramTest, AForeignFileIsRefused) {
  for (const std::string foreign :
       {"[]", "{}", "7", "null", R"({"format":"something else"})", R"({"format":7})",
        R"({"format":"galilean robot, version 1","robot":"io","running":1})"}) {
    put(foreign);
    EXPECT_THAT(refused(), HasSubstr("another format")) << foreign;
  }
  put(std::string(1 << 20, '['));
  EXPECT_THAT(refused(), HasSubstr("no JSON"));
}

TEST_F(KeptProgramTest, AnotherRobotsFileAndAChangedProgramAreRefused) {
  ASSERT_TRUE(write_kept_program(file, kept));
  EXPECT_THAT(refused("ganymede"), HasSubstr("another robot"));
  kept.files[0].text += " ";
  ASSERT_TRUE(write_kept_program(file, kept));
  EXPECT_THAT(refused(), HasSubstr("does not match its hash"));
  kept.files.clear();
  ASSERT_TRUE(write_kept_program(file, kept));
  EXPECT_THAT(refused(), HasSubstr("does not match its hash"));
}

TEST_F(KeptProgramTest, WhatIsNoFileIsNeitherReadNorReplaced) {
  fs::create_directories(file);
  EXPECT_THAT(refused(), HasSubstr("a folder"));
  const auto written = write_kept_program(file, kept);
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("cannot be written"));
  EXPECT_TRUE(fs::is_directory(file));
}

TEST_F(KeptProgramTest, WhereNoFolderCanBeMadeTheReasonIsSaid) {
  const fs::path in_the_way = folder / "robots";
  std::ofstream(in_the_way) << "no folder";
  const auto written = write_kept_program(file, kept);
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr(file.string() + " cannot be written: "));
}

}  // namespace
}  // namespace galilean::robot
