// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/describe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bhdl/program/machine.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Describe, ListsEveryComponentUnderItsSection) {
  const std::string text = describe(small_catalog());
  EXPECT_THAT(text, HasSubstr("motor_schemas:\n  noise"));
  for (const auto& component : small_catalog().components)
    EXPECT_THAT(text, HasSubstr("\n  " + component.name + " "));
  EXPECT_THAT(text, HasSubstr("\n  condition "));
}

TEST(Describe, TellsWhatAnAttributeTakes) {
  const auto drive = describe(small_catalog(), "motor_drive");
  ASSERT_TRUE(drive);
  EXPECT_THAT(
      drive.value(),
      AllOf(HasSubstr("motor_drive, an output device"),
            HasSubstr("4 numbers in pwm; default 0 0 0 0 pwm; -1000 to 1000 pwm; also spelt "
                      "stright_dead_zones"),
            HasSubstr("a number in cm; default 18.5 cm; 1 to 100 cm")));
  const auto noise = describe(small_catalog(), "noise");
  ASSERT_TRUE(noise);
  EXPECT_THAT(noise.value(),
              AllOf(HasSubstr("noise, a motor schema"), HasSubstr("name:"),
                    HasSubstr("the name of a force variable in quotes; writes it; must be given")));
}

TEST(Describe, KnowsStatesAndConditions) {
  EXPECT_THAT(describe(small_catalog(), "state").value(), HasSubstr("motor_schemas:"));
  EXPECT_THAT(describe(small_catalog(), "condition").value(),
              AllOf(HasSubstr("0 to 31"), HasSubstr("\"same\", \"set\", \"clear\", \"toggle\"")));
}

TEST(Describe, SaysWhatWasMeant) {
  const auto result = describe(small_catalog(), "motor_driev");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("did you mean 'motor_drive'?"));
}

TEST(Describe, GivesJsonThatACatalogCanBeReadFrom) {
  const auto all = catalog_from_json(describe_json(small_catalog(), "").value());
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_EQ(all.value().components.size(), small_catalog().components.size());
  const auto one = catalog_from_json(describe_json(small_catalog(), "condition").value());
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(one.value().components.at(0).attributes.size(), 6u);
}

TEST(Machine, TellsStatesAndTransitions) {
  const auto result = check_text(program_with_states(
      "state: name: \"a\" motor_schemas: \"drive\" end\n"
      "condition: bits_variable: \"bumpers\" bit_index: 2 new_state: \"b\" end end\n"
      "state: name: \"b\" end"));
  ASSERT_TRUE(result.program) << printed(result);
  const nlohmann::json machine = *result.program;
  EXPECT_EQ(machine["states"].size(), 2u);
  ASSERT_EQ(machine["transitions"].size(), 1u);
  EXPECT_EQ(machine["transitions"][0]["from_state"], "a");
  EXPECT_EQ(machine["transitions"][0]["cause"], "bumpers[2] is 1");
  EXPECT_EQ(machine["transitions"][0]["line"], 12);
}

TEST(Diagnostic, IsPrintedAndWrittenAsJson) {
  const Diagnostic diagnostic{"a.bhdl", 3, 5, Severity::kWarning, "name/x", "what", "do this"};
  EXPECT_EQ(format(diagnostic), "a.bhdl:3:5: warning: what\n  hint: do this");
  const nlohmann::json json = diagnostic;
  EXPECT_EQ(json.dump(), R"({"code":"name/x","column":5,"file":"a.bhdl","hint":"do this","line":3,)"
                         R"("message":"what","severity":"warning"})");
}

}  // namespace
}  // namespace galilean::bhdl
