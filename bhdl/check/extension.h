// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <unordered_set>

#include "bhdl/check/vocabulary.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// How many values a program may inherit. The limit keeps it no larger than a text could be.
inline constexpr std::size_t kMostInheritedValues = 100'000;

/// The names that others extend. Such a state or schema need not be used itself.
struct ExtendedNames {
  std::unordered_set<std::string_view> states;
  std::unordered_set<std::string_view> perceptual_schemas;
  std::unordered_set<std::string_view> motor_schemas;
};

/// Gives every component and state that has `extends: "base"` what its base has: the attributes and
/// lists that it does not give itself, and the base's conditions behind its own. Afterwards no
/// `extends` is left. Reports bases that do not exist (if `text_is_whole`), that are of another
/// type, or that extend each other.
[[nodiscard]] ExtendedNames inherit(SyntaxTree& tree, const Vocabulary& vocabulary,
                                    bool text_is_whole, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
