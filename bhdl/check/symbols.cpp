// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/symbols.h"

#include "bhdl/check/constants.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

std::size_t index(NameSpace space) noexcept {
  return static_cast<std::size_t>(space);
}

std::string_view undefined_code(NameSpace space) noexcept {
  if (space == NameSpace::kState) return "name/undefined-state";
  if (space == NameSpace::kVariable) return "name/undefined-variable";
  return "name/undefined-schema";
}

}  // namespace

std::string place(const Position& at) {
  return std::string(at.file) + ':' + std::to_string(at.line) + ':' + std::to_string(at.column);
}

NameSpace name_space(ComponentKind kind) noexcept {
  switch (kind) {
    case ComponentKind::kVariable:
      return NameSpace::kVariable;
    case ComponentKind::kPerceptualSchema:
      return NameSpace::kPerceptualSchema;
    case ComponentKind::kMotorSchema:
      return NameSpace::kMotorSchema;
    default:
      return NameSpace::kDevice;
  }
}

NameSpace referred_space(std::string_view refers_to) noexcept {
  if (refers_to == "state") return NameSpace::kState;
  if (refers_to == "perceptual_schema") return NameSpace::kPerceptualSchema;
  if (refers_to == "motor_schema") return NameSpace::kMotorSchema;
  return NameSpace::kVariable;
}

std::string_view in_words(NameSpace space) noexcept {
  constexpr std::array<std::string_view, 6> kWords{"device",       "variable", "perceptual schema",
                                                   "motor schema", "state",    "constant"};
  return kWords[index(space)];
}

void Symbols::declare(NameSpace space, const Word& name, std::string_view type,
                      Diagnostics& diagnostics) {
  const auto [entry, is_new] = entries_[index(space)].try_emplace(name.text, Entry{type, name.at});
  if (is_new) {
    in_order_[index(space)].push_back(name.text);
    return;
  }
  diagnostics.error(name.at, "name/duplicate",
                    "there is a " + std::string(in_words(space)) + " " + in_quotes(name.text) +
                        " already: the first is at " + place(entry->second.at),
                    {}, {{entry->second.at, "the first"}});
}

const Symbols::Entry* Symbols::find(NameSpace space, std::string_view name) const noexcept {
  const auto found = entries_[index(space)].find(name);
  return found == entries_[index(space)].end() ? nullptr : &found->second;
}

Hint Symbols::hint(NameSpace wanted, std::string_view name) const {
  for (const auto other :
       {NameSpace::kPerceptualSchema, NameSpace::kMotorSchema, NameSpace::kVariable}) {
    const bool named = other != wanted && find(other, name) != nullptr;
    const bool both_schemas = other != NameSpace::kVariable && wanted != NameSpace::kVariable &&
                              wanted != NameSpace::kState;
    if (named && both_schemas)
      return in_quotes(name) + " is a " + std::string(in_words(other)) + ": list it with those";
  }
  return did_you_mean(nearest(name, in_order_[index(wanted)]));
}

void Symbols::refuse_undefined(NameSpace wanted, const Word& name, const std::string& subject,
                               const std::string& note, Diagnostics& diagnostics) const {
  const Hint help = diagnostics.full() ? Hint() : hint(wanted, name.text);
  diagnostics.error(name.at, undefined_code(wanted),
                    subject + " names " + in_quotes(name.text) + ", but there is no such " +
                        std::string(in_words(wanted)) + note,
                    help);
}

void Symbols::check_reference(const AttributeSpec& spec, const ValueNode& name,
                              const AttributeContext& context, bool text_is_whole,
                              Diagnostics& diagnostics) const {
  if (spec.refers_to.empty()) return;
  const NameSpace wanted = referred_space(spec.refers_to);
  const auto subject = [&] { return in_quotes(spec.name) + " of " + label(context); };
  const Entry* entry = find(wanted, name.text);
  if (entry == nullptr) {
    if (text_is_whole)
      refuse_undefined(wanted, {name.text, name.at}, subject(), definition_note(name), diagnostics);
    return;
  }
  const bool any = wanted != NameSpace::kVariable || spec.refers_to == "variable";
  if (any || entry->type.empty() || entry->type == spec.refers_to) return;
  diagnostics.error(name.at, "type/wrong-variable",
                    subject() + " takes a " + spec.refers_to + " variable, but " +
                        in_quotes(name.text) + " is a " + std::string(entry->type) +
                        " variable: see " + place(entry->at) + definition_note(name),
                    {}, {{entry->at, "declared here"}});
}

void Symbols::check_state(const Word& name, const std::string& subject, bool text_is_whole,
                          Diagnostics& diagnostics) const {
  if (text_is_whole && find(NameSpace::kState, name.text) == nullptr)
    refuse_undefined(NameSpace::kState, name, subject, {}, diagnostics);
}

void Symbols::refuse_undefined_constant(const AttributeSpec& spec, const ValueNode& word,
                                        const AttributeContext& context,
                                        Diagnostics& diagnostics) const {
  const auto& constants = in_order_[index(NameSpace::kConstant)];
  const auto near = diagnostics.full() ? std::string() : nearest(word.text, constants);
  diagnostics.error(
      word.at, "name/undefined-constant",
      in_quotes(spec.name) + " of " + label(context) + " takes " + expectation(spec) +
          "; there is no constant " + in_quotes(word.text),
      near.empty() ? Hint("write the number, or name it under 'define:'") : did_you_mean(near));
}

}  // namespace galilean::bhdl
