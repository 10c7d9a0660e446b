// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// Returns whether two trees differ in nothing but places and in words that mean the same, such as
/// `percp_schemas` and `perceptual_schemas`.
[[nodiscard]] bool same_meaning(const SyntaxTree& a, const SyntaxTree& b);

}  // namespace galilean::bhdl
