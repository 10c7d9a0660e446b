// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/tuner.h"

#include <gtest/gtest.h>

#include "tests/monitor/top/gains/office_program.h"

namespace galilean::monitor::top {
namespace {

class TunerTest : public testing::Test {
 protected:
  TunerTest() { run("1 2", "1111"); }

  void run(const std::string& gains, const std::string& hash) {
    msg::Program program;
    program.hash = hash;
    program.files = {{.path = "a.bhdl", .text = text_with(gains)}};
    msg::Catalog catalog;
    catalog.hash = "cccc";
    catalog.json = catalog_to_json(office_catalog());
    tuner.show(program, catalog);
  }
  static std::string text_with(const std::string& gains) {
    return "motor_schemas: combine_forces: name: \"search\" inputs: \"noise\" \"robot\" gains: " +
           gains + " end end";
  }
  [[nodiscard]] const Tunable& noise() const { return tuner.tunables().at(0); }
  [[nodiscard]] const Tunable& robot() const { return tuner.tunables().at(1); }

  Tuner tuner;
};

TEST_F(TunerTest, ANumberIsMovedByStepsWithinItsRange) {
  EXPECT_EQ(tuner.text_of(noise()), "1");
  tuner.move(noise(), 2);
  EXPECT_EQ(tuner.text_of(noise()), number_text(1 + 2 * noise().step, noise().step));
  EXPECT_TRUE(tuner.is_moved(noise()));
  tuner.move(noise(), -2);
  EXPECT_FALSE(tuner.has_moves());
  tuner.move(noise(), -100000);
  EXPECT_EQ(tuner.value_of(noise()), noise().min);
  tuner.move(noise(), 100000);
  EXPECT_EQ(tuner.value_of(noise()), noise().max);
  tuner.put_back();
  EXPECT_EQ(tuner.text_of(noise()), "1");
}

TEST_F(TunerTest, TheTextHasWhatWasMovedAndTheReasonSaysSo) {
  tuner.move(robot(), -1000);
  EXPECT_EQ(tuner.moved_files().at(0).text, text_with("1 0"));
  EXPECT_EQ(tuner.reason(), "search · gain of robot 2 → 0");
}

TEST_F(TunerTest, WhatTheRobotsRunIsNoLongerMovedAndTheRestStays) {
  tuner.move(noise(), -1000);
  tuner.move(robot(), -1000);
  run("0 2", "2222");
  EXPECT_FALSE(tuner.is_moved(noise()));
  EXPECT_TRUE(tuner.is_moved(robot()));
  EXPECT_EQ(tuner.program_hash(), "2222");
}

TEST_F(TunerTest, UndoTakesBackWhatWasSentAndCanBeUndoneItself) {
  EXPECT_FALSE(tuner.can_undo());
  tuner.move(noise(), -1000);
  tuner.note_sent();
  run("0 2", "2222");
  ASSERT_TRUE(tuner.can_undo());
  tuner.undo();
  EXPECT_EQ(tuner.moved_files().at(0).text, text_with("1 2"));
  tuner.note_sent();
  run("1 2", "1111");
  tuner.undo();
  EXPECT_EQ(tuner.moved_files().at(0).text, text_with("0 2"));
}

TEST_F(TunerTest, ACatalogThatCannotBeReadLeavesNothingToMove) {
  msg::Program program;
  program.hash = "3333";
  program.files = {{.path = "a.bhdl", .text = text_with("1 2")}};
  msg::Catalog catalog;
  catalog.json = "{";
  tuner.show(program, catalog);
  EXPECT_TRUE(tuner.tunables().empty());
}

}  // namespace
}  // namespace galilean::monitor::top
