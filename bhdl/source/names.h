// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "bhdl/source/diagnostic.h"
#include "core/spelling.h"

namespace galilean::bhdl {

/// Returns the hint "did you mean 'x'?" with x as the replacement, or an empty hint.
[[nodiscard]] Hint did_you_mean(std::string_view name);

}  // namespace galilean::bhdl
