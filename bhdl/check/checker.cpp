// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/checker.h"

#include <algorithm>

#include "bhdl/check/attribute_reader.h"
#include "bhdl/check/constants.h"
#include "bhdl/check/declarations.h"
#include "bhdl/check/expectation_reader.h"
#include "bhdl/check/extension.h"
#include "bhdl/check/state_specs.h"
#include "bhdl/check/value_or_nothing.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

std::string text(const AttributeValues& values, std::string_view name) {
  return value_or_nothing<std::string>(values, name);
}

std::vector<std::string> names(const AttributeValues& values, std::string_view name) {
  return value_or_nothing<std::vector<std::string>>(values, name);
}

BitUpdate bit_update(const std::string& word) {
  for (auto each : {BitUpdate::kSet, BitUpdate::kClear, BitUpdate::kToggle})
    if (to_string(each) == word) return each;
  return BitUpdate::kSame;
}

std::vector<Component>& components(Program& program, ComponentKind kind) {
  if (kind == ComponentKind::kVariable) return program.variables;
  if (kind == ComponentKind::kPerceptualSchema) return program.perceptual_schemas;
  if (kind == ComponentKind::kMotorSchema) return program.motor_schemas;
  return program.devices;
}

class ProgramReader {
 public:
  ProgramReader(const Vocabulary& vocabulary, const Symbols& symbols, bool text_is_whole,
                Diagnostics& diagnostics)
      : vocabulary_(vocabulary),
        symbols_(symbols),
        text_is_whole_(text_is_whole),
        diagnostics_(diagnostics),
        attributes_(symbols, text_is_whole, diagnostics) {}

  void read(const SectionNode& section) {
    for (const auto& node : section.components) {
      const ComponentSpec* spec = vocabulary_.find(node.type.text);
      if (spec == nullptr) continue;
      Component component{spec->name, spec->name, spec->kind,
                          attributes_.read(*spec, node.type, node.attributes), node.type.at};
      if (!is_device(spec->kind)) component.name = text(component.attributes, "name");
      components(program_, spec->kind).push_back(std::move(component));
    }
  }

  void read(const StateNode& node) {
    const auto values = attributes_.read(state_spec(), node.keyword, node.attributes);
    State state{text(values, "name"),
                names(values, "perceptual_schemas"),
                names(values, "motor_schemas"),
                {},
                node.keyword.at};
    for (const auto& each : node.conditions) add_condition(each, state.conditions);
    program_.states.push_back(std::move(state));
  }

  void read(const StartStateNode& node) {
    symbols_.check_state(node.state, "'start_state'", text_is_whole_, diagnostics_);
    if (start_)
      diagnostics_.error(node.state.at, "name/duplicate",
                         "there is a 'start_state' already: the first is at " + place(start_->at));
    else
      start_ = node.state;
  }

  void read(const SwapNode& node) {
    symbols_.check_state(node.new_state, "'on_swap'", text_is_whole_, diagnostics_);
    const auto [first, is_new] = swaps_.try_emplace(node.old_state.text, node.old_state.at);
    if (!is_new)
      diagnostics_.error(node.old_state.at, "name/duplicate",
                         "'on_swap' maps " + in_quotes(node.old_state.text) +
                             " already: the first is at " + place(first->second));
    else if (symbols_.find(NameSpace::kState, node.old_state.text) != nullptr)
      diagnostics_.warning(node.old_state.at, "name/unused-mapping",
                           "this program has the state " + in_quotes(node.old_state.text) +
                               " itself: a swap stays in it and never uses this line");
    program_.on_swap.emplace(node.old_state.text, node.new_state.text);
  }

  void read(const ExpectNode& node) {
    program_.expectations.push_back(read_expectation(node, attributes_, diagnostics_));
  }

  void read(const IncludeNode&) {}
  void read(const DefineNode&) {}

  [[nodiscard]] Program program() && {
    if (start_)
      program_.start_state = start_->text;
    else if (!program_.states.empty())
      program_.start_state = program_.states.front().name;
    return std::move(program_);
  }

 private:
  // A state's own condition replaces an inherited one that tests the same bit for the same value.
  void add_condition(const ComponentNode& node, std::vector<Condition>& conditions) const {
    Diagnostics reported_at_base;
    const AttributeReader at_base(symbols_, text_is_whole_, reported_at_base);
    Condition read = condition(node, node.inherited ? at_base : attributes_);
    const auto tests_the_same = [&](const Condition& each) {
      return each.bits_variable == read.bits_variable && each.bit_index == read.bit_index &&
             each.bit_value == read.bit_value;
    };
    if (!node.inherited || std::ranges::none_of(conditions, tests_the_same))
      conditions.push_back(std::move(read));
  }

  [[nodiscard]] static Condition condition(const ComponentNode& node,
                                           const AttributeReader& attributes) {
    const auto values = attributes.read(condition_spec(), node.type, node.attributes);
    return {text(values, "bits_variable"),
            static_cast<unsigned>(value_or_nothing<double>(values, "bit_index")),
            value_or_nothing<bool>(values, "bit_value"),
            bit_update(text(values, "bit_update")),
            text(values, "new_state"),
            names(values, "reset_variables"),
            node.type.at};
  }

  const Vocabulary& vocabulary_;
  const Symbols& symbols_;
  bool text_is_whole_;
  Diagnostics& diagnostics_;
  AttributeReader attributes_;
  Program program_;
  std::optional<Word> start_;
  std::unordered_map<std::string_view, Position> swaps_;
};

}  // namespace

CheckedTree check_tree(SyntaxTree tree, const std::string& main_file, const Vocabulary& vocabulary,
                       Diagnostics& diagnostics) {
  return_lost_attributes(tree, vocabulary, diagnostics);
  const bool text_is_whole = !diagnostics.has_errors();
  std::vector<Word> unused_constants = put_in_constants(tree, diagnostics);
  ExtendedNames extended = inherit(tree, vocabulary, text_is_whole, diagnostics);
  const Symbols symbols = declare_names(tree, vocabulary, diagnostics);
  ProgramReader reader(vocabulary, symbols, text_is_whole, diagnostics);
  for (const auto& node : tree) std::visit([&](const auto& each) { reader.read(each); }, node);
  Program program = std::move(reader).program();
  if (program.states.empty() && text_is_whole)
    diagnostics.error({main_file, 1, 1}, "state/none",
                      "the program has no state: a robot would not know what to do",
                      "add one with 'states:'");
  return {std::move(program), std::move(tree), std::move(extended), std::move(unused_constants)};
}

}  // namespace galilean::bhdl
