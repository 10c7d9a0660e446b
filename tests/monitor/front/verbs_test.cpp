// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/verbs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace galilean::front {
namespace {

using testing::HasSubstr;

TEST(Verbs, AMisspeltOneIsAnsweredWithTheNearest) {
  EXPECT_THAT(unknown_verb("montior"), HasSubstr("did you mean 'monitor'?"));
  EXPECT_THAT(unknown_verb("recrod"), HasSubstr("did you mean 'record'?"));
  EXPECT_THAT(unknown_verb("verison"), HasSubstr("did you mean 'version'?"));
  EXPECT_THAT(unknown_verb("--hlep"), HasSubstr("did you mean '--help'?"));
  EXPECT_THAT(unknown_verb("mon"), HasSubstr("did you mean 'monitor'?"));
  EXPECT_THAT(unknown_verb("xyzzy"), HasSubstr("galilean help"));
}

/// The word with two neighbouring letters swapped.
std::string swapped(std::string_view word, std::size_t at) {
  std::string result(word);
  std::swap(result[at], result[at + 1]);
  return result;
}

TEST(Verbs, EachIsFoundWithTwoLettersSwapped) {
  for (const auto& verb : verbs())
    for (std::size_t at = 0; at + 1 < verb.name.size(); ++at) {
      if (verb.name[at] == verb.name[at + 1]) continue;
      EXPECT_THAT(unknown_verb(swapped(verb.name, at)),
                  HasSubstr("did you mean '" + std::string(verb.name) + "'?"));
    }
}

TEST(Verbs, EachIsInTheList) {
  for (const auto& verb : verbs()) {
    EXPECT_EQ(find_verb(verb.name), &verb);
    EXPECT_THAT(usage(), HasSubstr(std::string(verb.name) + " "));
  }
  EXPECT_EQ(find_verb("montior"), nullptr);
}

}  // namespace
}  // namespace galilean::front
