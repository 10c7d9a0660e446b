// SPDX-License-Identifier: BSD-3-Clause
#include "core/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace galilean {
namespace {

Result<int> half(int number) {
  if (number % 2 != 0) return Error{std::to_string(number) + " is odd"};
  return number / 2;
}

Result<void> require_even(int number) {
  const auto found = half(number);
  if (!found) return found.error();
  return {};
}

TEST(Result, HasAValueOrSaysWhyThereIsNone) {
  ASSERT_TRUE(half(4));
  EXPECT_EQ(half(4).value(), 2);
  ASSERT_FALSE(half(3));
  EXPECT_EQ(half(3).error().message, "3 is odd");
}

TEST(Result, GivesAwayWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> made(std::make_unique<int>(7));
  ASSERT_TRUE(made);
  EXPECT_EQ(*std::move(made).value(), 7);
}

TEST(Result, OfNothingIsSuccessOrSaysWhyItFailed) {
  EXPECT_TRUE(require_even(4));
  EXPECT_TRUE(require_even(4).ok());
  ASSERT_FALSE(require_even(3));
  EXPECT_EQ(require_even(3).error().message, "3 is odd");
}

TEST(Result, OfNothingIsASuccessWhateverItsErrorsTypeHasByDefault) {
  EXPECT_TRUE((Result<void, std::string>()));
  const Result<void, std::string> failed(std::string{});
  EXPECT_FALSE(failed) << "an error without words is an error";
  EXPECT_EQ(failed.error(), "");
}

TEST(Result, CanBeReplacedByALaterOne) {
  Result<void> latest;
  latest = require_even(3);
  EXPECT_FALSE(latest);
  latest = {};
  EXPECT_TRUE(latest);
}

}  // namespace
}  // namespace galilean
