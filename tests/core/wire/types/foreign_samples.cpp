// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/wire/types/foreign_samples.h"

#include <cstring>

#include "tests/core/wire/types/lend_items.h"

namespace galilean::wire {
namespace {

foreign_Reading words_reading(std::int32_t discriminator, const char* text) {
  foreign_Reading reading{};
  reading._d = discriminator;
  reading._u.words = words(text);
  return reading;
}

foreign_Reading faults_reading(foreign_Faults faults) {
  foreign_Reading reading{};
  reading._d = 7;
  reading._u.found = faults;
  return reading;
}

foreign_Reading code_reading(std::int32_t discriminator, std::uint8_t code) {
  foreign_Reading reading{};
  reading._d = discriminator;
  reading._u.code = code;
  return reading;
}

}  // namespace

const foreign_Report& report_sample() {
  static std::int32_t weight = 12;
  static foreign_Point spot{3, 0.5F};
  static std::array<foreign_Tag, 2> others{{{words("dull"), nullptr}, {words("bright"), &weight}}};
  static std::array<foreign_Reading, 2> more{faults_reading(foreign_MOTOR), code_reading(-1, 9)};
  static foreign_Report report{};
  report.best = {words("best"), &weight};
  report.worst = {words("worst"), nullptr};
  lend_items(report.others, others);
  report.first = words_reading(2, "warm");
  lend_items(report.more, more);
  report.spot = &spot;
  report.last = 77;
  return report;
}

const foreign_Settings& settings_sample() {
  static foreign_Point rest{-4, 2};
  static std::array<std::uint8_t, 3> bytes{3, 2, 1};
  static std::array<std::int32_t, 2> steps{-1, 100000};
  static std::array<double, 1> ramps{0.125};
  static std::array<std::int16_t, 3> trims{-5, 0, 5};
  static foreign_Settings settings{};
  settings.parent.revision = 6;
  settings.level = 9;
  settings.channel = 8080;
  settings.gain = 1.25;
  settings.name = words("hall");
  lend_items(settings.bytes, bytes);
  lend_items(settings.steps, steps);
  lend_items(settings.ramps, ramps);
  lend_items(settings.trims, trims);
  settings.rest = &rest;
  settings.owner.words = words("io");
  settings.preferred = foreign_REVERSE;
  settings.grid[0] = 1;
  settings.grid[1] = -1;
  return settings;
}

const foreign_Keyed& keyed_sample() {
  static foreign_Keyed keyed{};
  keyed.id = 42;
  std::strcpy(keyed.part, "wheel");
  keyed.words = words("turns");
  return keyed;
}

const foreign_Large& large_sample() {
  static std::array<std::uint8_t, 200'000> bytes;
  static foreign_Large large{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7);
  large.number = 5;
  lend_items(large.bytes, bytes);
  return large;
}

const foreign_msgs_msg_Cells& cells_sample() {
  static std::array<std::int8_t, 3> costs{-1, 0, 100};
  static foreign_msgs_msg_Cells cells{};
  cells.cost = -1;
  lend_items(cells.costs, costs);
  for (int i = 0; i < 4; ++i) cells.corners[i] = static_cast<std::int8_t>(i - 2);
  return cells;
}

const other_RobotState& robot_state_sample() {
  static other_RobotState state{words("io"), 0.75};
  return state;
}

const bare_Message& bare_sample() {
  static bare_Message message{11};
  return message;
}

}  // namespace galilean::wire
