// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/number_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <limits>

#include "core/private_file.h"

namespace galilean {
namespace {

/// All numbers have as many digits, so that a new one covers the old one in one write.
constexpr std::size_t kDigits = 20;
/// What is higher is none of the nanoseconds of a clock, but a damaged file.
constexpr std::uint64_t kHighest = std::numeric_limits<std::int64_t>::max();

}  // namespace

NumberFile::NumberFile(const std::filesystem::path& file) {
  if (const auto opened = open_private_file(file, O_RDWR)) descriptor_ = opened.value();
}

NumberFile::~NumberFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::uint64_t NumberFile::take(std::uint64_t least) noexcept {
  if (descriptor_ < 0) return least;
  const std::lock_guard lock(mutex_);
  // Another process may hang while it has the lock. An order does not wait for that.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) return least;
  const std::uint64_t number = std::max(least, known() + 1);
  keep(number);
  flock(descriptor_, LOCK_UN);
  return number;
}

/// Returns 0 if the file is new or damaged.
std::uint64_t NumberFile::known() const noexcept {
  std::array<char, kDigits> digits{};
  if (pread(descriptor_, digits.data(), digits.size(), 0) != static_cast<ssize_t>(kDigits))
    return 0;
  const char* end = digits.data() + digits.size();
  std::uint64_t number = 0;
  const auto [rest, wrong] = std::from_chars(digits.data(), end, number);
  return wrong == std::errc() && rest == end && number < kHighest ? number : 0;
}

void NumberFile::keep(std::uint64_t number) const noexcept {
  std::array<char, kDigits + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%020" PRIu64, number);
  // A full disk does not keep the operator from steering: the clock counts until there is room.
  [[maybe_unused]] const auto written = pwrite(descriptor_, digits.data(), kDigits, 0);
}

std::filesystem::path number_file(const std::filesystem::path& key_file) {
  return key_file.string() + ".number";
}

}  // namespace galilean
