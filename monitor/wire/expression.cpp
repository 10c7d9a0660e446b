// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/expression.h"

#include <algorithm>
#include <set>

#include "core/visible_text.h"
#include "monitor/wire/message_text.h"

namespace galilean::monitor {
namespace {

const std::set<std::string, std::less<>> kOperators{"==", "!=", "<", "<=", ">", ">="};

bool is_operator_letter(char letter) {
  return letter == '=' || letter == '!' || letter == '<' || letter == '>';
}

/// Returns where the word that starts at `begin` ends.
std::size_t end_of_word(std::string_view text, std::size_t begin) {
  std::size_t end = begin + 1;
  if (text[begin] == '"') {
    while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
  }
  const bool symbol = is_operator_letter(text[begin]);
  while (end < text.size() && text[end] != ' ' && text[end] != '"' &&
         is_operator_letter(text[end]) == symbol)
    ++end;
  return end;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\n", at)) != text.npos;) {
    const std::size_t end = end_of_word(text, at);
    words.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

Error expected(const std::string& what, const std::string& found) {
  return Error{"expected " + what +
               (found.empty() ? " at the end" : " before '" + visible(found) + "'")};
}

Result<Expression::Comparison> read_comparison(const std::string& path, const std::string& op,
                                               const std::string& value) {
  const std::size_t dot = path.find('.');
  if (dot == path.npos || dot == 0 || dot + 1 == path.size())
    return expected("TOPIC.FIELD, such as io/state.state,", path);
  if (!kOperators.contains(op)) return expected("one of == != < <= > >=", op);
  auto read = MessageTree::parse(value, nullptr, false);
  if (value.empty() || read.is_discarded() || read.is_structured() || read.is_null())
    return expected("a number, true, false or a text in double quotes", value);
  const std::size_t begin = path.front() == '/' ? 1 : 0;
  return Expression::Comparison{path.substr(begin, dot - begin), path.substr(dot + 1), op,
                                std::move(read)};
}

template <class T>
bool compare(const T& left, const std::string& op, const T& right) {
  if (op == "==") return left == right;
  if (op == "!=") return left != right;
  if (op == "<") return left < right;
  if (op == "<=") return left <= right;
  if (op == ">") return left > right;
  return left >= right;
}

const char* kind_of(const MessageTree& value) {
  if (value.is_number()) return "a number";
  if (value.is_string()) return "a text";
  return value.is_boolean() ? "true or false" : "no single value";
}

bool is_comparable(const MessageTree& left, const MessageTree& right) {
  return (left.is_number() && right.is_number()) || left.type() == right.type();
}

Result<bool> comparison_holds(const Expression::Comparison& comparison,
                              const Expression::Newest& newest) {
  const auto message = newest.find(comparison.topic);
  if (message == newest.end()) return false;
  const auto field = find_field(message->second, comparison.field);
  if (!field) return Error{"/" + visible(comparison.topic) + ": " + field.error().message};
  if (!field.value() || field.value()->is_null()) return false;
  if (!is_comparable(*field.value(), comparison.value))
    return Error{"/" + visible(comparison.topic) + ": '" + visible(comparison.field) + "' is " +
                 kind_of(*field.value()) + ", and is compared with " + kind_of(comparison.value) +
                 ", so that it can never be true"};
  return compare(*field.value(), comparison.op, comparison.value);
}

}  // namespace

Result<Expression> Expression::parse(std::string_view text) {
  const auto words = words_of(text);
  const auto word = [&](std::size_t at) { return at < words.size() ? words[at] : std::string(); };
  Expression expression;
  expression.alternatives_.emplace_back();
  for (std::size_t at = 0;; at += 4) {
    auto comparison = read_comparison(word(at), word(at + 1), word(at + 2));
    if (!comparison) return comparison.error();
    expression.alternatives_.back().push_back(std::move(comparison).value());
    if (at + 3 >= words.size()) return expression;
    if (word(at + 3) == "or")
      expression.alternatives_.emplace_back();
    else if (word(at + 3) != "and")
      return expected("'and' or 'or'", word(at + 3));
  }
}

std::vector<std::string> Expression::topics() const {
  std::set<std::string> names;
  for (const auto& alternative : alternatives_)
    for (const auto& comparison : alternative) names.insert(comparison.topic);
  return {names.begin(), names.end()};
}

Result<bool> Expression::holds(const Newest& newest) const {
  bool any = false;
  for (const auto& alternative : alternatives_) {
    bool all = true;
    for (const auto& comparison : alternative) {
      const auto held = comparison_holds(comparison, newest);
      if (!held) return held.error();
      all = all && held.value();
    }
    any = any || all;
  }
  return any;
}

}  // namespace galilean::monitor
