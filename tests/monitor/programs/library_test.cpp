// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/programs/library.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

TEST(Library, TakesMissingIncludesFromItsFolderAndNothingFromElsewhere) {
  const TemporaryFolder parent;
  const auto folder = parent / "programs";
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "parts.bhdl") << "variables:\n";
  std::ofstream(folder / "whole.bhdl") << "include \"parts.bhdl\"\n";
  std::ofstream(parent / "secret.bhdl") << "variables:\n";
  const ProgramLibrary library(folder, {});
  const auto checked = library.check({{"edited.bhdl", "include \"parts.bhdl\"\n"}}, {});
  ASSERT_EQ(checked.files.size(), 2U);
  EXPECT_EQ(checked.files[1].path, "parts.bhdl");
  const auto taken = library.taken({{"./edited.bhdl", ""}}, checked);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].path, "parts.bhdl");
  EXPECT_EQ(taken[0].from, (folder / "parts.bhdl").string());
  EXPECT_EQ(in_words(library.taken(checked.files, checked)), "");
  EXPECT_EQ(library.read("whole.bhdl")->size(), 2U);
  EXPECT_FALSE(library.read("../secret.bhdl"));
  const auto escaping = library.check({{"edited.bhdl", "include \"../secret.bhdl\"\n"}}, {});
  EXPECT_EQ(escaping.files.size(), 1U);
}

}  // namespace
}  // namespace galilean::monitor
