// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "tests/bhdl/small_catalog.h"

// Programs that tell themselves what is wrong with them: each line of tests/cases/*.bhdl that has a
// mistake ends in `; expect error: part of the message`, or `; expect warning: …`. Messages and
// expectations must match one to one.

namespace galilean::bhdl {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(GALILEAN_SOURCE_DIR) / "tests" / "cases";

struct Expectation {
  std::string file;
  int line = 0;
  std::string severity;
  std::string message;
};

std::vector<Expectation> expectations(const SourceFile& file) {
  std::vector<Expectation> found;
  std::istringstream lines(file.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::size_t at = 0;
    while ((at = line.find("; expect ", at)) != std::string::npos) {
      at += 9;
      const auto colon = line.find(": ", at);
      const auto end = std::min(line.find(" ; expect ", colon), line.size());
      found.push_back({file.path, number, line.substr(at, colon - at),
                       line.substr(colon + 2, end - colon - 2)});
    }
  }
  return found;
}

bool matches(const Diagnostic& diagnostic, const Expectation& expected) {
  return fs::path(diagnostic.file) == kCases / expected.file && diagnostic.line == expected.line &&
         to_string(diagnostic.severity) == expected.severity &&
         diagnostic.message.find(expected.message) != std::string::npos;
}

std::vector<std::string> case_names() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(kCases))
    if (entry.path().extension() == ".bhdl") names.insert(entry.path().stem().string());
  return {names.begin(), names.end()};
}

class Language : public testing::TestWithParam<std::string> {};

TEST_P(Language, ReportsWhatTheProgramExpects) {
  const auto result = check_file(kCases / (GetParam() + ".bhdl"), small_catalog());
  std::vector<Expectation> expected;
  for (const auto& file : result.files)
    for (auto& each : expectations(file)) expected.push_back(std::move(each));
  for (const auto& diagnostic : result.diagnostics) {
    const auto found = std::ranges::find_if(
        expected, [&](const Expectation& each) { return matches(diagnostic, each); });
    if (found == expected.end())
      ADD_FAILURE() << "not expected: " << format(diagnostic);
    else
      expected.erase(found);
  }
  for (const auto& each : expected)
    ADD_FAILURE() << each.file << ':' << each.line << ": not reported: " << each.severity << ": "
                  << each.message;
  EXPECT_EQ(result.program.has_value(), !any_error(result.diagnostics));
}

std::string contents(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST_P(Language, ReportsCodesThatTheGrammarLists) {
  const std::string grammar = contents(fs::path(GALILEAN_SOURCE_DIR) / "bhdl" / "GRAMMAR.md");
  const auto result = check_file(kCases / (GetParam() + ".bhdl"), small_catalog());
  for (const auto& each : result.diagnostics)
    EXPECT_NE(grammar.find('`' + each.code + '`'), std::string::npos) << each.code;
}

INSTANTIATE_TEST_SUITE_P(Cases, Language, testing::ValuesIn(case_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace galilean::bhdl
