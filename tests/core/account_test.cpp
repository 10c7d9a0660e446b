// SPDX-License-Identifier: BSD-3-Clause
#include "core/account.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace galilean {
namespace {

TEST(Account, WhoeverRunsUsHasANameWithOrWithoutAnEnvironment) {
  const char* before = std::getenv("USER");
  const std::string kept = before ? before : "";
  setenv("USER", "amalthea", 1);
  EXPECT_EQ(user_name(), "amalthea");
  unsetenv("USER");
  EXPECT_FALSE(user_name().empty());
  if (before) setenv("USER", kept.c_str(), 1);
}

}  // namespace
}  // namespace galilean
