// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/check/attribute_reader.h"
#include "bhdl/program/expectation.h"

namespace galilean::bhdl {

/// Checks an expectation against its declaration and against the program's names.
[[nodiscard]] Expectation read_expectation(const ExpectNode& node,
                                           const AttributeReader& attributes,
                                           Diagnostics& diagnostics);

}  // namespace galilean::bhdl
