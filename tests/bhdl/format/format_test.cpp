// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/formatter.h"

#include <gtest/gtest.h>

#include "bhdl/syntax/loader.h"

namespace galilean::bhdl {
namespace {

std::string formatted(std::string_view text) {
  const auto result = format_text("program.bhdl", text);
  for (const auto& each : result.diagnostics) ADD_FAILURE() << format(each);
  return result.text.value_or("nothing");
}

/// That `text` is laid out as `expected`, and that this is then left alone.
void expect_layout(std::string_view text, std::string_view expected) {
  EXPECT_EQ(formatted(text), expected);
  EXPECT_EQ(formatted(expected), expected);
}

TEST(Format, IndentsByTwoAndKeepsTheAuthorsLines) {
  expect_layout(
      "states:\nstate:\nname: \"a\"\nmotor_schemas: \"m\" \"n\" end\ncondition:\n"
      "bits_variable: \"b\" bit_index: 0\nnew_state: \"a\"\nend\nend\nend\n",
      "states:\n"
      "  state:\n"
      "    name: \"a\"\n"
      "    motor_schemas: \"m\" \"n\" end\n"
      "    condition:\n"
      "      bits_variable: \"b\"  bit_index: 0\n"
      "      new_state: \"a\"\n"
      "    end\n"
      "  end\n"
      "end\n");
}

TEST(Format, LeavesABlockOnOneLineWhereItWasWrittenSoAndFits) {
  expect_layout("motor_schemas:\nnoise: name: \"n\" result: \"f\" end\nend",
                "motor_schemas:\n"
                "  noise: name: \"n\"  result: \"f\"  end\n"
                "end\n");
  expect_layout("input_devices:comm_port:end end start_state:\"s\"",
                "input_devices: comm_port: end  end\n"
                "start_state: \"s\"\n");
}

/// `text` with a name of so many letters for each $.
std::string with_names(std::string_view text, std::size_t letters) {
  std::string result;
  for (const char c : text) result += c == '$' ? std::string(letters, 'x') : std::string(1, c);
  return result;
}

TEST(Format, OpensABlockThatDoesNotFit) {
  const std::string_view text =
      "motor_schemas: noise: name: \"$\" result: \"$\" persistence: 5 end";
  expect_layout(with_names(text, 30),
                with_names("motor_schemas:\n"
                           "  noise: name: \"$\"  result: \"$\"  persistence: 5  end\n"
                           "end\n",
                           30));
  expect_layout(with_names(text, 31), with_names("motor_schemas:\n"
                                                 "  noise:\n"
                                                 "    name: \"$\"  result: \"$\"  persistence: 5\n"
                                                 "  end\n"
                                                 "end\n",
                                                 31));
}

TEST(Format, FillsLines) {
  expect_layout(with_names("motor_schemas: combine_forces: name: \"$\" result: \"$\"\n"
                           "forces: \"$\" \"$\" \"$\" gains: 1 2 end",
                           40),
                with_names("motor_schemas:\n"
                           "  combine_forces:\n"
                           "    name: \"$\"  result: \"$\"\n"
                           "    forces: \"$\" \"$\"\n"
                           "      \"$\"\n"
                           "    gains: 1 2\n"
                           "  end\n"
                           "end\n",
                           40));
}

TEST(Format, PutsNeighboursInColumns) {
  expect_layout(
      "variables:\nshaft: name: \"s\"\nlocate: name: \"a\" memory: 5 status: \"valid\" ; near\n"
      "locate: name: \"trash\" memory: 30 status: \"valid\" ; far\n\nbits: name: \"b\" ; touched\n",
      "variables:\n"
      "  shaft:  name: \"s\"\n"
      "  locate: name: \"a\"      memory: 5   status: \"valid\"  ; near\n"
      "  locate: name: \"trash\"  memory: 30  status: \"valid\"  ; far\n"
      "\n"
      "  bits:   name: \"b\"  ; touched\n"
      "end\n");
}

TEST(Format, KeepsGroupsApartByOneLine) {
  expect_layout(
      "\n\n; first\n\n\n; second\nvariables:\n\nbits: name: \"a\"\n\n\nbits: name: \"b\"\n\nend\n\n"
      "\nstart_state: \"s\"\n\n",
      "; first\n"
      "\n"
      "; second\n"
      "variables:\n"
      "  bits: name: \"a\"\n"
      "\n"
      "  bits: name: \"b\"\n"
      "end\n"
      "\n"
      "start_state: \"s\"\n");
}

TEST(Format, KeepsEveryCommentWhereverItStands) {
  expect_layout(
      "; a\nvariables: ; b\n; c\nforce: ; d\nname ; e\n: ; f\n\"x\" ; g\n; h\nvalue: < ; i\n1 ; j\n"
      ", 2 > ; k\n; l\nend ; m\n; n\nend ; o\n; p",
      "; a\n"
      "variables:  ; b\n"
      "  ; c\n"
      "  force:  ; d\n"
      "    name:  ; e\n"
      "      ; f\n"
      "      \"x\"  ; g\n"
      "    ; h\n"
      "    value: <1, 2>  ; i\n"
      "  ; j\n"
      "  ; k\n"
      "  ; l\n"
      "  ; m\n"
      "  ; n\n"
      "end  ; o\n"
      "; p\n");
}

TEST(Format, BreaksAListWhereACommentStands) {
  expect_layout(
      "motor_schemas:\ncombine_forces: name: \"c\"\nforces: ; all\n\"a\" ; left\n\"b\"\n"
      "; and\n\"d\" gains: 1 1 1 end end",
      "motor_schemas:\n"
      "  combine_forces:\n"
      "    name: \"c\"\n"
      "    forces:  ; all\n"
      "      \"a\"  ; left\n"
      "      \"b\"\n"
      "      ; and\n"
      "      \"d\"\n"
      "    gains: 1 1 1\n"
      "  end\n"
      "end\n");
}

TEST(Format, TakesThePublishedListingsQuirksAway) {
  expect_layout(
      "\uFEFFvariables:\nforce:\nname: “rear” value: <0,–1>\nbits: name: “b” end:\n"
      "percp_schemas:\nobstacle_detector:\nname: “front”\ntranslation: <0.0 21.0>\nend;\n"
      "state:\nname: “s”\npercp_schemas: “front”, “back”\nend:\nend:",
      "variables:\n"
      "  force:\n"
      "    name: \"rear\"  value: <0, -1>\n"
      "  bits: name: \"b\"\n"
      "end\n"
      "perceptual_schemas:\n"
      "  obstacle_detector:\n"
      "    name: \"front\"\n"
      "    translation: <0.0, 21.0>\n"
      "  end\n"
      "end\n"
      "state:\n"
      "  name: \"s\"\n"
      "  perceptual_schemas:\n"
      "    \"front\" \"back\"\n"
      "  end\n"
      "end\n");
}

/// Returns the text with each of its line ends replaced.
std::string with_line_ends(std::string_view text, std::string_view line_end) {
  std::string result;
  for (const char each : text) each == '\n' ? result.append(line_end) : result.append(1, each);
  return result;
}

TEST(Format, KeepsTheLineEndsThatMostLinesHave) {
  const std::string text = "state:\nname: \"go\" ; where\nend\n; the end\n";
  const std::string laid_out = "state:\n  name: \"go\"  ; where\nend\n; the end\n";
  const std::string windows = with_line_ends(laid_out, "\r\n");
  expect_layout(with_line_ends(text, "\r\n"), windows);
  expect_layout("; a\n" + with_line_ends(text, "\r\n"), "; a\r\n" + windows);
  expect_layout("; a\r\n" + text, "; a\n" + laid_out);
  expect_layout("; a\n; b\r\n", "; a\n; b\n");
  expect_layout(with_line_ends(text, "\r"), laid_out);
}

TEST(Format, WritesIncludeStartAndSwapOneWay) {
  expect_layout("include: \"a.bhdl\" start_state \"s\" on_swap: \"a\":\"b\", “c” : \"d\" end:",
                "include \"a.bhdl\"\n"
                "start_state: \"s\"\n"
                "on_swap: \"a\": \"b\"  \"c\": \"d\"  end\n");
  expect_layout("on_swap: \"a\": \"b\"\n\"c\": \"d\"",
                "on_swap:\n"
                "  \"a\": \"b\"\n"
                "  \"c\": \"d\"\n"
                "end\n");
}

TEST(Format, SetsUnitsApartAndKeepsTheCommaBeforeAConstant) {
  expect_layout(
      "define: near: 30cm\nways: \"a\",\"b\"\nend\n"
      "motor_schemas: avoid_obstacle: name: \"x\" min_sphere: 5cm, near at: <0,22cm> end end\n"
      "state: name: \"s\" motor_schemas: \"x\", ways end end\n",
      "define:\n"
      "  near: 30 cm\n"
      "  ways: \"a\" \"b\"\n"
      "end\n"
      "motor_schemas: avoid_obstacle: name: \"x\"  min_sphere: 5 cm, near  at: <0, 22 cm>  end  "
      "end\n"
      "state: name: \"s\"  motor_schemas: \"x\", ways end  end\n");
}

TEST(Format, HasNothingToSayOfNothing) {
  expect_layout("", "");
  expect_layout("\n \n", "");
  expect_layout("; only this", "; only this\n");
}

TEST(Format, LeavesWhatItCannotReadAndSaysWhy) {
  const auto broken = format_text("a.bhdl", "motor_schemas: noise: name \"x\" end");
  EXPECT_FALSE(broken.text);
  ASSERT_FALSE(broken.diagnostics.empty());
  EXPECT_EQ(broken.diagnostics[0].code, "syntax/missing-colon");
  EXPECT_FALSE(format_text("a.bhdl", std::string_view("\0", 1)).text);
  EXPECT_FALSE(format_text("a.bhdl", "\xFF").text);
}

TEST(Format, LetsNoLongLineCarryItsNeighboursCommentsAway) {
  const std::string name(200, 'x');
  expect_layout(
      "states:\nstate: name: \"a\" end ; a\nstate: name: \"bc\" end ; b\nend\n"
      "start_state: \"a\" ; c\ninclude \"" +
          name + "\" ; d",
      "states:\n"
      "  state: name: \"a\"   end  ; a\n"
      "  state: name: \"bc\"  end  ; b\n"
      "end\n"
      "start_state: \"a\"  ; c\n"
      "include \"" +
          name + "\"  ; d\n");
}

TEST(Format, RefusesALayoutThatIsTooLargeToLoad) {
  std::string text = "states:\n";
  while (text.size() < kMostFileBytes - 100) text += "state:\nname:\n\"a\"\nend\n";
  const auto result = format_text("a.bhdl", text + "end");
  ASSERT_FALSE(result.text);
  EXPECT_EQ(result.diagnostics.at(0).code, "file/too-large");
}

}  // namespace
}  // namespace galilean::bhdl
