// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/tunables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "tests/monitor/top/gains/office_program.h"

namespace galilean::monitor::top {
namespace {

using testing::ElementsAre;
using Files = std::vector<bhdl::SourceFile>;

Files program(const std::string& text) {
  return {{"a.bhdl", text}};
}

Files combine(const std::string& gains) {
  return program("motor_schemas:\n  combine_forces: name: \"search\" inputs: \"noise\" \"robot\" " +
                 ("gains: " + gains) + "\n  end\nend\n");
}

std::vector<std::string> brief(const Files& files) {
  std::vector<std::string> words;
  for (const auto& tunable : tunables_in(files, office_catalog()))
    words.push_back(tunable.label + " " + exact_text(tunable.value) +
                    (tunable.unit.empty() ? "" : " " + tunable.unit));
  return words;
}

const Tunable& find(const std::vector<Tunable>& tunables, const std::string& end_of_key) {
  return *std::ranges::find_if(tunables,
                               [&](const Tunable& each) { return each.key.ends_with(end_of_key); });
}

TEST(Tunables, EachGainBelongsToItsInputWhateverStandsBetweenTheNumbers) {
  EXPECT_THAT(brief(combine("1 2")), ElementsAre("gain of noise 1", "gain of robot 2"));
  EXPECT_THAT(brief(combine("1, ; of the noise 7\n  .5")),
              ElementsAre("gain of noise 1", "gain of robot 0.5"));
}

TEST(Tunables, AConstantInANumbersPlaceIsNoneAndLeavesTheOthersTheirs) {
  EXPECT_THAT(brief(combine("STRONG 2")), ElementsAre("gain of robot 2"));
}

TEST(Tunables, ThresholdsAreInTheUnitOfTheTextOrElseOfTheCatalog) {
  EXPECT_THAT(brief(program("perceptual_schemas: arrived: name: \"near\" locate_variable: \"l\" "
                            "radius: 0.4 m end time_detector: name: \"t\" duration: 12 end end")),
              ElementsAre("radius 0.4 m", "duration 12 s"));
}

TEST(Tunables, ATextThatIsNoProgramHasThoseThatCanBeRead) {
  EXPECT_THAT(brief(program("motor_schemas: combine_forces: gains: ")), ElementsAre());
  EXPECT_THAT(brief(program("no_such_schema: gain: 3 end")), ElementsAre());
}

TEST(Tunables, TheShippedProgramsHaveKeysOfTheirOwnAndValuesWithinTheirRanges) {
  const auto all = tunables_in(office_files(), office_catalog());
  EXPECT_GT(all.size(), 40u);
  std::set<std::string> keys;
  for (const auto& each : all) {
    EXPECT_TRUE(keys.insert(each.key).second) << each.key;
    EXPECT_LE(each.min, each.value) << each.key;
    EXPECT_LE(each.value, each.max) << each.key;
    EXPECT_LT(each.min, each.max) << each.key;
    EXPECT_GT(each.step, 0) << each.key;
  }
}

// GALILEAN_WRITE_FIXTURES=1 writes the file instead. The page's test reads the same file.
TEST(Tunables, AreThoseThatThePageFinds) {
  std::set<std::string> lines;
  for (const auto& each : tunables_in(office_files(), office_catalog()))
    lines.insert(each.schema + " · " + each.label + " " + exact_text(each.value) + " [" +
                 each.unit + "] " + exact_text(each.min) + " to " + exact_text(each.max) + " by " +
                 exact_text(each.step) + "\n");
  std::string text;
  for (const auto& line : lines) text += line;
  const std::string path = "web/tests/fixture/office_tunables.txt";
  if (std::getenv("GALILEAN_WRITE_FIXTURES") != nullptr)
    std::ofstream(GALILEAN_SOURCE_DIR "/" + path) << text;
  EXPECT_EQ(contents(path), text);
}

TEST(Tunables, NumbersAreWrittenInTheirPlacesAndEveryOtherCharacterStays) {
  const Files office = office_files();
  const Catalog catalog = office_catalog();
  const auto all = tunables_in(office, catalog);
  const std::map<std::string, std::string> numbers{
      {find(all, "search gains from_robot").key, "4"},
      {find(all, "trash_finder threshold 0").key, "120"}};
  const Files changed = with_numbers(office, catalog, numbers);
  EXPECT_EQ(changed[0].text, office[0].text);
  std::string expected = office[1].text;
  for (const auto& [before, after] :
       {std::pair{"threshold: 60  min_area: 8", "threshold: 120  min_area: 8"},
        std::pair{"gains: 1 2 1 1", "gains: 1 4 1 1"}})
    expected.replace(expected.find(before), std::string_view(before).size(), after);
  EXPECT_EQ(changed[1].text, expected);
  std::map<std::string, std::string> back;
  for (const auto& each : all) back[each.key] = exact_text(each.value);
  EXPECT_EQ(with_numbers(changed, catalog, back)[1].text, office[1].text);
}

TEST(Tunables, ANegativeNumberIsReplacedWithItsSign) {
  const Files files = combine("–1 2");
  const Catalog catalog = office_catalog();
  const auto all = tunables_in(files, catalog);
  EXPECT_EQ(all[0].value, -1);
  EXPECT_EQ(with_numbers(files, catalog, {{all[0].key, "3"}})[0].text, combine("3 2")[0].text);
}

TEST(Tunables, ANumberHasNoMoreDigitsThanItsStep) {
  EXPECT_EQ(number_text(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(number_text(2, 0.01), "2");
  EXPECT_EQ(number_text(61, 1), "61");
  EXPECT_EQ(number_text(120, 50), "120");
  EXPECT_EQ(number_text(-0.0001, 0.01), "0");
  EXPECT_EQ(exact_text(0.00001), "0.00001");
}

}  // namespace
}  // namespace galilean::monitor::top
