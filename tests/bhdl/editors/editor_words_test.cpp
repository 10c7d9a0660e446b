// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

TEST(EditorWords, AreThoseOfTheParser) {
  std::ifstream file(GALILEAN_SOURCE_DIR "/bhdl/editors/words.json");
  const auto words = nlohmann::json::parse(file);
  std::vector<std::string> editors;
  for (const auto* list : {"sections", "states", "statements"})
    for (const auto& word : words.at(list)) editors.push_back(word);
  const auto parsers = opening_words();
  EXPECT_THAT(editors, testing::UnorderedElementsAreArray(
                           std::vector<std::string>(parsers.begin(), parsers.end())));
  for (const auto& word : words.at("lists"))
    EXPECT_TRUE(section_kind(word.get<std::string>())) << word;
}

}  // namespace
}  // namespace galilean::bhdl
