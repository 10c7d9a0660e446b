// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::front {

/// One verb of `galilean`, which is one word or two, and the program that it starts.
struct Verb {
  std::string_view name;
  std::string_view program;
  std::string_view first_argument;  ///< goes before the user's arguments; may be empty
  std::string_view help;
};

/// One word that `galilean` obeys by itself.
struct OwnWord {
  std::string_view name;
  std::string_view help;
};

[[nodiscard]] std::span<const Verb> verbs() noexcept;
[[nodiscard]] std::span<const OwnWord> own_words() noexcept;
/// Returns the verb of that name, or nullptr if there is none.
[[nodiscard]] const Verb* find_verb(std::string_view name) noexcept;
/// Returns the message for an unknown verb.
[[nodiscard]] std::string unknown_verb(std::string_view name);
/// Returns the help text, which lists all verbs.
[[nodiscard]] std::string usage();

}  // namespace galilean::front
