// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/graph/graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bhdl/graph/layout.h"
#include "tests/bhdl/random_program.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::HasSubstr;
using testing::Not;

Program machine_program(const std::string& states) {
  auto result = check_text("variables: bits: name: \"b\" end\n" + states);
  EXPECT_TRUE(result.program) << printed(result);
  return result.program.value_or(Program{});
}

std::string way_to(int bit, const std::string& to) {
  return "condition: bits_variable: \"b\" bit_index: " + std::to_string(bit) + " new_state: \"" +
         to + "\" end ";
}

std::string state_with(const std::string& name, const std::string& ways) {
  return "state: name: \"" + name + "\" " + ways + "end\n";
}

TEST(Graph, TakesBitsInARowAsOneWay) {
  const auto machine =
      machine_program(state_with("a", way_to(0, "b") + way_to(1, "b") + way_to(2, "b") +
                                          way_to(4, "b") + way_to(5, "a")) +
                      state_with("b", ""));
  const auto ways = ways_out(machine.states[0]);
  ASSERT_EQ(ways.size(), 3u);
  EXPECT_EQ(ways[0].cause, "b[0-2] is 1");
  EXPECT_EQ(ways[1].cause, "b[4] is 1");
  EXPECT_EQ(ways[2].to, "a");
}

TEST(Graph, GivesDotWithOneArrowForEachPair) {
  const auto dot = to_dot(machine_program(
      state_with("start", way_to(0, "b\\n") + way_to(2, "b\\n")) + state_with("b\\n", "")));
  EXPECT_THAT(dot, HasSubstr("\"\\n\" -> \"start\";"));
  EXPECT_THAT(dot, HasSubstr("  \"start\" -> \"b\\\\n\" [label=\"b[0] is 1\\nb[2] is 1\"];\n"));
}

TEST(Graph, EscapesTextInSvg) {
  const auto svg = to_svg(machine_program(state_with("<a> & 'b'", way_to(0, "<a> & 'b'"))));
  EXPECT_THAT(svg, HasSubstr(">&lt;a&gt; &amp; 'b'</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("<a>")));
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme: dark"));
}

bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool runs_through(const Passage& passage, const Box& box) {
  return passage.x < box.x + box.width && box.x < passage.x + passage.width && passage.y > box.y &&
         passage.y < box.y + box.height;
}

TEST(Graph, LaysBoxesAndArrowsBesideOneAnother) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomProgram random(seed);
    std::string text;
    const int states = 1 + random.below(20);
    for (int i = 0; i < states; ++i) {
      std::string ways;
      for (int way = random.below(5); way > 0; --way)
        ways += way_to(random.below(32), std::to_string(random.below(states)));
      text += state_with(std::to_string(i), ways);
    }
    const Program machine = machine_program(text);
    const GraphLayout layout = lay_out_graph(machine);
    ASSERT_EQ(layout.boxes.size(), machine.states.size());
    for (std::size_t i = 0; i < layout.boxes.size(); ++i) {
      const Box& box = layout.boxes[i];
      EXPECT_GE(box.x, 0);
      EXPECT_GE(box.y, 0);
      EXPECT_LE(box.x + box.width, layout.width);
      EXPECT_LE(box.y + box.height, layout.height);
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(box, layout.boxes[j])) << seed;
      for (const auto& arrow : layout.arrows)
        for (const auto& passage : arrow.passages) EXPECT_FALSE(runs_through(passage, box)) << seed;
    }
    EXPECT_EQ(to_svg(machine), to_svg(machine));
  }
}

TEST(Graph, DrawsAMachineOfManyStatesAllTheSame) {
  std::string text;
  constexpr int kStates = 2000;
  for (int i = 0; i < kStates; ++i)
    text += state_with(std::to_string(i),
                       way_to(0, std::to_string((i + 1) % kStates)) + way_to(2, "0"));
  const auto layout = lay_out_graph(machine_program(text));
  EXPECT_EQ(layout.arrows.size(), 2u * kStates);
}

}  // namespace
}  // namespace galilean::bhdl
