// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "bhdl/source/location.h"
#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// A Location that owns nothing. All views here point into texts and names that the loader keeps.
/// These must outlive the tree.
struct Position {
  std::string_view file;
  int line = 1;
  int column = 1;

  operator Location() const { return {std::string(file), line, column}; }
};

struct Word {
  std::string_view text;
  Position at;
};

/// One value as it is written. The checker decides whether it fits.
struct ValueNode {
  enum class Kind { kNumber, kPair, kText, kBareWord, kBroken };
  Kind kind = Kind::kNumber;
  double number = 0;      ///< a pair's first number
  double second = 0;      ///< a pair's second number
  std::string_view text;  ///< without quotes; of a number, its spelling
  Position at;
  const Unit* unit = nullptr;         ///< of the number, or of the pair's first; null: no unit is
                                      ///< written
  const Unit* second_unit = nullptr;  ///< of the pair's second number
  const Word* constant = nullptr;     ///< the name in `define:` that stood here instead
};

struct AttributeNode {
  Word name;
  std::vector<ValueNode> values;  ///< empty only in a state's lists
  bool inherited = false;         ///< it stands in the base of this one, and is checked there
};

/// `type: attributes… end`. A condition is a block of type "condition".
struct ComponentNode {
  Word type;
  std::vector<AttributeNode> attributes;
  bool inherited = false;  ///< a condition of the state that this one extends
};

struct StateNode {
  Word keyword;
  std::vector<AttributeNode> attributes;  ///< the name and the two lists of schemas
  std::vector<ComponentNode> conditions;
};

struct SectionNode {
  Word keyword;
  ComponentKind kind = ComponentKind::kVariable;
  std::vector<ComponentNode> components;
};

struct IncludeNode {
  Word path;
};

/// `define:`. Each attribute is a constant.
struct DefineNode {
  std::vector<AttributeNode> constants;
};

struct StartStateNode {
  Word state;
};

/// A line of `on_swap:`.
struct SwapNode {
  Word old_state;
  Word new_state;
};

/// An `expect:`. Its steps are blocks, as conditions are.
struct ExpectNode {
  Word keyword;
  std::vector<AttributeNode> attributes;
  std::vector<ComponentNode> steps;
};

using SyntaxNode = std::variant<SectionNode, StateNode, DefineNode, IncludeNode, StartStateNode,
                                SwapNode, ExpectNode>;

/// A file in the order of its text; after the loader, a whole program with no includes left.
using SyntaxTree = std::vector<SyntaxNode>;

}  // namespace galilean::bhdl
