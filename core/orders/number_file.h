// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>

namespace galilean {

/// The highest number of an order that was signed with a key on this machine, in a file that all
/// processes with that key share. So the numbers rise also where a process is started again after
/// somebody has set the clock back. It never waits for another process, and where the file cannot
/// be used, the clock alone counts.
class NumberFile {
 public:
  /// Makes the file if it is not there, for its owner alone (mode 0600).
  explicit NumberFile(const std::filesystem::path& file);
  /// Takes no file: `take` returns what it is given.
  NumberFile() = default;
  ~NumberFile();
  NumberFile(const NumberFile&) = delete;
  NumberFile& operator=(const NumberFile&) = delete;

  /// Returns the lowest number that is at least `least` and above all that the file knows, and has
  /// the file know it. Any thread may call it.
  [[nodiscard]] std::uint64_t take(std::uint64_t least) noexcept;

 private:
  [[nodiscard]] std::uint64_t known() const noexcept;
  void keep(std::uint64_t number) const noexcept;

  int descriptor_ = -1;
  std::mutex mutex_;
};

/// Returns the file of the numbers: that of the key with ".number" behind it.
[[nodiscard]] std::filesystem::path number_file(const std::filesystem::path& key_file);

}  // namespace galilean
