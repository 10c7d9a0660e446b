// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/extension.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include "bhdl/check/owner.h"
#include "bhdl/check/state_specs.h"
#include "bhdl/check/symbols.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr std::string_view kExtends = "extends";

/// A component or a state in the tree. It may extend another.
struct Heir {
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

const AttributeNode* extends_of(const Heir& heir) {
  const auto found = std::ranges::find_if(*heir.attributes, is_extends);
  return found == heir.attributes->end() ? nullptr : &*found;
}

const ValueNode* base_name(const Heir& heir) {
  const AttributeNode* extends = extends_of(heir);
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
        heirs_.push_back({name_space(spec->kind), spec, node.type, &node.attributes, nullptr});
    }
  }
  void add(StateNode& node) {
    heirs_.push_back(
        {NameSpace::kState, &state_spec(), node.keyword, &node.attributes, &node.conditions});
  }
  template <class Other>
  void add(Other&) {}

  Bases resolve() && {
    if (std::ranges::none_of(heirs_, [](const Heir& heir) { return extends_of(heir) != nullptr; }))
      return {};
    for (auto& heir : heirs_)
      if (const ValueNode* name = given_name(*heir.attributes))
        by_name_[index(heir.space)].try_emplace(name->text, &heir);
    for (auto& heir : heirs_) check(heir);
    for (auto& heir : heirs_) resolve(heir);
    for (auto& heir : heirs_) std::erase_if(*heir.attributes, is_extends);
    return std::move(bases_);
  }

 private:
  static std::size_t index(NameSpace space) noexcept { return static_cast<std::size_t>(space); }

  void check(const Heir& heir) {
    const ValueNode* name = base_name(heir);
    if (name == nullptr) return;
    const bool one = std::ranges::count_if(*heir.attributes, is_extends) == 1 &&
                     extends_of(heir)->values.size() == 1;
    if (!one || name->kind != ValueNode::Kind::kText)
      diagnostics_.error(
          extends_of(heir)->name.at, "type/wrong-value",
          "'extends' of " + label({heir.type, *heir.attributes}) + " takes one name in quotes");
    else if (base_of(heir) == nullptr && text_is_whole_)
      refuse_undefined(heir, *name);
  }

  // A base is completed before what extends it. The chain is walked without recursion, because it
  // may be as long as the program.
  void resolve(Heir& heir) {
    std::vector<Heir*> chain;
    for (Heir* each = &heir; each != nullptr && each->stage == Heir::Stage::kOpen;) {
      each->stage = Heir::Stage::kOnTheWay;
      chain.push_back(each);
      each = base_of(*each);
      if (each != nullptr && each->stage == Heir::Stage::kOnTheWay) refuse_cycle(*chain.back());
    }
    for (; !chain.empty(); chain.pop_back()) {
      Heir& next = *chain.back();
      Heir* base = base_of(next);
      if (base != nullptr && base->stage == Heir::Stage::kDone) inherit(next, *base);
      next.stage = Heir::Stage::kDone;
    }
  }

  [[nodiscard]] Heir* base_of(const Heir& heir) const {
    const ValueNode* name = base_name(heir);
    if (name == nullptr) return nullptr;
    const auto& names = by_name_[index(heir.space)];
    const auto found = names.find(name->text);
    return found == names.end() ? nullptr : found->second;
  }

  void inherit(Heir& heir, const Heir& base) {
    if (told_) return;
    if (heir.spec != base.spec) return refuse_type(heir, base);
    note(heir.space, base_name(heir)->text);
    const auto own = own_attributes(heir);
    std::vector<AttributeNode> inherited;
    for (const auto& attribute : *base.attributes)
      if (!own.contains(own_name(heir, attribute)) && !is_extends(attribute) &&
          attribute.name.text != name_spec().name)
        inherited.push_back(attribute);
    std::vector<ComponentNode> conditions;
    if (base.conditions != nullptr) conditions = *base.conditions;
    if (!fits(inherited, conditions, *base_name(heir))) return;
    for (auto& attribute : inherited) {
      attribute.inherited = true;
      heir.attributes->push_back(std::move(attribute));
    }
    for (auto& condition : conditions) {
      condition.inherited = true;
      heir.conditions->push_back(std::move(condition));
    }
  }

  // An attribute is the same under its name and under an alias.
  static std::string_view own_name(const Heir& heir, const AttributeNode& attribute) {
    const AttributeSpec* spec = heir.spec->find(attribute.name.text);
    return spec == nullptr ? attribute.name.text : std::string_view(spec->name);
  }
  static std::unordered_set<std::string_view> own_attributes(const Heir& heir) {
    std::unordered_set<std::string_view> own;
    for (const auto& attribute : *heir.attributes) own.insert(own_name(heir, attribute));
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
    if (space == NameSpace::kState) bases_.states.insert(name);
    if (space == NameSpace::kPerceptualSchema) bases_.perceptual_schemas.insert(name);
    if (space == NameSpace::kMotorSchema) bases_.motor_schemas.insert(name);
  }

  void refuse_cycle(const Heir& heir) {
    diagnostics_.error(base_name(heir)->at, "extends/cycle",
                       label({heir.type, *heir.attributes}) + " extends " +
                           in_quotes(base_name(heir)->text) + ", which extends it",
                       "take one 'extends:' of the circle away");
  }

  void refuse_type(const Heir& heir, const Heir& base) {
    diagnostics_.error(base_name(heir)->at, "extends/wrong-type",
                       label({heir.type, *heir.attributes}) + " cannot extend " +
                           label({base.type, *base.attributes}) +
                           ", which is of another type: see " + place(base.type.at));
  }

  [[nodiscard]] std::string nearest_base(const Heir& heir, std::string_view name) const {
    if (diagnostics_.full()) return {};
    std::vector<std::string_view> names;
    for (const auto& each : heirs_)
      if (const ValueNode* other = given_name(*each.attributes);
          other != nullptr && each.space == heir.space)
        names.push_back(other->text);
    return nearest(name, names);
  }

  void refuse_undefined(const Heir& heir, const ValueNode& name) {
    diagnostics_.error(name.at, "extends/undefined",
                       label({heir.type, *heir.attributes}) + " extends " + in_quotes(name.text) +
                           ", but there is no such " + std::string(in_words(heir.space)),
                       did_you_mean(nearest_base(heir, name.text)));
  }

  const Vocabulary& vocabulary_;
  bool text_is_whole_;
  Diagnostics& diagnostics_;
  std::vector<Heir> heirs_;
  std::array<std::unordered_map<std::string_view, Heir*>, 6> by_name_;
  Bases bases_;
  std::size_t inherited_ = 0;
  bool told_ = false;
};

}  // namespace

Bases inherit(SyntaxTree& tree, const Vocabulary& vocabulary, bool text_is_whole,
              Diagnostics& diagnostics) {
  Inheritance inheritance(vocabulary, text_is_whole, diagnostics);
  for (auto& node : tree) std::visit([&](auto& each) { inheritance.add(each); }, node);
  return std::move(inheritance).resolve();
}

}  // namespace galilean::bhdl
