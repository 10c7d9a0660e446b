// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>

#include "tests/core/wire/types/foreign_samples.h"
#include "tests/core/wire/types/lend_items.h"

namespace galilean::wire {
namespace {

foreign_Outline circle(double radius_m) {
  foreign_Outline outline{};
  outline._d = foreign_ROUND;
  outline._u.radius_m = radius_m;
  return outline;
}

foreign_Outline corner(double x_m, float y_m) {
  foreign_Outline outline{};
  outline._d = foreign_SQUARE;
  outline._u.corner = {x_m, y_m};
  return outline;
}

void set_scalars(foreign_Plain& plain) {
  plain.yes = true;
  plain.raw = 200;
  plain.letter = 'q';
  plain.small = -3;
  plain.small_natural = 60000;
  plain.whole = -70000;
  plain.natural = 4000000000U;
  plain.large = -5000000000LL;
  plain.large_natural = 18000000000000000000ULL;
  plain.near_m = 0.1F;
  plain.exact_m = -2.5;
  plain.words = words("hall");
  std::strcpy(plain.short_words, "short");
  plain.present_gear = foreign_DRIVE;
  plain.present_faults = foreign_CAMERA | foreign_RADIO;
  plain.spot = {1.5, -0.25F};
}

void set_arrays(foreign_Plain& plain) {
  int number = 0;
  for (auto& row : plain.grid)
    for (auto& cell : row) cell = ++number;
  plain.names[0] = words("io");
  plain.names[1] = words("");
  plain.gears[0] = foreign_REVERSE;
  plain.gears[1] = foreign_PARK;
  std::copy_n("red\0\0\0", 6, plain.label);
  for (auto& count : plain.counts) count = ++number;
}

void set_plain_sequences(foreign_Plain& plain) {
  static std::array<std::uint8_t, 3> bytes{1, 2, 255};
  static std::array<bool, 2> answers{true, false};
  static std::array<char, 2> spelled{'o', 'k'};
  static std::array<double, 2> numbers{0.5, 1e300};
  static std::array<char*, 2> lines{words("one"), words("two")};
  static std::array<foreign_Gear, 2> past_gears{foreign_PARK, foreign_DRIVE};
  static std::array<foreign_Faults, 2> past_faults{0, foreign_MOTOR};
  lend_items(plain.bytes, bytes);
  lend_items(plain.answers, answers);
  lend_items(plain.spelled, spelled);
  lend_items(plain.numbers, numbers);
  lend_items(plain.lines, lines);
  lend_items(plain.past_gears, past_gears);
  lend_items(plain.past_faults, past_faults);
}

void set_nested_sequences(foreign_Plain& plain) {
  using Line = std::remove_pointer_t<decltype(plain.table._buffer)>;
  static std::array<std::int32_t, 2> first{7, 8};
  static std::array<Line, 2> table{};
  static std::array<std::array<std::int32_t, 3>, 2> rows{{{1, 2, 3}, {4, 5, 6}}};
  static std::array<foreign_Point, 2> trail{{{0.25, 4}, {-1, 0}}};
  static std::array<foreign_Outline, 2> outlines{circle(3), corner(2, 1)};
  lend_items(table[0], first);
  lend_items(plain.table, table);
  lend_items(plain.rows, rows);
  lend_items(plain.trail, trail);
  lend_items(plain.outlines, outlines);
  plain.present_outline = corner(0.5, 8);
}

}  // namespace

const foreign_Plain& plain_sample() {
  static foreign_Plain plain{};
  set_scalars(plain);
  set_arrays(plain);
  set_plain_sequences(plain);
  set_nested_sequences(plain);
  return plain;
}

}  // namespace galilean::wire
