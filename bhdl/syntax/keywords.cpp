// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/keywords.h"

#include <algorithm>
#include <array>
#include <span>

#include "bhdl/source/names.h"

namespace galilean::bhdl {
namespace {

struct SectionWord {
  std::string_view word;
  std::optional<ComponentKind> components;
  bool takes_value;
};

// Where a kind has two words, the first is the one that the reference uses.
constexpr std::array<SectionWord, 13> kSections{{
    {"input_devices", ComponentKind::kInputDevice, false},
    {"output_devices", ComponentKind::kOutputDevice, false},
    {"variables", ComponentKind::kVariable, false},
    {"perceptual_schemas", ComponentKind::kPerceptualSchema, false},
    {"percp_schemas", ComponentKind::kPerceptualSchema, false},
    {"motor_schemas", ComponentKind::kMotorSchema, false},
    {"states", std::nullopt, false},
    {"state", std::nullopt, false},
    {"define", std::nullopt, false},
    {"expect", std::nullopt, false},
    {"include", std::nullopt, true},
    {"start_state", std::nullopt, true},
    {"on_swap", std::nullopt, true},
}};
constexpr std::array<std::string_view, 5> kStateWords{"name", "perceptual_schemas", "percp_schemas",
                                                      "motor_schemas", "condition"};

bool is_state_word(std::string_view word) {
  return std::ranges::find(kStateWords, word) != kStateWords.end();
}

bool names_schema_list(std::string_view word) {
  const auto kind = section_kind(word);
  return kind == ComponentKind::kPerceptualSchema || kind == ComponentKind::kMotorSchema;
}

// Every word of a program is looked up here. Length and first letter are compared before the rest,
// because most words differ in them.
const SectionWord* find_section(std::string_view word) noexcept {
  for (const auto& each : kSections)
    if (each.word.size() == word.size() && each.word.front() == word.front() && each.word == word)
      return &each;
  return nullptr;
}

}  // namespace

std::optional<ComponentKind> section_kind(std::string_view word) noexcept {
  const auto* found = find_section(word);
  return found == nullptr ? std::nullopt : found->components;
}

std::string_view section_word(ComponentKind kind) noexcept {
  const auto* found = std::ranges::find(kSections, kind, &SectionWord::components);
  return found->word;
}

std::vector<std::string_view> opening_words() {
  std::vector<std::string_view> words;
  for (const auto& each : kSections) words.push_back(each.word);
  return words;
}

std::vector<std::string_view> section_words() {
  std::vector<std::string_view> words;
  for (const auto& each : kSections)
    if (each.word != "state" && each.word != "percp_schemas") words.push_back(each.word);
  return words;
}

bool at_section(const TokenStream& tokens) {
  if (!tokens.at(TokenKind::kWord)) return false;
  const auto* found = find_section(tokens.peek().text);
  if (found == nullptr) return false;
  if (found->takes_value) return tokens.at_label() || tokens.peek(1).kind == TokenKind::kText;
  return tokens.at_bare_label();
}

bool at_section_word(const TokenStream& tokens) {
  const bool known = find_section(tokens.peek().text) != nullptr;
  return at_section(tokens) || (known && tokens.at_label());
}

std::string_view meant_section(const TokenStream& tokens) {
  if (!tokens.at_label()) return {};
  const bool has_value = tokens.value_at(2);
  std::array<std::string_view, kSections.size()> words;
  std::size_t count = 0;
  for (const auto& each : kSections)
    if (each.takes_value == has_value) words[count++] = each.word;
  const auto name = nearest(tokens.peek().text, std::span(words).first(count));
  const auto* found = find_section(name);
  return found == nullptr ? std::string_view() : found->word;
}

bool at_schema_list(const TokenStream& tokens) {
  if (!tokens.at_label() || !names_schema_list(tokens.peek().text)) return false;
  return !tokens.at_label_before_label() || is_state_word(tokens.peek(2).text);
}

bool at_next_part_of_state(const TokenStream& tokens) {
  return tokens.at_label("condition") || at_schema_list(tokens);
}

void take_end(TokenStream& tokens) {
  tokens.take();
  if (tokens.at(TokenKind::kColon)) tokens.take();
}

}  // namespace galilean::bhdl
