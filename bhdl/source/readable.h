// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Returns whether a text can be BHDL at all. If not, reports at which byte and why.
bool is_readable(const std::string& file, std::string_view text, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
