// SPDX-License-Identifier: BSD-3-Clause
#include "core/spelling.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

namespace galilean {
namespace {

constexpr std::size_t kLongestName = 64;
constexpr std::size_t kMostLookedAt = 4000;
using Row = std::array<int, kLongestName + 1>;

char folded(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Returns the set of a word's letters as bits. Other characters share these bits.
std::uint32_t letters(std::string_view word) noexcept {
  std::uint32_t mask = 0;
  for (const char each : word) mask |= 1U << (static_cast<unsigned char>(folded(each)) & 31U);
  return mask;
}

// One edit changes at most two bits: it adds a letter, takes one away or does both. Most words
// differ by far more, so that this test avoids their distance.
bool differ_in_letters(std::string_view a, std::string_view b, int limit) noexcept {
  return std::popcount(letters(a) ^ letters(b)) > 2 * limit;
}

/// Returns the name that is as near to `word` as `near` is, and whose length is nearest.
std::string of_nearest_length(std::string_view word, std::string_view near,
                              std::span<const std::string_view> names) {
  const int distance = edit_distance(word, near, tolerance(word));
  const auto length_difference = [&](std::string_view name) {
    return std::abs(static_cast<int>(name.size()) - static_cast<int>(word.size()));
  };
  std::string_view best = near;
  for (const std::string_view name : names)
    if (edit_distance(word, name, distance) == distance &&
        length_difference(name) < length_difference(best))
      best = name;
  return std::string(best);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b, int limit) {
  const auto difference = static_cast<int>(a.size()) - static_cast<int>(b.size());
  if (std::max(a.size(), b.size()) > kLongestName || std::abs(difference) > limit) return limit + 1;
  if (differ_in_letters(a, b, limit)) return limit + 1;
  std::array<Row, 3> rows;  // only the part that is read is ever filled
  Row* before = &rows[0];
  Row* above = &rows[1];
  Row* row = &rows[2];
  for (std::size_t j = 0; j <= b.size(); ++j) (*above)[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int least = (*row)[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = folded(a[i - 1]) == folded(b[j - 1]);
      int cost = std::min({(*above)[j] + 1, (*row)[j - 1] + 1, (*above)[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && folded(a[i - 1]) == folded(b[j - 2]) &&
                           folded(a[i - 2]) == folded(b[j - 1]);
      if (swapped) cost = std::min(cost, (*before)[j - 2] + 1);
      (*row)[j] = cost;
      least = std::min(least, cost);
    }
    if (least > limit) return limit + 1;
    std::swap(before, above);
    std::swap(above, row);
  }
  return std::min((*above)[b.size()], limit + 1);
}

int tolerance(std::string_view word) noexcept {
  return std::clamp(static_cast<int>(word.size()) / 3, 1, 3);
}

std::string nearest(std::string_view word, std::span<const std::string_view> names) {
  int best = std::min(tolerance(word), static_cast<int>(word.size()) - 1) + 1;
  std::string found;
  for (const std::string_view name : names.first(std::min(names.size(), kMostLookedAt))) {
    const int distance = edit_distance(word, name, best - 1);
    if (distance >= best) continue;
    best = distance;
    found = name;
  }
  return found;
}

std::string meant_name(std::string_view word, std::span<const std::string_view> names) {
  constexpr std::size_t kLeastBeginning = 3;
  if (const std::string near = nearest(word, names); !near.empty())
    return of_nearest_length(word, near, names);
  const auto begins = [&](std::string_view name) { return name.starts_with(word); };
  if (word.size() < kLeastBeginning || std::ranges::count_if(names, begins) != 1) return "";
  return std::string(*std::ranges::find_if(names, begins));
}

}  // namespace galilean
