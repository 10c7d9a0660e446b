// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/schemas/idl_reader.h"

#include <cctype>
#include <charconv>

#include "core/visible_text.h"
#include "monitor/schemas/idl_tokens.h"

namespace galilean::monitor {
namespace {

void annotate(const std::string& word, std::string_view argument, Annotations& to) {
  const std::string_view of = word == "extensibility" ? argument : std::string_view(word);
  if (of == "mutable" || of == "MUTABLE") to.extensibility = wire::Extensibility::kMutable;
  if (of == "appendable" || of == "APPENDABLE") to.extensibility = wire::Extensibility::kAppendable;
  to.optional = to.optional || word == "optional";
  to.key = to.key || word == "key";
  if (word == "value") to.value = IdlReader::whole_number(argument);
}

}  // namespace

IdlReader::IdlReader(std::string_view text) : tokens_(idl_tokens(text)) {}

void IdlReader::expect(std::string_view token) {
  if (!accept(token)) fail("'" + std::string(token) + "'");
}

void IdlReader::fail(const std::string& expected) {
  if (!ok()) return;
  problem_ = at_end() ? "ends" : "has '" + visible(next()) + "'";
  problem_ += " where " + expected + " is expected";
}

std::string IdlReader::name() {
  const auto word = next();
  const bool right = !word.empty() && (word.front() == '_' || word.front() == ':' ||
                                       std::isalpha(static_cast<unsigned char>(word.front())));
  if (right) return std::string(take());
  fail("a name");
  return {};
}

Annotations IdlReader::annotations() {
  Annotations found;
  while (ok() && accept("@")) {
    const auto word = name();
    std::string_view argument;
    if (accept("(")) {
      argument = next();
      for (int depth = 1; depth > 0 && !at_end();) {
        const auto token = take();
        depth += token == "(" ? 1 : token == ")" ? -1 : 0;
      }
    }
    annotate(word, argument, found);
  }
  return found;
}

std::optional<long long> IdlReader::whole_number(std::string_view token) {
  long long number = 0;
  const auto [end, wrong] = std::from_chars(token.data(), token.data() + token.size(), number);
  if (token.empty() || wrong != std::errc() || end != token.data() + token.size())
    return std::nullopt;
  return number;
}

}  // namespace galilean::monitor
