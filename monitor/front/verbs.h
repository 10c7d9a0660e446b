// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::front {

/// One thing that `galilean` does, in one word or two: a program beside it, with what goes before
/// the user's words.
struct Verb {
  std::string_view name;
  std::string_view program;
  std::string_view first_argument;  ///< or empty
  std::string_view help;
};

[[nodiscard]] std::span<const Verb> verbs() noexcept;
/// nullptr if there is none of that name.
[[nodiscard]] const Verb* find_verb(std::string_view name) noexcept;
/// What an unknown verb is answered with.
[[nodiscard]] std::string unknown_verb(std::string_view name);
/// The list of all.
[[nodiscard]] std::string usage();

}  // namespace galilean::front
