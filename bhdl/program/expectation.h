// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/source/location.h"
#include "core/geometry.h"

namespace galilean::bhdl {

/// The value that a variable is given from one time to another, whatever schemas write into it.
/// Times count from the program's first tick.
struct Given {
  std::string variable;
  std::string type;  ///< of the variable, as the catalog names it
  unsigned bit_index = 0;
  bool bit_value = true;
  Vec2 position_m = Vec2::Zero();  ///< of a locate or a shaft, in the robot's global frame
  double heading_rad = 0;          ///< of a shaft
  Vec2 force = Vec2::Zero();       ///< in the robot's frame
  bool valid = true;
  double from_s = 0;
  double until_s = 0;
  Location location;
};

/// What must hold of the current state.
struct Claim {
  enum class Kind {
    kReaches,  ///< it is current at some time from `from_s` to `until_s`
    kStays,    ///< … all the time
    kNever     ///< … at no time
  };
  Kind kind = Kind::kReaches;
  std::string state;
  double from_s = 0;
  double until_s = 0;
  Location location;
};

/// `expect:`: a test of a program's behaviour that the program itself carries. A robot ignores it.
struct Expectation {
  std::string name;
  std::string from_state;  ///< the state where it begins; empty: the start state
  double lasts_s = 0;
  std::vector<Given> givens;
  std::vector<Claim> claims;
  Location location;
};

}  // namespace galilean::bhdl
