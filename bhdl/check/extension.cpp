// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/extension.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include "bhdl/check/attribute_context.h"
#include "bhdl/check/state_specs.h"
#include "bhdl/check/symbols.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr std::string_view kExtends = "extends";

/// A component or a state in the tree. It may extend another.
struct Derived {
  enum class Stage { kOpen, kOnTheWay, kDone };

  NameSpace space = NameSpace::kState;
  const ComponentSpec* spec = nullptr;
  Word type;
  std::vector<AttributeNode>* attributes = nullptr;
  std::vector<ComponentNode>* conditions = nullptr;  ///< of a state; nullptr of a component
  Stage stage = Stage::kOpen;
};

bool is_extends(const AttributeNode& attribute) {
  return attribute.name.text == kExtends;
}

const AttributeNode* extends_of(const Derived& derived) {
  const auto found = std::ranges::find_if(*derived.attributes, is_extends);
  return found == derived.attributes->end() ? nullptr : &*found;
}

const ValueNode* base_name(const Derived& derived) {
  const AttributeNode* extends = extends_of(derived);
  return extends == nullptr ? nullptr : &extends->values.front();
}

class Inheritance {
 public:
  Inheritance(const Vocabulary& vocabulary, bool text_is_whole, Diagnostics& diagnostics)
      : vocabulary_(vocabulary), text_is_whole_(text_is_whole), diagnostics_(diagnostics) {}

  void add(SectionNode& section) {
    for (auto& node : section.components) {
      const ComponentSpec* spec = vocabulary_.find(node.type.text);
      if (spec != nullptr && !is_device(spec->kind))
        derived_.push_back({name_space(spec->kind), spec, node.type, &node.attributes, nullptr});
    }
  }
  void add(StateNode& node) {
    derived_.push_back(
        {NameSpace::kState, &state_spec(), node.keyword, &node.attributes, &node.conditions});
  }
  template <class Other>
  void add(Other&) {}

  ExtendedNames resolve() && {
    if (std::ranges::none_of(derived_,
                             [](const Derived& derived) { return extends_of(derived) != nullptr; }))
      return {};
    for (auto& derived : derived_)
      if (const ValueNode* name = given_name(*derived.attributes))
        by_name_[index(derived.space)].try_emplace(name->text, &derived);
    for (auto& derived : derived_) check(derived);
    for (auto& derived : derived_) resolve(derived);
    for (auto& derived : derived_) std::erase_if(*derived.attributes, is_extends);
    return std::move(extended_);
  }

 private:
  static std::size_t index(NameSpace space) noexcept { return static_cast<std::size_t>(space); }

  void check(const Derived& derived) {
    const ValueNode* name = base_name(derived);
    if (name == nullptr) return;
    const bool one = std::ranges::count_if(*derived.attributes, is_extends) == 1 &&
                     extends_of(derived)->values.size() == 1;
    if (!one || name->kind != ValueNode::Kind::kText)
      diagnostics_.error(extends_of(derived)->name.at, "type/wrong-value",
                         "'extends' of " + label({derived.type, *derived.attributes}) +
                             " takes one name in quotes");
    else if (base_of(derived) == nullptr && text_is_whole_)
      refuse_undefined(derived, *name);
  }

  // A base is completed before what extends it. The chain is walked without recursion, because it
  // may be as long as the program.
  void resolve(Derived& derived) {
    std::vector<Derived*> chain;
    for (Derived* each = &derived; each != nullptr && each->stage == Derived::Stage::kOpen;) {
      each->stage = Derived::Stage::kOnTheWay;
      chain.push_back(each);
      each = base_of(*each);
      if (each != nullptr && each->stage == Derived::Stage::kOnTheWay) refuse_cycle(*chain.back());
    }
    for (; !chain.empty(); chain.pop_back()) {
      Derived& next = *chain.back();
      Derived* base = base_of(next);
      if (base != nullptr && base->stage == Derived::Stage::kDone) inherit(next, *base);
      next.stage = Derived::Stage::kDone;
    }
  }

  [[nodiscard]] Derived* base_of(const Derived& derived) const {
    const ValueNode* name = base_name(derived);
    if (name == nullptr) return nullptr;
    const auto& names = by_name_[index(derived.space)];
    const auto found = names.find(name->text);
    return found == names.end() ? nullptr : found->second;
  }

