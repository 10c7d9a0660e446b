// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/wire/generate/idl.h"

namespace galilean::idl {

/// What is declared of one field. Where nothing is, the defaults of emit_bounds.cpp hold.
struct FieldBounds {
  enum class Name { kNone, kOwn, kRobot, kRobotOrEmpty };
  bool any = false;          ///< numbers that are not checked
  std::string low, high;     ///< of numbers, as they are written; empty: the default
  std::optional<long> most;  ///< entries of a sequence, or bytes of a text
  Name name = Name::kNone;   ///< the text names a robot
};

/// The bounds of all structs of some IDL files, by full name "galilean_msgs::msg::Command", and
/// those of their fields by name.
using AllBounds = std::map<std::string, std::map<std::string, FieldBounds>>;

/// Reads the bounds of the structs of `file`, which stand in NAME.bounds beside NAME.idl, and adds
/// them to `all`. Errors: throws std::runtime_error with file and line if a line is not understood
/// or names no field, and if a struct of `file` has no bounds, not even an empty list.
void parse_bounds(const File& file, const std::string& text, AllBounds& all);

}  // namespace galilean::idl
