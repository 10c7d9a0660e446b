#pragma once

#include <concepts>
#include <ranges>
#include <string>
#include <string_view>

namespace galilean::bhdl {

/// How many letters must be added, left out, changed or swapped with their neighbour to turn one
/// name into the other (Damerau-Levenshtein, optimal string alignment); `limit` + 1 if more than
/// `limit`. Upper and lower case are the same.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b, int limit);

/// How far a misspelling of `word` may be from what was meant: a third of its letters, at most 3.
[[nodiscard]] int tolerance(std::string_view word) noexcept;

/// The nearest of `names` that `word` may be a misspelling of; empty if none is near. Only the
/// first thousands are looked at: a hint is worth no more.
template <std::ranges::input_range Names>
requires std::convertible_to<std::ranges::range_reference_t<Names>, std::string_view>
[[nodiscard]] std::string nearest(std::string_view word, Names&& names) {
  int best = tolerance(word) + 1;
  std::string found;
  for (const std::string_view name : std::forward<Names>(names) | std::views::take(4000)) {
    const int distance = edit_distance(word, name, best - 1);
    if (distance >= best) continue;
    best = distance;
    found = name;
  }
  return found;
}

/// "did you mean 'x'?", or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view name);

}  // namespace galilean::bhdl
