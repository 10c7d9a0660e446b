// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/diff/diff.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bhdl/format/formatter.h"
#include "tests/bhdl/random_program.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Program program(const std::string& text) {
  auto result = check_text(text);
  EXPECT_TRUE(result.program) << printed(result);
  return result.program.value_or(Program{});
}

std::vector<Change> changes(const std::string& from, const std::string& to) {
  return differences(program(from), program(to), small_catalog());
}

std::vector<std::string> words(const std::string& from, const std::string& to) {
  std::vector<std::string> lines;
  for (const auto& change : changes(from, to)) lines.push_back(in_words(change));
  return lines;
}

std::string with(const std::string& more) {
  return program_with_states("state: name: \"go\" end\n" + more);
}

TEST(Diff, DoesNotCountLayoutCommentsDefaultsOrTheOrderOfDeclarations) {
  EXPECT_THAT(words("variables: force: name: \"f\" bits: name: \"b\" end state: name: \"s\" end",
                    "; words\nstate: name: “s” motor_schemas: end end\nvariables: bits: name: "
                    "\"b\"\nforce: name: \"f\" value: (0 0)"),
              IsEmpty());
}

TEST(Diff, NamesAttributesInTheCatalogsUnits) {
  const auto drive = [](const std::string& attributes) {
    return with("motor_schemas: move_robot: name: \"m\" input_force: \"ahead\" " + attributes +
                " end end");
  };
  EXPECT_THAT(
      words(drive("max_distance_magnitude: 30 safety_range: 40"), drive("safety_range: 50")),
      ElementsAre("~ motor schema move_robot 'm': max_distance_magnitude was 30 cm, is 15 cm",
                  "~ motor schema move_robot 'm': safety_range was 40 deg, is 50 deg"));
}

TEST(Diff, NamesWhatCameWentAndBecameAnother) {
  EXPECT_THAT(
      words(with("variables: bits: name: \"x\" force: name: \"y\""),
            with("variables: locate: name: \"x\" force: name: \"z\" end\n"
                 "input_devices: comm_port: end end")),
      ElementsAre("+ device comm_port", "~ variable locate 'x': type was \"bits\", is \"locate\"",
                  "- variable force 'y'", "+ variable force 'z'"));
}

TEST(Diff, NamesTheInputWhoseGainChanged) {
  const auto combine = [](const std::string& lists) {
    return with("variables: force: name: \"b\" end motor_schemas: combine_forces: name: \"c\" " +
                lists + " result: \"ahead\" end end");
  };
  EXPECT_THAT(words(combine("forces: \"ahead\" \"b\" gains: 1 2"),
                    combine("forces: \"ahead\" \"b\" gains: 1 0.5")),
              ElementsAre("~ motor schema combine_forces 'c': gains of 'b' was 2, is 0.5"));
  EXPECT_THAT(words(combine("forces: \"ahead\" gains: 1"), combine("forces: \"ahead\"")),
              ElementsAre("~ motor schema combine_forces 'c': gains was 1, is nothing"));
}

TEST(Diff, NamesStatesTheirSchemasAndTheOrderOfThese) {
  const auto lists = [](const std::string& motors, const std::string& more) {
    return program_with_states("state: name: \"go\" motor_schemas: " + motors + " end end\n" +
                               "state: name: \"last\" " + more + " end start_state: \"go\"");
  };
  EXPECT_THAT(words(lists("\"wander\" \"drive\"", ""),
                    lists("\"drive\" \"wander\"", "perceptual_schemas: \"scan\" end")),
              ElementsAre("~ state 'go' has its motor_schemas in another order: was \"wander\" "
                          "\"drive\", is \"drive\" \"wander\"",
                          "+ state 'last' has \"scan\" among its perceptual_schemas"));
}

std::string with_ways_out(const std::string& conditions) {
  return program_with_states("state: name: \"go\" " + conditions +
                             " end state: name: \"a\" end state: name: \"b\" end");
}