  void inherit(Derived& derived, const Derived& base) {
    if (told_) return;
    if (derived.spec != base.spec) return refuse_type(derived, base);
    note(derived.space, base_name(derived)->text);
    const auto own = own_attributes(derived);
    std::vector<AttributeNode> inherited;
    for (const auto& attribute : *base.attributes)
      if (!own.contains(own_name(derived, attribute)) && !is_extends(attribute) &&
          attribute.name.text != name_spec().name)
        inherited.push_back(attribute);
    std::vector<ComponentNode> conditions;
    if (base.conditions != nullptr) conditions = *base.conditions;
    if (!fits(inherited, conditions, *base_name(derived))) return;
    for (auto& attribute : inherited) {
      attribute.inherited = true;
      derived.attributes->push_back(std::move(attribute));
    }
    for (auto& condition : conditions) {
      condition.inherited = true;
      derived.conditions->push_back(std::move(condition));
    }
  }

  // An attribute is the same under its name and under an alias.
  static std::string_view own_name(const Derived& derived, const AttributeNode& attribute) {
    const AttributeSpec* spec = derived.spec->find(attribute.name.text);
    return spec == nullptr ? attribute.name.text : std::string_view(spec->name);
  }
  static std::unordered_set<std::string_view> own_attributes(const Derived& derived) {
    std::unordered_set<std::string_view> own;
    for (const auto& attribute : *derived.attributes) own.insert(own_name(derived, attribute));
    return own;
  }

  bool fits(const std::vector<AttributeNode>& attributes,
            const std::vector<ComponentNode>& conditions, const ValueNode& at) {
    for (const auto& attribute : attributes) inherited_ += 1 + attribute.values.size();
    for (const auto& condition : conditions)
      for (const auto& attribute : condition.attributes) inherited_ += 1 + attribute.values.size();
    if (inherited_ <= kMostInheritedValues) return true;
    if (!told_)
      diagnostics_.error(
          at.at, "extends/too-many",
          "more than " + std::to_string(kMostInheritedValues) + " values are inherited up to here");
    told_ = true;
    return false;
  }

  void note(NameSpace space, std::string_view name) {
    if (space == NameSpace::kState) extended_.states.insert(name);
    if (space == NameSpace::kPerceptualSchema) extended_.perceptual_schemas.insert(name);
    if (space == NameSpace::kMotorSchema) extended_.motor_schemas.insert(name);
  }

  void refuse_cycle(const Derived& derived) {
    diagnostics_.error(base_name(derived)->at, "extends/cycle",
                       label({derived.type, *derived.attributes}) + " extends " +
                           in_quotes(base_name(derived)->text) + ", which extends it",
                       "take one 'extends:' of the circle away");
  }

  void refuse_type(const Derived& derived, const Derived& base) {
    diagnostics_.error(base_name(derived)->at, "extends/wrong-type",
                       label({derived.type, *derived.attributes}) + " cannot extend " +
                           label({base.type, *base.attributes}) +
                           ", which is of another type: see " + place(base.type.at));
  }

  [[nodiscard]] std::string nearest_base(const Derived& derived, std::string_view name) const {
    if (diagnostics_.full()) return {};
    std::vector<std::string_view> names;
    for (const auto& each : derived_)
      if (const ValueNode* other = given_name(*each.attributes);
          other != nullptr && each.space == derived.space)
        names.push_back(other->text);
    return nearest(name, names);
  }

  void refuse_undefined(const Derived& derived, const ValueNode& name) {
    diagnostics_.error(name.at, "extends/undefined",
                       label({derived.type, *derived.attributes}) + " extends " +
                           in_quotes(name.text) + ", but there is no such " +
                           std::string(in_words(derived.space)),
                       did_you_mean(nearest_base(derived, name.text)));
  }

  const Vocabulary& vocabulary_;
  bool text_is_whole_;
  Diagnostics& diagnostics_;
  std::vector<Derived> derived_;
  std::array<std::unordered_map<std::string_view, Derived*>, 6> by_name_;
  ExtendedNames extended_;
  std::size_t inherited_ = 0;
  bool told_ = false;
};

}  // namespace

ExtendedNames inherit(SyntaxTree& tree, const Vocabulary& vocabulary, bool text_is_whole,
                      Diagnostics& diagnostics) {
  Inheritance inheritance(vocabulary, text_is_whole, diagnostics);
  for (auto& node : tree) std::visit([&](auto& each) { inheritance.add(each); }, node);
  return std::move(inheritance).resolve();
}

}  // namespace galilean::bhdl
