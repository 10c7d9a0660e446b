// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "bhdl/diff/parts.h"
#include "bhdl/program/value_words.h"

namespace galilean::bhdl {
namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;
using ByName = std::unordered_map<std::string_view, const Component*>;

ByName by_name(const std::vector<Component>& components) {
  ByName index;
  for (const auto& component : components) index.emplace(component.name, &component);
  return index;
}

std::optional<Value> written(const Value* value, const Unit& unit) {
  return value == nullptr ? std::nullopt : std::optional(from_si(*value, unit));
}

class ComponentComparison {
 public:
  ComponentComparison(Change::What what, const Component& from, const Component& to,
                      const ComponentSpec* spec, std::vector<Change>& changes)
      : what_(what), from_(from), to_(to), spec_(spec), changes_(changes) {}

  void run() {
    if (from_.type != to_.type) {
      add("type", {}, from_.type, to_.type, unit::kNone);
      return;
    }
    for (const auto& [name, value] : from_.attributes) compare(name);
    for (const auto& [name, value] : to_.attributes)
      if (from_.attributes.find(name) == nullptr) compare(name);
  }

 private:
  void compare(const std::string& name) {
    const AttributeSpec* spec = spec_ == nullptr ? nullptr : spec_->find(name);
    const Unit unit = spec == nullptr ? unit::kNone : spec->unit;
    auto before = written(from_.attributes.find(name), unit);
    auto after = written(to_.attributes.find(name), unit);
    if (before == after) return;
    if (spec != nullptr && !spec->one_for_each.empty() && compare_entries(*spec)) return;
    add(name, {}, std::move(before), std::move(after), unit);
  }

  /// Adds how each input's own gain changed. Returns false if the lists do not match one to one.
  bool compare_entries(const AttributeSpec& spec) {
    const auto before = entries(from_, spec);
    const auto after = entries(to_, spec);
    if (before.empty() || after.empty()) return false;
    for (const auto& [name, value] : before) {
      const auto found = find(after, name);
      if (found == nullptr || *found != value)
        add(spec.name, name, Value(value), found ? std::optional<Value>(*found) : std::nullopt,
            spec.unit);
    }
    for (const auto& [name, value] : after)
      if (find(before, name) == nullptr)
        add(spec.name, name, std::nullopt, Value(value), spec.unit);
    return true;
  }

  using Entries = std::vector<std::pair<std::string, double>>;

  static Entries entries(const Component& component, const AttributeSpec& spec) {
    const Value* names = component.attributes.find(spec.one_for_each);
    const Value* values = component.attributes.find(spec.name);
    const auto* keys = names == nullptr ? nullptr : std::get_if<Names>(names);
    if (keys == nullptr || values == nullptr) return {};
    const Value in_unit = from_si(*values, spec.unit);
    const auto* numbers = std::get_if<Numbers>(&in_unit);
    const std::unordered_set<std::string> unique(keys->begin(), keys->end());
    if (numbers == nullptr || numbers->size() != keys->size() || unique.size() != keys->size())
      return {};
    Entries list;
    for (std::size_t i = 0; i < keys->size(); ++i) list.emplace_back((*keys)[i], (*numbers)[i]);
    std::ranges::sort(list);
    return list;
  }

  static const double* find(const Entries& entries, const std::string& name) {
    const auto found =
        std::ranges::lower_bound(entries, name, {}, &std::pair<std::string, double>::first);
    return found == entries.end() || found->first != name ? nullptr : &found->second;
  }

  void add(const std::string& attribute, const std::string& entry, std::optional<Value> before,
           std::optional<Value> after, const Unit& unit) {
    Change change;
    change.what = what_;
    change.name = to_.name;
    change.type = what_ == Change::What::kDevice ? std::string() : to_.type;
    change.attribute = attribute;
    change.entry = entry;
    change.from = std::move(before);
    change.to = std::move(after);
    change.unit = unit;
    changes_.push_back(std::move(change));
  }

  Change::What what_;
  const Component& from_;
  const Component& to_;
  const ComponentSpec* spec_;
  std::vector<Change>& changes_;
};

void add_whole(Change::Kind kind, Change::What what, const Component& component,
               std::vector<Change>& changes) {
  Change change;
  change.kind = kind;
  change.what = what;
  change.name = component.name;
  change.type = what == Change::What::kDevice ? std::string() : component.type;
  changes.push_back(std::move(change));
}

}  // namespace

void compare_components(Change::What what, const std::vector<Component>& from,
                        const std::vector<Component>& to, const Vocabulary& vocabulary,
                        std::vector<Change>& changes) {
  const ByName before = by_name(from);
  const ByName after = by_name(to);
  for (const auto& component : from) {
    const auto found = after.find(component.name);
    if (found == after.end())
      add_whole(Change::Kind::kRemoved, what, component, changes);
    else
      ComponentComparison(what, component, *found->second, vocabulary.find(component.type), changes)
          .run();
  }
  for (const auto& component : to)
    if (!before.contains(component.name)) add_whole(Change::Kind::kAdded, what, component, changes);
}

}  // namespace galilean::bhdl
