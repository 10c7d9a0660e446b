// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "core/catalog/registry.h"
#include "core/device/devices.h"
#include "robot/components.h"
#include "tests/robot/fake_devices.h"

namespace galilean::robot {

/// Returns the default of an attribute as a value in SI units. The catalog has it in the
/// attribute's unit.
inline Value to_si(const AttributeSpec& spec) {
  Value value = *spec.default_value;
  if (auto* number = std::get_if<double>(&value)) *number *= spec.unit.to_si;
  if (auto* pair = std::get_if<Vec2>(&value)) *pair *= spec.unit.to_si;
  return value;
}

/// Makes schemas as the builder of a program does: by name through the registry, wired to
/// variables.
class SchemaTest : public ::testing::Test {
 protected:
  SchemaTest() {
    add_components(registry);
    shaft().write({.pose = {{0, 0}, kPi / 2}}, 1, tick.now, 1);
  }

  Variable<Shaft>& shaft() { return variable<Shaft>("shaft"); }
  template <class T>
  Variable<T>& variable(const std::string& name) {
    Variable<T>* known = variables.find<T>(name);
    return known ? *known : variables.add<T>(name);
  }
  Variable<Locate>& locate(const std::string& name, Vec2 position_m, double radius_m = 0,
                           double certainty = 1) {
    auto& object = variable<Locate>(name);
    object.constant = false;
    object.value.position_m = position_m;
    object.value.radius_m = radius_m;
    object.mark_written(certainty, tick.now, tick.number);
    return object;
  }

  /// Makes a schema with the values `given`, in SI units. All other attributes get the catalog's
  /// defaults. Requires: the variables exist.
  std::unique_ptr<Schema> make(const std::string& component, std::map<std::string, Value> given) {
    AttributeValues values;
    for (const AttributeSpec& spec : registry.catalog().find(component)->attributes) {
      if (const auto found = given.find(spec.name); found != given.end())
        values.set(spec.name, found->second);
      else if (spec.default_value)
        values.set(spec.name, to_si(spec));
      given.erase(spec.name);
    }
    EXPECT_TRUE(given.empty()) << component << " has no attribute " << given.begin()->first;
    return registry.make(component, values, {variables, devices, Random(7)});
  }

  /// Begins the next tick, `step_s` later.
  void advance(double step_s = 0.05) {
    tick.now += from_seconds(step_s);
    ++tick.number;
  }

  Registry registry;
  VariableStore variables;
  FakeCommPort comm_port;
  FakeMotorDrive motor_drive;
  FakeFrameGrabber frame_grabber;
  Devices devices{comm_port, motor_drive, frame_grabber};
  Tick tick{Time{std::chrono::seconds(1)}, std::chrono::milliseconds(50), 1};
};

}  // namespace galilean::robot
