// SPDX-License-Identifier: BSD-3-Clause
// Eight times the text must cost about eight times as much. What grows with the square of the text
// costs sixty-four times as much: so much that a busy machine, whose caches others fill, cannot be
// mistaken for it. Time is the processor's.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <functional>

#include "bhdl/syntax/parser.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

constexpr int kSmall = 500;
constexpr int kTimes = 8;
constexpr double kMostGrowth = 20;

/// The least of several runs, which others on the machine have disturbed the least.
double least_processor_time(const std::function<void()>& work) {
  constexpr int kRuns = 5;
  std::clock_t least = 0;
  for (int run = 0; run < kRuns; ++run) {
    const std::clock_t begin = std::clock();
    work();
    const std::clock_t taken = std::clock() - begin;
    least = run == 0 ? taken : std::min(least, taken);
  }
  return static_cast<double>(std::max<std::clock_t>(least, 1));
}

/// How many times more kTimes the text costs. Where it seems too much it is measured again,
/// because a busy machine disturbs a round; what grows with the square is too much in all of them.
double growth(const std::function<std::string(int)>& text_of,
              const std::function<void(const std::string&)>& work) {
  constexpr int kRounds = 5;
  // Memory stays with this process: what it costs to get pages from the system again in each run is
  // the machine's, and grows by steps.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  const std::string small = text_of(kSmall);
  const std::string large = text_of(kTimes * kSmall);
  double least = 0;
  for (int round = 0; round < kRounds && (round == 0 || least >= kMostGrowth); ++round) {
    const double grown =
        least_processor_time([&] { work(large); }) / least_processor_time([&] { work(small); });
    least = round == 0 ? grown : std::min(least, grown);
  }
  return least;
}

std::string ring_of_states(int count, const std::string& inside) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "state: name: \"s" + std::to_string(i) + "\" " + inside +
            " condition: bits_variable: \"bumpers\" new_state: \"s" +
            std::to_string((i + 1) % count) + "\" end end\n";
  return program_with_states(text);
}

void parse_whole(const std::string& text) {
  Diagnostics unheard;
  EXPECT_FALSE(parse("program.bhdl", text, unheard).empty());
}

void check_whole(const std::string& text) {
  EXPECT_FALSE(check_text(text).files.empty());
}

TEST(LinearTime, OfParsing) {
  EXPECT_LT(growth([](int count) { return ring_of_states(count, ""); }, parse_whole), kMostGrowth);
}

TEST(LinearTime, OfCheckingARightProgram) {
  EXPECT_TRUE(check_text(ring_of_states(4, "")).program);
  EXPECT_LT(growth([](int count) { return ring_of_states(count, ""); }, check_whole), kMostGrowth);
}

TEST(LinearTime, OfCheckingWrongNames) {
  const auto wrong = [](int count) {
    return ring_of_states(count, "motor_schemas: \"wandr\" end");
  };
  EXPECT_LT(growth(wrong, check_whole), kMostGrowth);
}

TEST(LinearTime, OfInheriting) {
  const auto heirs = [](int count) { return ring_of_states(count, "extends: \"s0\""); };
  EXPECT_LT(growth(heirs, check_whole), kMostGrowth);
}

TEST(LinearTime, OfConstants) {
  const auto constants = [](int count) {
    std::string text = "define:\n";
    for (int i = 0; i < count; ++i) text += "c" + std::to_string(i) + ": 1\n";
    return text + "end\n" + program_with_states("state: name: \"s\" end\n");
  };
  EXPECT_LT(growth(constants, check_whole), kMostGrowth);
}

}  // namespace
}  // namespace galilean::bhdl
