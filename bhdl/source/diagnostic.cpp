// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/diagnostic.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/visible_text.h"

namespace galilean::bhdl {

std::string_view to_string(Severity severity) noexcept {
  return severity == Severity::kError ? "error" : "warning";
}

std::string format(const Diagnostic& diagnostic) {
  std::string text = visible(diagnostic.file) + ':' + std::to_string(diagnostic.line) + ':' +
                     std::to_string(diagnostic.column) + ": ";
  text.append(to_string(diagnostic.severity)).append(": ").append(visible(diagnostic.message));
  if (!diagnostic.hint.empty()) text.append("\n  hint: ").append(visible(diagnostic.hint));
  return text;
}

void to_json(nlohmann::json& json, const Diagnostic& diagnostic) {
  json = {{"file", diagnostic.file},     {"line", diagnostic.line},
          {"column", diagnostic.column}, {"severity", to_string(diagnostic.severity)},
          {"code", diagnostic.code},     {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

bool any_error(const std::vector<Diagnostic>& diagnostics) noexcept {
  return std::ranges::any_of(
      diagnostics, [](const Diagnostic& each) { return each.severity == Severity::kError; });
}

void Diagnostics::error(const Location& at, std::string_view code, std::string message, Hint hint,
                        std::vector<RelatedPlace> related) {
  ++errors_;
  add({at.file, at.line, at.column, Severity::kError, std::string(code), std::move(message),
       std::move(hint.text), std::move(hint.replacement), std::move(related)});
}

void Diagnostics::warning(const Location& at, std::string_view code, std::string message, Hint hint,
                          std::vector<RelatedPlace> related) {
  add({at.file, at.line, at.column, Severity::kWarning, std::string(code), std::move(message),
       std::move(hint.text), std::move(hint.replacement), std::move(related)});
}

void Diagnostics::add(Diagnostic diagnostic) {
  // Warnings stop early, so that no number of them hides the error that stops the program.
  if (diagnostic.severity == Severity::kError ? full() : full_of_warnings())
    ++left_off_;
  else
    kept_.push_back(std::move(diagnostic));
}

void Diagnostics::add(const Diagnostics& more) {
  for (const auto& each : more.kept_) add(each);
  left_off_ += more.left_off_;
  errors_ += more.errors_;
}

std::vector<Diagnostic> Diagnostics::take(const std::vector<std::string>& files_in_order) && {
  const auto rank = [&](const Diagnostic& each) {
    const auto file = std::ranges::find(files_in_order, each.file) - files_in_order.begin();
    return std::tuple(file, each.line, each.column);
  };
  std::ranges::stable_sort(
      kept_, [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
  if (left_off_ > 0) {
    Diagnostic last = kept_.back();
    last.severity = errors_ > 0 ? Severity::kError : Severity::kWarning;
    last.code = "too-many";
    last.message = "and " + std::to_string(left_off_) + " more";
    last.replacement.clear();
    last.related.clear();
    last.hint = "correct these first: many of the rest may go with them";
    kept_.push_back(std::move(last));
  }
  return std::move(kept_);
}

}  // namespace galilean::bhdl
