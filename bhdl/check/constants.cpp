// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/constants.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include "bhdl/check/symbols.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

// A constant of one of these names would change other lines: they are a flag's words, and the word
// that begins a block.
constexpr std::array<std::string_view, 7> kReserved{"yes", "no",  "true", "false",
                                                    "on",  "off", "name"};

class ConstantWriter {
 public:
  ConstantWriter(SyntaxTree& tree, Diagnostics& diagnostics)
      : tree_(tree), diagnostics_(diagnostics) {}

  void write() {
    for (const auto& node : tree_)
      if (const auto* definitions = std::get_if<DefineNode>(&node)) announce(*definitions);
    if (places_.empty()) return;
    for (auto& node : tree_)
      if (auto* definitions = std::get_if<DefineNode>(&node)) define(*definitions);
    for (auto& node : tree_) std::visit([this](auto& each) { fill_in(each); }, node);
  }

  [[nodiscard]] std::vector<Word> unused() const {
    std::vector<Word> names;
    for (const auto& [name, constant] : defined_)
      if (!used_.contains(name)) names.push_back(constant->name);
    return names;
  }

 private:
  void announce(const DefineNode& node) {
    for (const auto& constant : node.constants) {
      places_.try_emplace(constant.name.text, constant.name.at);
      if (std::ranges::find(kReserved, constant.name.text) != kReserved.end())
        diagnostics_.error(constant.name.at, "define/reserved",
                           in_quotes(constant.name.text) + " is a word of the language",
                           "give the constant another name");
    }
  }

  void define(DefineNode& node) {
    for (auto& constant : node.constants) {
      for (const auto& value : constant.values) refuse_later(constant, value);
      fill_in(constant);
      defined_.try_emplace(constant.name.text, &constant);
    }
  }

  void refuse_later(const AttributeNode& constant, const ValueNode& value) {
    if (value.kind != ValueNode::Kind::kBareWord || defined_.contains(value.text)) return;
    const auto later = places_.find(value.text);
    if (later == places_.end()) return;
    diagnostics_.error(value.at, "define/order",
                       in_quotes(constant.name.text) + " uses " + in_quotes(value.text) +
                           ", which is defined only at " + place(later->second),
                       "a constant may use those before it");
  }

  void fill_in(SectionNode& section) {
    for (auto& component : section.components) fill_in(component);
  }
  void fill_in(StateNode& state) {
    for (auto& attribute : state.attributes) fill_in(attribute);
    for (auto& condition : state.conditions) fill_in(condition);
  }
  void fill_in(ExpectNode& expectation) {
    for (auto& attribute : expectation.attributes) fill_in(attribute);
    for (auto& step : expectation.steps) fill_in(step);
  }
  template <class Other>
  void fill_in(Other&) {}

  void fill_in(ComponentNode& component) {
    for (auto& attribute : component.attributes) fill_in(attribute);
  }

  // Constants are not put into `name`, because other components find a component by the name in the
  // text.
  void fill_in(AttributeNode& attribute) {
    const auto is_constant = [this](const ValueNode& value) { return find(value) != nullptr; };
    if (attribute.name.text == "name" || std::ranges::none_of(attribute.values, is_constant))
      return;
    std::vector<ValueNode> values;
    for (const auto& value : attribute.values) {
      const AttributeNode* constant = find(value);
      if (constant == nullptr)
        values.push_back(value);
      else
        append(*constant, value.at, values);
    }
    attribute.values = std::move(values);
  }

  [[nodiscard]] const AttributeNode* find(const ValueNode& value) const {
    if (value.kind != ValueNode::Kind::kBareWord) return nullptr;
    const auto found = defined_.find(value.text);
    return found == defined_.end() ? nullptr : found->second;
  }

  void append(const AttributeNode& constant, const Position& use, std::vector<ValueNode>& values) {
    used_.insert(constant.name.text);
    written_ += constant.values.size();
    if (written_ > kMostConstantValues) return refuse_more(constant, use, values);
    for (ValueNode value : constant.values) {
      value.at = use;
      value.constant = &constant.name;
      values.push_back(value);
    }
  }

  void refuse_more(const AttributeNode& constant, const Position& use,
                   std::vector<ValueNode>& values) {
    if (!told_)
      diagnostics_.error(
          use, "define/too-many",
          "constants stand for more than " + std::to_string(kMostConstantValues) + " values here");
    told_ = true;
    values.push_back({ValueNode::Kind::kBroken, 0, 0, constant.name.text, use});
  }

  SyntaxTree& tree_;
  Diagnostics& diagnostics_;
  std::unordered_map<std::string_view, Position> places_;
  std::unordered_map<std::string_view, const AttributeNode*> defined_;
  std::unordered_set<std::string_view> used_;
  std::size_t written_ = 0;
  bool told_ = false;
};

}  // namespace

std::vector<Word> put_in_constants(SyntaxTree& tree, Diagnostics& diagnostics) {
  ConstantWriter constants(tree, diagnostics);
  constants.write();
  return constants.unused();
}

void warn_of_unused_constants(const std::vector<Word>& unused, std::string_view main_file,
                              Diagnostics& diagnostics) {
  for (const Word& name : unused)
    if (name.at.file == main_file)
      diagnostics.warning(name.at, "define/unused",
                          "nothing uses the constant " + in_quotes(name.text),
                          "write its name where its value is meant, or take it away");
}

std::string definition_note(const ValueNode& value) {
  if (value.constant == nullptr) return {};
  return "; " + in_quotes(value.constant->text) + " is defined at " + place(value.constant->at);
}

}  // namespace galilean::bhdl
