// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/wire/generate/bounds.h"
#include "core/wire/generate/idl.h"

namespace galilean::idl {

/// bounds.cpp: a function for each struct that walks through it with a CdrChecker, and the list of
/// them by which bounds_of finds one.
[[nodiscard]] std::string emit_bounds(const std::vector<File>& files, const AllBounds& bounds);

}  // namespace galilean::idl
