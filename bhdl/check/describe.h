// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// Returns the reference of all that a program can name: components by section, states, conditions
/// and expectations.
[[nodiscard]] std::string describe(const Catalog& catalog);

/// Returns one component with its attributes: what each takes, its unit, default, range and
/// purpose. "state", "condition", "expect" and its steps are described too. Errors: there is no
/// such component; the error suggests the nearest name.
[[nodiscard]] Result<std::string> describe(const Catalog& catalog, std::string_view component);

/// Returns one line on an attribute: what it takes, how it uses it, its default and its range.
[[nodiscard]] std::string facts_in_words(const AttributeSpec& spec);

/// Returns the same as JSON, in the form of the catalog's file. An empty name means the whole
/// catalog.
[[nodiscard]] Result<std::string> describe_json(const Catalog& catalog, std::string_view component);

}  // namespace galilean::bhdl
