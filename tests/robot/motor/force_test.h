// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/robot/schema_test.h"

namespace galilean::robot {

using namespace std::string_literals;

/// Tests of a robot that stands in the origin and faces along y, so that its frame is the global
/// one.
class ForceTest : public SchemaTest {
 protected:
  static constexpr double kTolerance = 1e-9;
  static constexpr double kEdgeStep_m = 1e-6;  ///< step to the inside or outside of a zone's edge

  ForceTest() { result().constant = false; }

  Variable<Force>& result() { return variable<Force>("result"); }
  /// Returns what one more tick of the schema writes. The test fails if the schema writes nothing.
  Vec2 run(Schema& schema) {
    advance();
    schema.run(tick);
    EXPECT_EQ(result().written_tick, tick.number) << "it did not write";
    return result().value.value;
  }
  void expect_silence(Schema& schema) {
    advance();
    schema.run(tick);
    EXPECT_NE(result().written_tick, tick.number) << "it wrote";
  }
  static void expect_near(const Vec2& actual, const Vec2& expected) {
    EXPECT_NEAR(actual.x(), expected.x(), kTolerance);
    EXPECT_NEAR(actual.y(), expected.y(), kTolerance);
  }
};

}  // namespace galilean::robot
