// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/restore.h"

#include <algorithm>
#include <array>

namespace galilean::robot {
namespace {

using Numbers = std::vector<double>;

bool assign(Shaft& shaft, const VariableSituation& from) {
  const Numbers& v = from.values;
  if (v.size() < 5) return false;
  shaft = {{{v[0], v[1]}, v[2]}, v[3], v[4]};
  return true;
}

/// An image is not restored, because the next frame makes it anew.
bool assign(Image&, const VariableSituation&) {
  return false;
}

ObjectClass class_named(std::string_view name) {
  for (const auto object :
       {ObjectClass::kTrash, ObjectClass::kBasket, ObjectClass::kObstacle, ObjectClass::kRobot})
    if (name == to_string(object)) return object;
  return ObjectClass::kUnknown;
}

bool assign(Locate& locate, const VariableSituation& from) {
  const Numbers& v = from.values;
  if (v.size() < 6) return false;
  locate.object = class_named(from.object_class);
  locate.position_m = {v[0], v[1]};
  locate.covariance_m2 << v[2], v[3], v[3], v[4];
  locate.radius_m = v[5];
  return true;
}

bool assign(Bits& bits, const VariableSituation& from) {
  if (from.values.empty() || !(from.values[0] >= 0 && from.values[0] < 4294967296.0)) return false;
  bits.value = static_cast<std::uint32_t>(from.values[0]);
  return true;
}

bool assign(Force& force, const VariableSituation& from) {
  if (from.values.size() < 2) return false;
  force.value = {from.values[0], from.values[1]};
  return true;
}

}  // namespace

void restore_variables(const Situation& situation, RunningProgram& program, Time now) {
  program.variables.for_each([&]<class T>(Variable<T>& variable) {
    if (variable.constant) return;
    const auto from = std::ranges::find_if(situation.variables, [&](const auto& each) {
      return each.name == variable.name && each.type == variable_type_name<T>();
    });
    if (from == situation.variables.end() || !assign(variable.value, *from)) return;
    variable.reliability.valid = from->valid;
    variable.reliability.certainty = from->certainty;
    variable.reliability.stamp = now;
  });
}

}  // namespace galilean::robot
