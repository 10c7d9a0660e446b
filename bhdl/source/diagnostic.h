// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/location.h"

namespace galilean::bhdl {

enum class Severity { kWarning, kError };
[[nodiscard]] std::string_view to_string(Severity severity) noexcept;

/// What helps to correct a fault. A plain text becomes a hint without a replacement.
struct Hint {
  std::string text;  ///< what was meant or what to do; empty if it cannot be guessed
  std::string
      replacement;  ///< what the word or text at the fault should be instead; empty: unknown

  Hint() = default;
  Hint(std::string words, std::string instead = {})
      : text(std::move(words)), replacement(std::move(instead)) {}
  Hint(const char* words) : text(words) {}
};

/// Another place that a fault concerns: the first of two equal names, for example.
struct RelatedPlace {
  Location at;
  std::string message;
};

/// What is wrong with a program and where, for the person who wrote it. `line` and `column` count
/// from 1, columns in characters. Every position lies inside `file`.
struct Diagnostic {
  std::string file;
  int line = 1;
  int column = 1;
  Severity severity = Severity::kError;
  std::string code;         ///< stable, such as "name/unknown-attribute"; GRAMMAR.md lists them
  std::string message;      ///< what is wrong and what was expected
  std::string hint;         ///< what was meant or what to do, where it can be guessed; else empty
  std::string replacement;  ///< see Hint
  std::vector<RelatedPlace> related;  ///< for clients that can show places; the message names them
                                      ///< too
};

/// Returns `file:line:column: error: message`, and the hint on a line of its own. There is no final
/// newline. Invisible characters are shown as their codes, such as U+200B.
[[nodiscard]] std::string format(const Diagnostic& diagnostic);
void to_json(nlohmann::json& json, const Diagnostic& diagnostic);
[[nodiscard]] bool any_error(const std::vector<Diagnostic>& diagnostics) noexcept;

/// Collects what the lexer, the parser and the checker find. It keeps the first 100 and counts the
/// rest, so that a file of noise costs no more than a file with a hundred mistakes.
class Diagnostics {
 public:
  static constexpr std::size_t kMost = 100;

  void error(const Location& at, std::string_view code, std::string message, Hint hint = {},
             std::vector<RelatedPlace> related = {});
  void warning(const Location& at, std::string_view code, std::string message, Hint hint = {},
               std::vector<RelatedPlace> related = {});
  /// Returns whether nothing more is kept. A long search for a hint is then useless.
  [[nodiscard]] bool full() const noexcept { return kept_.size() >= kMost; }
  /// Returns whether no more warnings are kept. Their limit is lower.
  [[nodiscard]] bool full_of_warnings() const noexcept { return kept_.size() >= kMost / 2; }
  [[nodiscard]] bool has_errors() const noexcept { return errors_ > 0; }
  /// Returns the number of diagnostics, including those that were not kept.
  [[nodiscard]] std::size_t count() const noexcept { return kept_.size() + left_off_; }
  /// Adds all of `more`, as if it had been found here.
  void add(const Diagnostics& more);

  /// Returns the diagnostics in the order of the files, then of lines. The last says how many more
  /// there were.
  [[nodiscard]] std::vector<Diagnostic> take(const std::vector<std::string>& files_in_order) &&;

 private:
  void add(Diagnostic diagnostic);

  std::vector<Diagnostic> kept_;
  std::size_t left_off_ = 0;
  std::size_t errors_ = 0;
};

}  // namespace galilean::bhdl
