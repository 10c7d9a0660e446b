// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/declarations.h"

#include <algorithm>
#include <iterator>

#include "bhdl/check/attribute_context.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

const AttributeSpec* lost_attribute(const ComponentNode& component,
                                    const std::vector<ComponentNode>& before,
                                    const Vocabulary& vocabulary) {
  if (before.empty() || vocabulary.find(component.type.text) != nullptr) return nullptr;
  const ComponentSpec* spec = vocabulary.find(before.back().type.text);
  return spec == nullptr ? nullptr : spec->find(component.type.text);
}

class Declarer {
 public:
  Declarer(const Vocabulary& vocabulary, Diagnostics& diagnostics)
      : vocabulary_(vocabulary), diagnostics_(diagnostics) {}

  void declare(const SectionNode& section) {
    for (const auto& component : section.components) declare(component, section);
  }
  void declare(const StateNode& state) { declare_name(NameSpace::kState, state.attributes, {}); }
  void declare(const DefineNode& node) {
    for (const auto& constant : node.constants)
      symbols_.declare(NameSpace::kConstant, constant.name, {}, diagnostics_);
  }
  template <class Other>
  void declare(const Other&) {}

  [[nodiscard]] Symbols symbols() && { return std::move(symbols_); }

 private:
  void declare(const ComponentNode& component, const SectionNode& section) {
    const ComponentSpec* spec = vocabulary_.find(component.type.text);
    if (spec == nullptr) {
      refuse_unknown(component.type);
      if (!is_device(section.kind))
        declare_name(name_space(section.kind), component.attributes, {});
      return;
    }
    if (spec->kind != section.kind) refuse_section(component.type, *spec, section);
    if (is_device(spec->kind))
      symbols_.declare(NameSpace::kDevice, component.type, spec->name, diagnostics_);
    else
      declare_name(name_space(spec->kind), component.attributes, spec->name);
  }

  void declare_name(NameSpace space, const std::vector<AttributeNode>& attributes,
                    std::string_view type) {
    const ValueNode* name = given_name(attributes);
    if (name == nullptr) return;
    if (name->text.empty())
      diagnostics_.error(name->at, "name/empty", "a name needs at least one character");
    else
      symbols_.declare(space, {name->text, name->at}, type, diagnostics_);
  }

  void refuse_unknown(const Word& type) {
    const auto near = diagnostics_.full() ? std::string()
                                          : nearest(type.text, names_of(vocabulary_.components()));
    diagnostics_.error(
        type.at, "name/unknown-component", "there is no component " + in_quotes(type.text),
        near.empty() ? Hint("`galilean bhdl describe` lists them") : did_you_mean(near));
  }

  // The published listing has its motor drive among the input devices. The section of a device
  // changes nothing, so that this is a warning only.
  void refuse_section(const Word& type, const ComponentSpec& spec, const SectionNode& section) {
    const std::string message = in_quotes(type.text) + " belongs to the " +
                                std::string(kind_in_words(spec.kind)) + "s, not in " +
                                in_quotes(section.keyword.text);
    std::string hint = "move it to '" + std::string(section_word(spec.kind)) + ":'";
    if (is_device(spec.kind) && is_device(section.kind))
      diagnostics_.warning(type.at, "name/wrong-section", message, std::move(hint));
    else
      diagnostics_.error(type.at, "name/wrong-section", message, std::move(hint));
  }

  const Vocabulary& vocabulary_;
  Diagnostics& diagnostics_;
  Symbols symbols_;
};

}  // namespace

void return_lost_attributes(SyntaxTree& tree, const Vocabulary& vocabulary,
                            Diagnostics& diagnostics) {
  for (auto& node : tree) {
    auto* section = std::get_if<SectionNode>(&node);
    if (section == nullptr) continue;
    std::vector<ComponentNode> kept;
    for (auto& component : section->components) {
      const AttributeSpec* lost = lost_attribute(component, kept, vocabulary);
      if (lost == nullptr) {
        kept.push_back(std::move(component));
        continue;
      }
      diagnostics.error(
          component.type.at, "syntax/missing-value",
          in_quotes(component.type.text) + " has no value: " + expectation(*lost) + " is expected");
      std::ranges::move(component.attributes, std::back_inserter(kept.back().attributes));
    }
    section->components = std::move(kept);
  }
}

Symbols declare_names(const SyntaxTree& tree, const Vocabulary& vocabulary,
                      Diagnostics& diagnostics) {
  Declarer declarer(vocabulary, diagnostics);
  for (const auto& node : tree) std::visit([&](const auto& each) { declarer.declare(each); }, node);
  return std::move(declarer).symbols();
}

}  // namespace galilean::bhdl
