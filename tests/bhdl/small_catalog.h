// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>

#include "bhdl/check.h"

namespace galilean::bhdl {

/// Returns a few components that together use everything that a catalog can say of an attribute.
[[nodiscard]] Catalog small_catalog();

/// Checks one text, as the file "program.bhdl".
[[nodiscard]] CheckResult check_text(std::string text);

/// Returns a whole correct program. `states` may refer to the bits variable "bumpers", the force
/// "ahead", the perceptual schema "scan" and the motor schemas "wander" and "drive".
[[nodiscard]] std::string program_with_states(const std::string& states);

/// Returns all diagnostics as `line:column severity code`, one a line.
[[nodiscard]] std::string summary(const CheckResult& result);
/// Returns all diagnostics as they are printed.
[[nodiscard]] std::string printed(const CheckResult& result);

}  // namespace galilean::bhdl
