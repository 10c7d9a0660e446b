// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/identity.h"

#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

std::string letters_of(const std::vector<std::string>& names) {
  Identities identities;
  std::string letters;
  for (const auto& name : names) identities.meet(name);
  for (const auto& name : names) letters += identities.of(name).letter + " ";
  return letters;
}

TEST(Identity, LettersAreTheRobotsOwnAndNoneTwice) {
  EXPECT_EQ(letters_of({"callisto", "ganymede", "io", "carme"}), "C G I A ");
  EXPECT_EQ(letters_of({"r1", "r2", "r12"}), "R1 R2 R12 ");
  EXPECT_EQ(letters_of({"a", "A", "ä"}), "A A2 R3 ");
}

TEST(Identity, ThePapersRobotsKeepTheirColoursHoweverLateTheyCome) {
  Identities identities;
  for (const char* name : {"europa", "callisto", "thebe", "io"}) identities.meet(name);
  EXPECT_EQ(identities.of("io").number, 0u);
  EXPECT_EQ(identities.of("callisto").number, 2u);
  EXPECT_EQ(identities.of("europa").number, 3u);
  EXPECT_EQ(identities.of("thebe").number, 4u);
}

TEST(Identity, OneThatComesAfterOthersWereForgottenHasALetterOfItsOwn) {
  Identities identities;
  for (const char* name : {"a", "aa", "aaa"}) identities.meet(name);
  ASSERT_EQ(identities.of("aaa").letter, "A3");
  identities.forget("aa");
  EXPECT_EQ(identities.of("aa").letter, "?");
  EXPECT_EQ(identities.count(), 2u);
  identities.meet("aaaa");
  EXPECT_EQ(identities.of("aaaa").letter, "A4") << "the third has A3";
  EXPECT_EQ(identities.of("aaaa").number, 4u) << "the colour is free again";
}

TEST(Identity, ARobotKeepsItsIdentity) {
  Identities identities;
  identities.meet("europa");
  const Identity before = identities.of("europa");
  identities.meet("elara");
  identities.meet("europa");
  EXPECT_EQ(identities.of("europa"), before);
  EXPECT_EQ(identities.of("nobody").letter, "?");
}

}  // namespace
}  // namespace galilean::monitor::top
