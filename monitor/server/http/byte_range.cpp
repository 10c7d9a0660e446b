// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/byte_range.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace galilean::monitor {
namespace {

/// Reads digits alone; a number that is too large is the largest.
std::optional<std::uint64_t> read_digits(std::string_view text) {
  std::uint64_t number = 0;
  const auto [rest, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || rest != text.data() + text.size()) return {};
  if (problem == std::errc::result_out_of_range) return std::numeric_limits<std::uint64_t>::max();
  if (problem != std::errc()) return {};
  return number;
}

ByteRange last_bytes(std::uint64_t bytes, std::uint64_t size) {
  if (bytes == 0 || size == 0) return {.kind = ByteRange::Kind::kOutOfBounds};
  bytes = std::min(bytes, size);
  return {ByteRange::Kind::kPart, size - bytes, bytes};
}

}  // namespace

ByteRange byte_range(std::string_view field, std::uint64_t size) {
  constexpr std::string_view kUnit = "bytes=";
  if (!field.starts_with(kUnit)) return {};
  field.remove_prefix(kUnit.size());
  const auto middle = field.find('-');
  if (middle == field.npos) return {};
  const auto first_text = field.substr(0, middle), last_text = field.substr(middle + 1);
  const auto first = read_digits(first_text), last = read_digits(last_text);
  if (first_text.empty()) return last ? last_bytes(*last, size) : ByteRange{};
  if (!first || (!last_text.empty() && !last)) return {};
  if (last && *last < *first) return {};
  if (*first >= size) return {.kind = ByteRange::Kind::kOutOfBounds};
  const auto end = last ? std::min(*last, size - 1) : size - 1;
  return {ByteRange::Kind::kPart, *first, end - *first + 1};
}

}  // namespace galilean::monitor
