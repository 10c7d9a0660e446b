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
  EXPECT_THAT(unknown_verb("xyzzy"), HasSubstr("galilean help"));
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
