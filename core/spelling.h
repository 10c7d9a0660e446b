// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace galilean {

/// Returns how many letters must be added, left out, changed or swapped with their neighbour to
/// turn one name into the other (Damerau-Levenshtein, optimal string alignment). Returns `limit` +
/// 1 if it is more than `limit`. Upper and lower case are equal.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b, int limit);

/// Returns how far a misspelling of `word` may be from what was meant: a third of its letters, at
/// most 3.
[[nodiscard]] int tolerance(std::string_view word) noexcept;

/// Returns the nearest of `names` that `word` may be a misspelling of, or an empty text if none is
/// near. Only the first thousands of names are searched, to limit the time for a hint.
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string_view> names);

/// Returns the name that `word` may be a misspelling of, or the only one that it is the beginning
/// of, or an empty text. Of several that are as near, one of the nearest length is taken.
[[nodiscard]] std::string meant_name(std::string_view word,
                                     std::span<const std::string_view> names);

/// Returns the names of `specs`, in their order.
template <class Specs>
[[nodiscard]] std::vector<std::string_view> names_of(const Specs& specs) {
  std::vector<std::string_view> names;
  for (const auto& spec : specs) names.push_back(spec.name);
  return names;
}

}  // namespace galilean