std::string way_out(int bit, const std::string& to, const std::string& more = "") {
  return "condition: bits_variable: \"bumpers\" bit_index: " + std::to_string(bit) +
         " new_state: \"" + to + "\" " + more + " end ";
}

TEST(Diff, NamesTransitions) {
  EXPECT_THAT(
      words(with_ways_out(way_out(0, "a") + way_out(1, "b")),
            with_ways_out(way_out(0, "b") + way_out(2, "a"))),
      ElementsAre("~ transition from 'go' when bumpers[0] is 1: new_state was \"a\", is \"b\"",
                  "- transition from 'go' when bumpers[1] is 1 to \"b\"",
                  "+ transition from 'go' when bumpers[2] is 1 to \"a\""));
  EXPECT_THAT(
      words(with_ways_out(way_out(0, "a")),
            with_ways_out(way_out(3, "a", "bit_update: \"set\" reset_variables: \"ahead\""))),
      ElementsAre(
          "~ transition from 'go' when bumpers[0] is 1: bit_index was 0, is 3",
          "~ transition from 'go' when bumpers[0] is 1: bit_update was \"same\", is \"set\"",
          "~ transition from 'go' when bumpers[0] is 1: reset_variables was nothing, is "
          "\"ahead\""));
}

TEST(Diff, NamesTheOrderOfConditions) {
  EXPECT_THAT(words(with_ways_out(way_out(0, "a") + way_out(1, "b")),
                    with_ways_out(way_out(1, "b") + way_out(0, "a"))),
              ElementsAre("~ state 'go' has its conditions in another order: was \"bumpers[0] is 1 "
                          "-> a\" \"bumpers[1] is 1 -> b\", is \"bumpers[1] is 1 -> b\" "
                          "\"bumpers[0] is 1 -> a\""));
}

TEST(Diff, NamesTheStartAndTheSwaps) {
  const std::string states = "state: name: \"a\" end state: name: \"b\" end ";
  EXPECT_THAT(words(states + "on_swap: \"x\": \"a\" \"y\": \"a\" end",
                    states + "on_swap: \"x\": \"b\" \"z\": \"b\" end start_state: \"b\""),
              ElementsAre("~ start_state was \"a\", is \"b\"", "~ on_swap 'x' was \"a\", is \"b\"",
                          "- on_swap 'y' to \"a\"", "+ on_swap 'z' to \"b\""));
}

TEST(Diff, GivesJsonWithUnits) {
  const auto noise = [](const std::string& attributes) {
    return with("motor_schemas: noise: name: \"n\" result: \"ahead\" " + attributes + " end end");
  };
  const auto found = changes(noise(""), noise("persistence: 8"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(nlohmann::json(found[0]), nlohmann::json({{"kind", "changed"},
                                                      {"what", "motor_schema"},
                                                      {"type", "noise"},
                                                      {"name", "n"},
                                                      {"attribute", "persistence"},
                                                      {"from", 5.0},
                                                      {"to", 8.0},
                                                      {"unit", "s"}}));
}

TEST(Diff, FindsNothingBetweenAProgramAndItsLayout) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::string text = RandomProgram(seed).program();
    EXPECT_THAT(words(text, format_text("program.bhdl", text).text.value_or("")), IsEmpty())
        << text;
  }
}

// What was added one way was removed the other way.
TEST(Diff, IsItsOwnMirror) {
  const auto count = [](const std::vector<Change>& all, Change::Kind kind) {
    return std::ranges::count(all, kind, &Change::kind);
  };
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::string a = RandomProgram(seed).program();
    const std::string b = RandomProgram(seed + 1000).program();
    const auto there = changes(a, b);
    const auto back = changes(b, a);
    EXPECT_EQ(there.size(), back.size()) << seed;
    EXPECT_EQ(count(there, Change::Kind::kAdded), count(back, Change::Kind::kRemoved)) << seed;
    EXPECT_EQ(count(there, Change::Kind::kRemoved), count(back, Change::Kind::kAdded)) << seed;
  }
}

}  // namespace
}  // namespace galilean::bhdl
