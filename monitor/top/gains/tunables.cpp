// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/tunables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bhdl/syntax/parser.h"
#include "bhdl/syntax/value_lowering.h"
#include "monitor/top/gains/range.h"

namespace galilean::monitor::top {
namespace {

using bhdl::Node;
using bhdl::NodeKind;
using bhdl::ParseTree;
using bhdl::ValueNode;

constexpr std::array kTuned{
    Role::kGain,           Role::kThreshold,      Role::kLeastArea,  Role::kCertaintyAtLeast,
    Role::kCertaintyBelow, Role::kDistanceAtMost, Role::kTimeAtLeast};

/// A component as it stands in a text: its attributes' values by the attributes' names.
struct WrittenComponent {
  const ComponentSpec* spec = nullptr;
  std::string name;
  std::vector<std::pair<const AttributeSpec*, std::vector<ValueNode>>> attributes;

  [[nodiscard]] const std::vector<ValueNode>* find(std::string_view attribute) const {
    for (const auto& [each, values] : attributes)
      if (each->name == attribute) return &values;
    return nullptr;
  }
};

std::vector<ValueNode> values_of(const ParseTree& tree, std::uint32_t attribute) {
  std::vector<ValueNode> values;
  for (const auto child : tree.children(attribute))
    if (tree.nodes[child].kind == NodeKind::kValue)
      values.push_back(bhdl::lowered_value(tree, tree.nodes[child], ""));
  return values;
}

std::optional<WrittenComponent> component_at(const ParseTree& tree, std::uint32_t node,
                                             const Catalog& catalog) {
  const std::string_view type = tree.first_token(tree.nodes[node]).text;
  WrittenComponent component{.spec = catalog.find(type), .name = std::string(type)};
  if (!component.spec) return std::nullopt;
  for (const auto child : tree.children(node)) {
    if (tree.nodes[child].kind != NodeKind::kAttribute) continue;
    const std::string_view label = tree.first_token(tree.nodes[child]).text;
    auto values = values_of(tree, child);
    if (label == "name" && !values.empty()) component.name = values[0].text;
    if (const AttributeSpec* spec = component.spec->find(label))
      component.attributes.emplace_back(spec, std::move(values));
  }
  return component;
}

/// Returns what an attribute's numbers belong to, one after another, such as the gains' inputs.
std::vector<std::string> owners_of(const WrittenComponent& component, const AttributeSpec& spec) {
  std::vector<std::string> names;
  const auto* owners = spec.one_for_each.empty() ? nullptr : component.find(spec.of);
  if (!owners) return names;
  for (const ValueNode& owner : *owners) names.emplace_back(owner.text);
  return names;
}

Tunable tunable_of(const WrittenComponent& component, const AttributeSpec& spec,
                   const ValueNode& number, const std::string& owner, std::size_t place) {
  const std::string unit(number.unit ? number.unit->symbol : std::string_view());
  const Range range = range_of(number.number, unit, spec);
  return {.key = component.spec->name + " " + component.name + " " + spec.name + " " +
                 (owner.empty() ? std::to_string(place) : owner),
          .schema = component.name,
          .label = owner.empty() ? spec.name : "gain of " + owner,
          .unit = unit.empty() ? std::string(spec.unit.symbol) : unit,
          .value = number.number,
          .min = range.min,
          .max = range.max,
          .step = range.step,
          .size = number.text.size()};
}

void add_tunables(const WrittenComponent& component, const ParseTree& tree, std::size_t file,
                  std::vector<Tunable>& tunables) {
  for (const auto& [spec, values] : component.attributes) {
    if (std::ranges::find(kTuned, spec->role) == kTuned.end()) continue;
    const auto owners = owners_of(component, *spec);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].kind != ValueNode::Kind::kNumber) continue;
      Tunable tunable =
          tunable_of(component, *spec, values[i], i < owners.size() ? owners[i] : "", i);
      tunable.file = file;
      tunable.begin = tree.offset_of(values[i].text);
      tunables.push_back(std::move(tunable));
    }
  }
}

/// Numbers keys that several tunables have.
void tell_apart(std::vector<Tunable>& tunables) {
  std::map<std::string, int> seen;
  for (auto& tunable : tunables)
    if (const int times = ++seen[tunable.key]; times > 1)
      tunable.key += " #" + std::to_string(times);
}

}  // namespace

std::vector<Tunable> tunables_in(const std::vector<bhdl::SourceFile>& files,
                                 const Catalog& catalog) {
  std::vector<Tunable> tunables;
  for (std::size_t file = 0; file < files.size(); ++file) {
    bhdl::Diagnostics ignored;
    const ParseTree tree = bhdl::parse_tree(files[file].path, files[file].text, ignored);
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node)
      if (tree.nodes[node].kind == NodeKind::kComponent)
        if (const auto component = component_at(tree, node, catalog))
          add_tunables(*component, tree, file, tunables);
  }
  tell_apart(tunables);
  return tunables;
}

std::vector<bhdl::SourceFile> with_numbers(const std::vector<bhdl::SourceFile>& files,
                                           const Catalog& catalog,
                                           const std::map<std::string, std::string>& numbers) {
  auto changed = files;
  auto tunables = tunables_in(files, catalog);
  // From the end, so that the places of those before stay right.
  std::ranges::sort(tunables, std::ranges::greater{}, &Tunable::begin);
  for (const auto& tunable : tunables)
    if (const auto number = numbers.find(tunable.key); number != numbers.end())
      changed[tunable.file].text.replace(tunable.begin, tunable.size, number->second);
  return changed;
}

}  // namespace galilean::monitor::top
