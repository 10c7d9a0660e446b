// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>

#include "bhdl/check/expectation_specs.h"
#include "bhdl/check/state_specs.h"
#include "bhdl/check/symbols.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl::lsp {

/// A part of a text that has attributes: a component, a state, a condition, an expectation.
struct Entity {
  const ComponentSpec* spec = nullptr;  ///< nullptr: the catalog has none of that type
  std::optional<NameSpace> space;       ///< the space of its own name; a condition and a device
                                        ///< have none
  const Word& type;
  const std::vector<AttributeNode>& attributes;
};

template <class Visit>
void for_each_entity(const SectionNode& section, const Vocabulary& vocabulary, Visit visit) {
  for (const auto& component : section.components) {
    const ComponentSpec* spec = vocabulary.find(component.type.text);
    const ComponentKind kind = spec == nullptr ? section.kind : spec->kind;
    visit(Entity{spec, is_device(kind) ? std::nullopt : std::optional(name_space(kind)),
                 component.type, component.attributes});
  }
}

template <class Visit>
void for_each_entity(const StateNode& state, const Vocabulary&, Visit visit) {
  visit(Entity{&state_spec(), NameSpace::kState, state.keyword, state.attributes});
  for (const auto& condition : state.conditions)
    visit(Entity{&condition_spec(), std::nullopt, condition.type, condition.attributes});
}

template <class Visit>
void for_each_entity(const ExpectNode& expectation, const Vocabulary&, Visit visit) {
  visit(Entity{&expect_spec(), std::nullopt, expectation.keyword, expectation.attributes});
  const auto specs = step_specs();
  for (const auto& step : expectation.steps) {
    const auto spec = std::ranges::find(specs, step.type.text, &ComponentSpec::name);
    visit(Entity{spec == specs.end() ? nullptr : &*spec, std::nullopt, step.type, step.attributes});
  }
}

template <class Node, class Visit>
void for_each_entity(const Node&, const Vocabulary&, Visit) {}

/// Calls `visit` for every entity in the order of the text.
template <class Visit>
void for_each_entity(const SyntaxTree& tree, const Vocabulary& vocabulary, Visit visit) {
  for (const auto& node : tree)
    std::visit([&](const auto& each) { for_each_entity(each, vocabulary, visit); }, node);
}

}  // namespace galilean::bhdl::lsp
