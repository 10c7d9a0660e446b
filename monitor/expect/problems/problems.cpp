// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/problems/problems.h"

#include <fstream>
#include <sstream>

#include "core/json_text.h"
#include "core/visible_text.h"
#include "core/written_files.h"
#include "monitor/expect/problems/escapes.h"

namespace galilean::expect {
namespace {

/// Returns "a.expect:1:5", or an empty text for a problem in no file.
std::string place_of(const Problem& problem) {
  if (problem.file.empty()) return {};
  return visible(problem.file) + ":" + std::to_string(problem.line) + ":" +
         std::to_string(problem.column);
}

/// Returns a text of several lines, which may be indented, as one.
std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) line += (line.empty() ? "" : " ") + word;
  return line;
}

std::string name_of(const Problem& problem) {
  return problem.file.empty() ? problem.name : place_of(problem);
}

}  // namespace

std::string junit_case(const std::string& about, const Problem& problem) {
  std::string text =
      "    <testcase" + xml_attribute("classname", about) + xml_attribute("name", name_of(problem));
  if (!problem.file.empty())
    text +=
        xml_attribute("file", problem.file) + xml_attribute("line", std::to_string(problem.line));
  const std::string where = problem.file.empty() ? "" : place_of(problem) + ": ";
  return text + ">\n      <error" + xml_attribute("message", on_one_line(problem.message)) +
         xml_attribute("type", "error") + ">" + xml_text(where + on_one_line(problem.message)) +
         "</error>\n    </testcase>\n";
}

std::string tap_test(std::size_t number, const Problem& problem) {
  const auto message = visible(on_one_line(problem.message));
  std::string text = "not ok " + std::to_string(number) + " - " +
                     tap_description(visible(name_of(problem)) + ": " + message) +
                     "\n  ---\n  outcome: \"error\"\n  message: " + json_text(message) + "\n";
  if (!problem.file.empty()) text += "  at: " + json_text(place_of(problem)) + "\n";
  return text + "  ...\n";
}

std::string junit_problems(const std::string& about, const std::vector<Problem>& problems) {
  const std::string number = std::to_string(problems.size());
  const std::string counts = xml_attribute("tests", number) + xml_attribute("failures", "0") +
                             xml_attribute("errors", number);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts +
                     ">\n  <testsuite" + xml_attribute("name", about) + counts + ">\n";
  for (const auto& problem : problems) text += junit_case(about, problem);
  return text + "  </testsuite>\n</testsuites>\n";
}

std::string tap_problems(const std::vector<Problem>& problems) {
  std::string text = "TAP version 13\n1.." + std::to_string(problems.size()) + "\n";
  std::size_t number = 0;
  for (const auto& problem : problems) text += tap_test(++number, problem);
  return text;
}

std::string github_problems(const std::vector<Problem>& problems) {
  std::string text;
  for (const auto& problem : problems) {
    text += "::error";
    if (!problem.file.empty())
      text += " file=" + command_text(visible(problem.file), true) +
              ",line=" + std::to_string(problem.line) + ",col=" + std::to_string(problem.column);
    text += "::" + command_text(visible(on_one_line(problem.message)), false) + "\n";
  }
  return text;
}

Result<void> write_report(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (file << text && file.flush()) return {};
  if (file.is_open()) remove_unfinished(path);
  return Error{"cannot write " + path};
}

}  // namespace galilean::expect
