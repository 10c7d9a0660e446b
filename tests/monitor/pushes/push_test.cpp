// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push.h"

#include <gtest/gtest.h>

#include <fstream>

#include "monitor/programs/library.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
namespace status = msg::ProgramReply_Constants;

msg::ProgramReply reply(const std::string& robot, std::uint8_t said) {
  msg::ProgramReply result;
  result.id = "1";
  result.robot = robot;
  result.status = said;
  return result;
}

Push push_to(std::vector<std::string> robots) {
  return {"1", std::move(robots), Time{}};
}

TEST(Push, IsCompleteWhenEachRunsOrRefuses) {
  auto push = push_to({"io", "ganymede"});
  EXPECT_TRUE(push.note(reply("io", status::RECEIVED), Time{5ms}));
  EXPECT_TRUE(push.note(reply("io", status::RUNNING), Time{20ms}));
  EXPECT_FALSE(push.complete());
  EXPECT_TRUE(push.note(reply("ganymede", status::REJECTED), Time{30ms}));
  EXPECT_TRUE(push.complete());
  EXPECT_FALSE(push.settled()) << "io is in its probation";
  push.note(reply("io", status::CONFIRMED), Time{9s});
  EXPECT_TRUE(push.settled());
  EXPECT_EQ(push.answers()[1].status, "confirmed");
  EXPECT_EQ(push.answers()[1].latency_ms, 20) << "of the swap, not of what followed";
}

TEST(Push, HearsNeitherOthersRepliesNorRepeats) {
  auto push = push_to({"io"});
  auto other = reply("io", status::RUNNING);
  other.id = "2";
  EXPECT_FALSE(push.note(other, Time{}));
  EXPECT_TRUE(push.note(reply("io", status::RUNNING), Time{}));
  EXPECT_FALSE(push.note(reply("io", status::RECEIVED), Time{}));
  EXPECT_EQ(push.answers()[0].status, "running");
}

TEST(Push, ListsARobotThatNobodyWaitsFor) {
  auto push = push_to({"io"});
  push.list("callisto");
  push.note(reply("io", status::RUNNING), Time{});
  EXPECT_TRUE(push.complete());
  EXPECT_EQ(push.answers()[0].status, "no_answer");
}

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
  EXPECT_EQ(library.read("whole.bhdl")->size(), 2U);
  EXPECT_FALSE(library.read("../secret.bhdl"));
  const auto escaping = library.check({{"edited.bhdl", "include \"../secret.bhdl\"\n"}}, {});
  EXPECT_EQ(escaping.files.size(), 1U);
}

}  // namespace
}  // namespace galilean::monitor
