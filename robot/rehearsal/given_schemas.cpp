// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rehearsal/given_schemas.h"

namespace galilean::robot {

template <class T, class Base>
void GivenSchema<T, Base>::run(const Tick& tick) {
  if (tick.now < Time{from_seconds(from_s_)} || tick.now >= Time{from_seconds(until_s_)}) return;
  if (!valid_) return variable_->reset(tick.now);
  set(variable_->value);
  variable_->mark_written(1, tick.now, tick.number);
}

template <class T, class Base>
template <class Derived>
void GivenSchema<T, Base>::describe(Declaration<Derived>& is, const char* variable) {
  is.help("Makes a variable what an expectation gives.");
  is.updates(static_cast<Variable<T> * Derived::*>(&GivenSchema::variable_), variable, "which");
  is.flag(static_cast<bool Derived::*>(&GivenSchema::valid_), "valid", true, "whether it is known");
  is.number(static_cast<double Derived::*>(&GivenSchema::from_s_), "from", unit::kSecond, 0,
            "from when on");
  is.number(static_cast<double Derived::*>(&GivenSchema::until_s_), "until", unit::kSecond, 0,
            "and until when");
}

void GivenBits::describe(Declaration<GivenBits>& is) {
  GivenSchema::describe(is, "bits_variable");
  is.number(&GivenBits::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
  is.flag(&GivenBits::bit_value_, "bit_value", true, "what it is");
}

void GivenLocate::describe(Declaration<GivenLocate>& is) {
  GivenSchema::describe(is, "locate_variable");
  is.pair(&GivenLocate::position_m_, "position", unit::kMetre, {0, 0}, "of its centre");
}

void GivenShaft::describe(Declaration<GivenShaft>& is) {
  GivenSchema::describe(is, "shaft_variable");
  is.pair(&GivenShaft::position_m_, "position", unit::kMetre, {0, 0}, "where the robot is");
  is.number(&GivenShaft::heading_rad_, "heading", unit::kRadian, 0, "which way it faces");
}

void GivenForce::describe(Declaration<GivenForce>& is) {
  GivenSchema::describe(is, "force_variable");
  is.pair(&GivenForce::value_, "value", unit::kNone, {0, 0}, "right, forward");
}

std::string given_schema(const std::string& variable_type) {
  return "given_" + variable_type;
}

void add_given_schemas(Registry& registry) {
  registry.add_schema<GivenBits>(given_schema(variable_type_name<Bits>()));
  registry.add_schema<GivenLocate>(given_schema(variable_type_name<Locate>()));
  registry.add_schema<GivenShaft>(given_schema(variable_type_name<Shaft>()));
  registry.add_schema<GivenForce>(given_schema(variable_type_name<Force>()));
}

}  // namespace galilean::robot
