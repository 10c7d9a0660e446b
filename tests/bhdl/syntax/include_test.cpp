// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bhdl/source/sha256.h"
#include "bhdl/syntax/loader.h"
#include "tests/bhdl/small_catalog.h"
#include "tests/temporary_folder.h"

namespace galilean::bhdl {
namespace {

using testing::HasSubstr;

const std::string kShared =
    "variables: force: name: \"f\"\nmotor_schemas: noise: name: \"n\" result: \"f\" end end\n"
    "state: name: \"shared\" motor_schemas: \"n\" end end\n";
const std::string kOwnState = "state: name: \"own\" motor_schemas: \"n\" end end\n";

CheckResult check_files(std::vector<SourceFile> files) {
  return check(std::move(files), small_catalog());
}

class OnDisk : public testing::Test {
 protected:
  OnDisk() { std::filesystem::create_directory(folder_ / "parts"); }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

  TemporaryFolder folder_;
};

TEST(Include, PutsTheTextInPlace) {
  const auto result = check_files({{"main.bhdl", "include \"parts/shared.bhdl\"\n" + kOwnState},
                                   {"parts/shared.bhdl", kShared}});
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(result.program->states[0].name, "shared");
  EXPECT_EQ(result.program->states[0].location.file, "parts/shared.bhdl");
  EXPECT_EQ(result.program->states[1].name, "own");
  EXPECT_EQ(result.program->files.size(), 2u);
}

TEST(Include, IsRelativeToTheFileThatIncludes) {
  const auto result = check_files({{"main.bhdl", "include \"./parts/a.bhdl\"\n" + kOwnState},
                                   {"parts/a.bhdl", "include \"../b.bhdl\""},
                                   {"b.bhdl", kShared}});
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(result.program->files.at(2).path, "b.bhdl");
}

TEST(Include, ReadsAFileOnce) {
  const auto result = check_files({{"main.bhdl", "include \"a.bhdl\"\ninclude \"b.bhdl\"\n"},
                                   {"a.bhdl", "include \"s.bhdl\""},
                                   {"b.bhdl", "include \"s.bhdl\"\n" + kOwnState},
                                   {"s.bhdl", kShared}});
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(result.files.size(), 4u);
}

TEST(Include, NamesACycle) {
  const auto result = check_files({{"main.bhdl", "include \"a.bhdl\"\n" + kOwnState},
                                   {"a.bhdl", kShared + "include \"main.bhdl\"\n"}});
  EXPECT_EQ(printed(result),
            "a.bhdl:4:9: error: a cycle of includes: 'main.bhdl' includes 'a.bhdl' includes "
            "'main.bhdl'\n");
  EXPECT_EQ(result.diagnostics.at(0).code, "include/cycle");
  EXPECT_FALSE(result.program);
}

TEST(Include, NamesAFileThatIsNotThereAndGoesOn) {
  const auto result =
      check_files({{"main.bhdl", "include \"lost.bhdl\"\nstate: name: \"s\" bit: 3 end"}});
  EXPECT_EQ(summary(result), "1:9 error include/not-found\n2:18 error name/unknown-attribute\n");
}

TEST(Include, ReportsANameGivenTwiceWithBothPlaces) {
  const auto result = check_files(
      {{"main.bhdl", "include \"s.bhdl\"\nstate: name: \"shared\" end"}, {"s.bhdl", kShared}});
  EXPECT_EQ(printed(result),
            "main.bhdl:2:14: error: there is a state 'shared' already: the first is at "
            "s.bhdl:3:14\n");
}

TEST(Include, HasALimitOfDepth) {
  std::vector<SourceFile> files;
  for (std::size_t i = 0; i <= kDeepestInclude; ++i)
    files.push_back({std::to_string(i), "include \"" + std::to_string(i + 1) + "\""});
  const auto result = check_files(files);
  ASSERT_EQ(result.diagnostics.size(), 1u) << printed(result);
  EXPECT_EQ(result.diagnostics[0].code, "include/too-deep");
}

TEST(Include, HasALimitOfFilesAndSaysSoOnce) {
  std::vector<SourceFile> files{{"main", kShared}};
  for (int i = 0; i < 200; ++i) {
    files[0].text += "include \"" + std::to_string(i) + "\"\n";
    files.push_back({std::to_string(i), ";"});
  }
  const auto result = check_files(files);
  ASSERT_EQ(result.diagnostics.size(), 1u) << printed(result);
  EXPECT_EQ(result.diagnostics[0].code, "include/too-many");
  EXPECT_EQ(result.files.size(), kMostFiles);
}

TEST(Include, NoFileIsReadOnceAProgramHasAMebibyte) {
  const auto program_of = [](std::size_t second_file_bytes) {
    std::vector<SourceFile> files{
        {"main", kShared + "include \"1\" include \"2\" include \"3\"\n"}};
    const std::size_t first_file_bytes = kMostFileBytes - files[0].text.size();
    files.push_back({"1", std::string(first_file_bytes, ' ')});
    files.push_back({"2", std::string(second_file_bytes, ' ')});
    files.push_back({"3", ";"});
    return check_files(files);
  };
  ASSERT_EQ(kMostProgramBytes, 1024U * 1024U);
  const auto full = program_of(kMostFileBytes);
  ASSERT_EQ(full.diagnostics.size(), 1u) << printed(full);
  EXPECT_EQ(full.diagnostics[0].code, "include/too-many");
  EXPECT_EQ(full.files.size(), 3U);
  EXPECT_EQ(program_of(kMostFileBytes - 1).files.size(), 4U);
}

TEST_F(OnDisk, AProgramHasTheSameHashAsInMemory) {
  const std::string main_text = "include \"parts/shared.bhdl\"\n" + kOwnState;
  write("parts/shared.bhdl", kShared);
  const auto on_disk = check_file(write("main.bhdl", main_text), small_catalog());
  ASSERT_TRUE(on_disk.program) << printed(on_disk);
  const auto pushed = check(on_disk.files, small_catalog());
  ASSERT_TRUE(pushed.program);
  EXPECT_EQ(on_disk.program->hash, pushed.program->hash);
  EXPECT_EQ(on_disk.program->name, "main.bhdl");
  EXPECT_EQ(on_disk.program->files[1].path, "parts/shared.bhdl");
}

TEST_F(OnDisk, DiagnosticsBeginAsTheGivenPathDoes) {
  write("parts/shared.bhdl", kShared + "nonsense");
  const auto main_path = write("main.bhdl", "include \"parts/shared.bhdl\"\nend");
  const auto result = check_file(main_path, small_catalog());
  ASSERT_EQ(result.diagnostics.size(), 2u);
  EXPECT_EQ(result.diagnostics[0].file, main_path);
  EXPECT_EQ(result.diagnostics[1].file, (folder_ / "parts/shared.bhdl").string());
}

TEST_F(OnDisk, AFolderOrNothingIsNoProgram) {
  const auto folder = check_file(folder_ / "parts", small_catalog());
  EXPECT_THAT(printed(folder), HasSubstr("it is a folder, and no file"));
  const auto nothing = check_file(folder_ / "nothing.bhdl", small_catalog());
  EXPECT_THAT(printed(nothing), HasSubstr("nothing.bhdl:1:1: error: cannot read"));
  EXPECT_EQ(nothing.diagnostics.at(0).code, "file/not-found");
}

TEST_F(OnDisk, WhatIsReadForAnotherIsCompleteAndLeavesMistakesInTheTextToIt) {
  write("parts/shared.bhdl", kShared + "nonsense");
  const auto whole = read_program(write("whole.bhdl", "include \"parts/shared.bhdl\"\n"));
  ASSERT_TRUE(whole);
  ASSERT_EQ(whole.value().size(), 2U);
  EXPECT_EQ(whole.value()[1].path, "parts/shared.bhdl");
  const auto copy = write("copy.bhdl", "nonsense\ninclude \"shared.bhdl\"\n");
  const auto lacking = read_program(copy);
  ASSERT_FALSE(lacking);
  ASSERT_EQ(lacking.error().size(), 1U);
  EXPECT_EQ(lacking.error()[0].code, "include/not-found");
  EXPECT_THAT(format(lacking.error()[0]), HasSubstr(copy + ":2:9: error: cannot read"));
}

TEST_F(OnDisk, ATooLargeFileIsNotRead) {
  const auto path = write("large.bhdl", "");
  std::filesystem::resize_file(path, 100'000'000);
  const auto result = check_file(path, small_catalog());
  EXPECT_EQ(summary(result), "1:1 error file/too-large\n") << printed(result);
}

TEST(ProgramHash, IsSha256OfPathsAndTexts) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  // Made with Python's hashlib: a golden value keeps the programs' names stable.
  EXPECT_EQ(program_hash({{"a.bhdl", "x"}, {"b.bhdl", ""}}),
            "547a9e29ccaee43c17eb731aa13fc8b08a693e667dfd958d17f013597daa4b2c");
}

TEST(ProgramHash, TellsPathsFromTexts) {
  EXPECT_NE(program_hash({{"a", "bc"}}), program_hash({{"ab", "c"}}));
  EXPECT_NE(program_hash({{"a", "b"}, {"c", "d"}}), program_hash({{"c", "d"}, {"a", "b"}}));
}

}  // namespace
}  // namespace galilean::bhdl
