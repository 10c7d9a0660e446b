// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "bhdl/format/formatter.h"
#include "tests/bhdl/program_text.h"
#include "tests/bhdl/random_program.h"
#include "tests/bhdl/small_catalog.h"

// What must hold of the formatter whatever the text.

namespace galilean::bhdl {
namespace {

namespace fs = std::filesystem;

/// The words of all comments in order of the alphabet; those that say nothing are left out.
std::vector<std::string> comments(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto begin = line.find(';');
    if (begin == std::string::npos) continue;
    const auto end = line.find_last_not_of(" \t\r");
    if (end > begin) found.push_back(line.substr(begin, end - begin + 1));
  }
  std::ranges::sort(found);
  return found;
}

void expect_stable(const std::string& text, const std::string& laid_out) {
  EXPECT_EQ(comments(laid_out), comments(text));
  EXPECT_EQ(format_text("program.bhdl", laid_out).text, laid_out);
}

TEST(FormattedRandomPrograms, MeanWhatTheyMeant) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const std::string text = RandomProgram(seed).program();
    const auto result = format_text("program.bhdl", text);
    ASSERT_TRUE(result.text) << "seed " << seed << '\n' << text;
    const auto before = check_text(text);
    const auto after = check_text(*result.text);
    ASSERT_TRUE(before.program && after.program) << printed(after) << *result.text;
    ASSERT_EQ(meaning(*after.program), meaning(*before.program)) << *result.text;
    expect_stable(text, *result.text);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << '\n' << text << *result.text;
  }
}

TEST(FormattedRandomPrograms, AreLeftAloneWhenTheyCannotBeRead) {
  int laid_out = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    RandomProgram random(seed);
    const std::string text = damaged(random.program(), random);
    const auto result = format_text("program.bhdl", text);
    EXPECT_EQ(result.text.has_value(), !any_error(result.diagnostics)) << seed;
    if (!result.text) continue;
    ++laid_out;
    EXPECT_EQ(format_text("program.bhdl", *result.text).text, *result.text);
    EXPECT_EQ(summary(check_text(text)).empty(), summary(check_text(*result.text)).empty());
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << '\n' << text << *result.text;
  }
  EXPECT_GT(laid_out, 100) << "slight damage should often leave a text that can be read";
}

TEST(FormattedRandomPrograms, AreTheSameWithTheLineEndsOfWindows) {
  const auto with_windows_line_ends = [](const std::string& text) {
    std::string result;
    for (const char each : text)
      if (each != '\r') result += each == '\n' ? "\r\n" : std::string(1, each);
    return result;
  };
  for (unsigned seed = 0; seed < 300; ++seed) {
    const std::string text = RandomProgram(seed).program();
    const auto result = format_text("program.bhdl", with_windows_line_ends(text));
    ASSERT_TRUE(result.text) << "seed " << seed;
    const auto plain = format_text("program.bhdl", text);
    ASSERT_EQ(result.text, with_windows_line_ends(plain.text.value())) << "seed " << seed;
    expect_stable(text, *result.text);
  }
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".bhdl") files.push_back(entry.path());
  return files;
}

std::string text_of_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void expect_same_meaning(const std::string& text, const std::string& laid_out) {
  const auto before = check_text(text);
  const auto after = check_text(laid_out);
  ASSERT_EQ(after.program.has_value(), before.program.has_value());
  if (before.program) {
    EXPECT_EQ(meaning(*after.program), meaning(*before.program));
  }
}

TEST(FormattedFiles, AreStableAndKeepTheirComments) {
  const fs::path root = GALILEAN_SOURCE_DIR;
  for (const auto& folder : {root / "bhdl" / "programs", root / "tests" / "cases"})
    for (const auto& path : files_in(folder)) {
      SCOPED_TRACE(path);
      const std::string text = text_of_file(path);
      const auto result = format_text(path.string(), text);
      EXPECT_EQ(result.text.has_value(), !any_error(result.diagnostics));
      if (!result.text) continue;
      expect_stable(text, *result.text);
      expect_same_meaning(text, *result.text);
    }
}

TEST(FormattedFiles, AreThoseThatShip) {
  for (const auto& path : files_in(fs::path(GALILEAN_SOURCE_DIR) / "bhdl" / "programs"))
    EXPECT_EQ(format_text(path.string(), text_of_file(path)).text, text_of_file(path))
        << "run galilean bhdl fmt " << path;
}

}  // namespace
}  // namespace galilean::bhdl
