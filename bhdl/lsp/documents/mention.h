// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bhdl/check/symbols.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl::lsp {

/// A place where a text gives a name or uses one.
struct Mention {
  NameSpace space = NameSpace::kVariable;
  std::string_view name;  ///< without quotes; part of the text
  bool declares = false;
  std::string_view type;  ///< the type of what is declared: "locate"; empty for states and
                          ///< constants
  /// Of a constant in an attribute: the space of the names that the attribute takes.
  std::optional<NameSpace> referenced_space = std::nullopt;
};

/// A text or a constant in a constant's definition. What a text names is known only where the
/// constant is used.
struct DefinedValue {
  std::string_view constant;
  std::string_view value;
  bool is_text = false;
};

/// Every name in one file.
struct Mentions {
  std::vector<Mention> names;
  std::vector<DefinedValue> defined;
};

[[nodiscard]] Mentions find_mentions(const SyntaxTree& tree, const Vocabulary& vocabulary);

}  // namespace galilean::bhdl::lsp
