// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/registry.h"
#include "core/schema/schema.h"

namespace galilean::robot {

/// A `given:` step as a schema: it writes what the step says of a variable between two times.
///
/// Base    perceptual schema; for a force motor schema, since motor schemas write forces
template <class T, class Base>
class GivenSchema : public Base {
 public:
  void run(const Tick& tick) final;

 protected:
  template <class Derived>
  static void describe(Declaration<Derived>& is, const char* variable);
  virtual void set(T& value) const = 0;

 private:
  Variable<T>* variable_ = nullptr;
  bool valid_ = true;
  double from_s_ = 0;
  double until_s_ = 0;
};

///   writes  bits_variable: bit `bit_index` is `bit_value`
class GivenBits final : public GivenSchema<Bits, PerceptualSchema> {
 public:
  static void describe(Declaration<GivenBits>& is);

 private:
  void set(Bits& bits) const override { bits.assign(bit_index_, bit_value_); }

  unsigned bit_index_ = 0;
  bool bit_value_ = true;
};

///   writes  locate_variable: its centre is at `position`, odom frame
class GivenLocate final : public GivenSchema<Locate, PerceptualSchema> {
 public:
  static void describe(Declaration<GivenLocate>& is);

 private:
  void set(Locate& locate) const override { locate.position_m = position_m_; }

  Vec2 position_m_ = Vec2::Zero();
};

///   writes  shaft_variable: the robot is at `position` and faces `heading`, odom frame
class GivenShaft final : public GivenSchema<Shaft, PerceptualSchema> {
 public:
  static void describe(Declaration<GivenShaft>& is);

 private:
  void set(Shaft& shaft) const override { shaft.pose = {position_m_, heading_rad_}; }

  Vec2 position_m_ = Vec2::Zero();
  double heading_rad_ = 0;
};

///   writes  force_variable: it is `value`, robot's frame
class GivenForce final : public GivenSchema<Force, MotorSchema> {
 public:
  static void describe(Declaration<GivenForce>& is);

 private:
  void set(Force& force) const override { force.value = value_; }

  Vec2 value_ = Vec2::Zero();
};

/// Returns the name of the schema that gives a variable of this type: "given_" and the type.
[[nodiscard]] std::string given_schema(const std::string& variable_type);

/// Adds these schemas to the robot's own components. Programs cannot name them, because they are
/// checked without them.
void add_given_schemas(Registry& registry);

}  // namespace galilean::robot
