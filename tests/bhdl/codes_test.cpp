// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "tests/bhdl/small_catalog.h"

// Every code in the table of bhdl/GRAMMAR.md, and the least that is told with it.

namespace galilean::bhdl {
namespace {

const std::filesystem::path kSources = GALILEAN_SOURCE_DIR;

struct CodeCase {
  std::string code;
  CheckResult result;
};

CodeCase text(std::string code, std::string program) {
  return {std::move(code), check_text(std::move(program))};
}

constexpr const char* kState = "state: name: \"s\" end\n";

std::string with_state(const std::string& program) {
  return program + kState;
}

std::string including(const std::string& what) {
  return "include \"" + what + "\"\n" + kState;
}

std::vector<SourceFile> deep_includes() {
  std::vector<SourceFile> files{{"program.bhdl", including("0")}};
  for (int i = 0; i < 20; ++i)
    files.push_back({std::to_string(i), "include \"" + std::to_string(i + 1) + "\"\n"});
  return files;
}

std::vector<SourceFile> many_includes() {
  std::vector<SourceFile> files{{"program.bhdl", kState}};
  for (int i = 0; i < 70; ++i) {
    files[0].text += "include \"" + std::to_string(i) + "\"\n";
    files.push_back({std::to_string(i), ";"});
  }
  return files;
}

std::string word_times(const std::string& word, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += word;
  return all;
}

/// Doubles with every line.
std::string growing_constants() {
  std::string all = "define: c0: 1 1 1 1\n";
  for (int i = 1; i < 20; ++i) {
    const std::string before = " c" + std::to_string(i - 1) + ",";
    all += "c" + std::to_string(i) + ":" + before + before.substr(0, before.size() - 1) + "\n";
  }
  return all + "end\n";
}

/// Ten schemas, each with the many attributes of the one before it.
std::string growing_bases() {
  std::string all = "variables: bits: name: \"b\" end motor_schemas:\n";
  all += "noise: name: \"n0\" " + word_times("persistence: 1 ", 30'000) + " end\n";
  for (int i = 1; i < 10; ++i)
    all += "noise: name: \"n" + std::to_string(i) + "\" extends: \"n" + std::to_string(i - 1) +
           "\" end\n";
  return all + "end\n";
}

std::string states(const std::string& conditions, const std::string& schemas = "") {
  return program_with_states("state: name: \"a\" perceptual_schemas: \"scan\" end " + schemas +
                             conditions + " end\nstate: name: \"b\" end\n");
}

std::string declaring(const std::string& more) {
  return program_with_states(
      "state: name: \"a\" perceptual_schemas: \"scan\" end motor_schemas: \"wander\" \"drive\" end "
      "end\n" +
      more);
}

std::vector<CodeCase> cases() {
  const std::string to_b = "condition: bits_variable: \"bumpers\" new_state: \"b\" end";
  return {
      {"file/none", check({}, small_catalog())},
      {"file/not-found", check_file(kSources / "tests" / "cases" / "none.bhdl", small_catalog())},
      text("file/too-large", std::string(600 << 10, ' ')),
      text("file/binary", "\x7f"),
      text("file/not-utf8", "\xC3("),
      text("include/not-found", including("none.bhdl")),
      text("include/cycle", including("program.bhdl")),
      {"include/too-deep", check(deep_includes(), small_catalog())},
      {"include/too-many", check(many_includes(), small_catalog())},
      text("syntax/unexpected-character", with_state("define: a: = end ")),
      text("syntax/unclosed-text", "state: name: \"s\n end"),
      text("syntax/number", with_state("define: a: 5.2.1 end ")),
      text("syntax/pair", with_state("define: a: <1, end ")),
      text("syntax/unexpected-token", "5"),
      text("syntax/unexpected-end", with_state("end ")),
      text("syntax/unclosed", "state: name: \"s\""),
      text("syntax/unknown-unit", declaring("motor_schemas: move_robot: name: \"m\" "
                                            "safety_range: 3 parsec end end")),
      text("syntax/missing-colon", with_state("motor_schemas: noise name: \"n\" end end ")),
      text("syntax/missing-value", with_state("variables: bits: name: end end ")),
      text("syntax/unknown-word", with_state("varaibles: bits: name: \"b\" end end ")),
      text("type/wrong-unit", declaring("motor_schemas: move_robot: name: \"m\" "
                                        "safety_range: 3 cm end end")),
      text("type/wrong-value", declaring("motor_schemas: move_robot: name: \"m\" "
                                         "safety_range: \"far\" end end")),
      text("type/wrong-variable", declaring("motor_schemas: move_robot: name: \"m\" "
                                            "input_force: \"bumpers\" end end")),
      text("define/unused", with_state("define: a: 1 end ")),
      text("define/order", with_state("define: a: b b: 1 end ")),
      text("define/reserved", with_state("define: yes: 1 end ")),
      text("define/too-many", with_state(growing_constants())),
      text("name/undefined-constant", declaring("motor_schemas: move_robot: name: \"m\" "
                                                "safety_range: far end end")),
      text("extends/undefined", with_state("state: name: \"t\" extends: \"u\" end ")),
      text("extends/wrong-type", declaring("motor_schemas: move_robot: name: \"m\" "
                                           "extends: \"wander\" end end")),
      text("extends/cycle", with_state("state: name: \"t\" extends: \"t\" end ")),
      text("extends/too-many", with_state(growing_bases())),
      text("name/unknown-component", with_state("motor_schemas: nois: name: \"n\" end end ")),
      text("name/unknown-attribute",
           declaring(
               "motor_schemas: noise: name: \"n\" result: \"ahead\" reslt: \"ahead\" end end")),
      text("name/undefined-variable",
           declaring("motor_schemas: noise: name: \"n\" result: \"ahed\" end end")),
      text("name/undefined-schema", "state: name: \"s\" motor_schemas: \"x\" end end"),
      text("name/undefined-state", states("condition: bits_variable: \"bumpers\" new_state: \"c\" "
                                          "end")),
      text("name/missing-attribute", with_state("motor_schemas: noise: name: \"n\" end end ")),
      text("name/duplicate-attribute", "state: name: \"s\" name: \"t\" end"),
      text("name/duplicate", with_state(kState)),
      text("name/listed-twice", states(to_b, "motor_schemas: \"wander\" \"wander\" end ")),
      text("name/empty", "state: name: \"\" end"),
      text("name/wrong-section", with_state("motor_schemas: bits: name: \"b\" end end ")),
      text("value/out-of-range", states("condition: bits_variable: \"bumpers\" bit_index: 32 "
                                        "new_state: \"b\" end")),
      text("value/not-a-choice", with_state("variables: bits: name: \"b\" status: \"maybe\" end ")),
      text("value/count",
           with_state("output_devices: motor_drive: straight_dead_zones: 1 2 end end ")),
      text("state/none", ""),
      text("name/misspelt-attribute",
           with_state("output_devices: motor_drive: stright_dead_zones: 1 2 3 4 end end ")),
      text("name/unused-mapping", with_state("on_swap: \"s\": \"s\" end ")),
      text("state/unreachable", kState + std::string("state: name: \"t\" end ")),
      text("state/trap",
           program_with_states("state: name: \"a\" perceptual_schemas: \"scan\" end condition: "
                               "bits_variable: \"bumpers\" new_state: \"c\" end end "
                               "state: name: \"c\" perceptual_schemas: \"scan\" end condition: "
                               "bits_variable: \"bumpers\" bit_index: 1 new_state: \"c\" end "
                               "end")),
      text("state/never-stops",
           program_with_states("state: name: \"a\" motor_schemas: \"wander\" \"drive\" end "
                               "perceptual_schemas: \"scan\" end " +
                               to_b +
                               " end state: name: \"b\" motor_schemas: \"wander\" \"drive\" end "
                               "perceptual_schemas: \"scan\" end condition: bits_variable: "
                               "\"bumpers\" bit_value: 0 new_state: \"a\" end end")),
      text("condition/never", states(to_b + " " + to_b)),
      text("condition/always",
           states("condition: bits_variable: \"flag\" new_state: \"b\" end") +
               "variables: bits: name: \"flag\" value: 1 status: \"valid\" end"),
      text(
          "state/two-writers",
          declaring("motor_schemas: noise: name: \"second\" result: \"ahead\" end end state: name: "
                    "\"b\" motor_schemas: \"wander\" \"second\" \"drive\" end end")),
      text("state/two-drivers",
           declaring("motor_schemas: move_robot: name: \"too\" input_force: \"ahead\" end end "
                     "state: name: \"b\" motor_schemas: \"wander\" \"drive\" \"too\" end end")),
      text("state/unread-result", states(to_b, "motor_schemas: \"wander\" end ")),
      text("state/late-result", states(to_b, "motor_schemas: \"drive\" \"wander\" end ")),
      text("variable/never-written",
           declaring("variables: force: name: \"still\" end motor_schemas: move_robot: name: "
                     "\"m\" input_force: \"still\" end end state: name: \"b\" motor_schemas: "
                     "\"m\" end end")),
      text("schema/unused",
           declaring("motor_schemas: noise: name: \"n\" result: \"ahead\" end end")),
      text("value/no-effect",
           declaring("variables: force: name: \"sum\" end motor_schemas: combine_forces: name: "
                     "\"c\" forces: \"ahead\" gains: 0 result: \"sum\" end end")),
      text("value/unread",
           "variables: locate: name: \"can\" end perceptual_schemas: forget: name: "
           "\"f\" variables: \"can\" time: 2 radius: 30 end end state: name: "
           "\"s\" perceptual_schemas: \"f\" end end"),
      text("device/unnamed",
           "variables: locate: name: \"can\" end perceptual_schemas: look: name: \"l\" "
           "locate_variable: \"can\" end end state: name: \"s\" perceptual_schemas: \"l\" end "
           "end"),
      text("expect/nothing", with_state("expect: name: \"e\" end ")),
      text("too-many", with_state("motor_schemas: " + word_times("x: end ", 150) + "end ")),
  };
}

/// What no text brings about.
const std::set<std::string> kElsewhere{
    "format/meaning",  // a fault of the formatter itself
};

std::set<std::string> listed_codes() {
  std::ifstream grammar(kSources / "bhdl" / "GRAMMAR.md");
  std::set<std::string> codes;
  const std::regex code("`([a-z]+/[a-z0-9-]+|too-many)`");
  for (std::string line; std::getline(grammar, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string cell = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator each(cell.begin(), cell.end(), code), end; each != end; ++each)
      codes.insert((*each)[1]);
  }
  return codes;
}

TEST(Codes, EachIsToldWhereTheGrammarSays) {
  for (const auto& each : cases()) {
    const auto& result = each.result;
    EXPECT_GT(std::ranges::count(result.diagnostics, each.code, &Diagnostic::code), 0)
        << each.code << " is not among\n"
        << summary(result);
  }
}

TEST(Codes, HaveACaseEachForThoseThatTheGrammarLists) {
  std::set<std::string> told = kElsewhere;
  for (const auto& each : cases()) EXPECT_TRUE(told.insert(each.code).second) << each.code;
  const auto listed = listed_codes();
  EXPECT_GT(listed.size(), 50U);
  EXPECT_EQ(told, listed);
}

}  // namespace
}  // namespace galilean::bhdl
