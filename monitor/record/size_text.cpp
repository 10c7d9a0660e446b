// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/size_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

struct SizeUnit {
  std::string_view name;
  double bytes;
};
constexpr SizeUnit kSizeUnits[] = {
    {"", 1},    {"b", 1},    {"k", 1e3},    {"kb", 1e3},      {"m", 1e6},       {"mb", 1e6},
    {"g", 1e9}, {"gb", 1e9}, {"kib", 1024}, {"mib", 1 << 20}, {"gib", 1 << 30},
};
/// More than any disk holds.
constexpr double kLargest_bytes = 1e18;

}  // namespace

Result<std::uint64_t> bytes_of(std::string_view text) {
  const Error refused{"'" + visible(std::string(text)) +
                      "' is no size: write a number and a unit, such as 500MB or 2GB"};
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || !(number >= 0)) return refused;
  std::string unit(end, text.data() + text.size());
  std::erase(unit, ' ');
  std::ranges::transform(unit, unit.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  const auto known = std::ranges::find(kSizeUnits, unit, &SizeUnit::name);
  if (known == std::end(kSizeUnits) || number * known->bytes > kLargest_bytes) return refused;
  return static_cast<std::uint64_t>(number * known->bytes);
}

std::string size_text(std::uint64_t bytes) {
  if (bytes < 1000) return plural(bytes, "byte");
  if (bytes < 1'000'000) return std::to_string(bytes / 1000) + " kB";
  return std::to_string(bytes / 1'000'000) + " MB";
}

}  // namespace galilean::monitor
