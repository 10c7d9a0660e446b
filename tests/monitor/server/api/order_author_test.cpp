// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/order_author.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

const OperatorId kAdaAtTheShared{.name = "ada", .account = "operator", .client = "1"};
const OperatorId kAnna{.name = "anna", .account = "anna", .client = "2"};
const OperatorId kAnnaAsBen{.name = "ben", .account = "anna", .client = "2"};

TEST(OrderAuthor, WhoeverItIsHasTheNameOfTheSender) {
  EXPECT_EQ(author_of("", kAdaAtTheShared), "ada");
  EXPECT_EQ(author_of("operator", kAdaAtTheShared), "ada");
  EXPECT_EQ(author_of("operator (gain 0.4)", kAdaAtTheShared), "ada (gain 0.4)");
  EXPECT_EQ(author_of("operators", kAdaAtTheShared), "operators");
}

TEST(OrderAuthor, WithTheSharedTokenANameIsWhatTheSenderSays) {
  EXPECT_EQ(author_of("the night shift", kAdaAtTheShared), "the night shift");
}

TEST(OrderAuthor, APersonsTokenIsToldBesideAnotherName) {
  EXPECT_EQ(author_of("", kAnna), "anna");
  EXPECT_EQ(author_of("anna (gain 0.4)", kAnna), "anna (gain 0.4)");
  EXPECT_EQ(author_of("ben", kAnna), "ben, with the token of anna");
  EXPECT_EQ(author_of("operator", kAnnaAsBen), "ben, with the token of anna");
  EXPECT_EQ(author_of("annabel", kAnna), "annabel, with the token of anna");
}

}  // namespace
}  // namespace galilean::monitor
