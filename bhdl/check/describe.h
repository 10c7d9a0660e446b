// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// The reference of everything that a program can name: components by section, states, conditions.
[[nodiscard]] std::string describe(const Catalog& catalog);

/// One component with its attributes: what each takes, its unit, default, range and what it is for.
/// "state" and "condition" are described too. An error says which name is nearest.
[[nodiscard]] Result<std::string> describe(const Catalog& catalog, std::string_view component);

/// One attribute in a line: what it takes, how it uses it, its default and its range.
[[nodiscard]] std::string facts_in_words(const AttributeSpec& spec);

/// The same as JSON, in the form of the catalog's own file. An empty name means all.
[[nodiscard]] Result<std::string> describe_json(const Catalog& catalog, std::string_view component);

}  // namespace galilean::bhdl
