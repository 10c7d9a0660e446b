// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>

#include "core/orders/order_memory.h"
#include "core/result.h"
#include "core/worker.h"

namespace galilean::robot {

/// Returns the file in which the robot of this name in this DDS domain keeps its OrderNumbers.
[[nodiscard]] std::filesystem::path order_numbers_file(const std::filesystem::path& state_folder,
                                                       const std::string& robot,
                                                       std::uint32_t domain);

/// Returns no numbers if there is no such file. Errors: it cannot be read, or it is cut short or
/// not what a robot wrote. The message is one sentence that names the file.
[[nodiscard]] Result<OrderNumbers> read_order_numbers(const std::filesystem::path& file);
/// Puts the file in place whole or not at all, and makes its folder. It waits for the disk.
/// Errors: that failed. The message is one sentence that names the file.
[[nodiscard]] Result<void> write_order_numbers(const std::filesystem::path& file,
                                               const OrderNumbers& numbers);

/// Keeps on disk how far the orders of trusted keys have come, for the robot program's next start.
/// It writes in a thread of its own, because an order must not wait for a disk.
class OrderKeeper {
 public:
  /// Gets what is wrong and what that means, or an empty text when it is well again.
  using Tell = std::function<void(const std::string& problem)>;

  explicit OrderKeeper(std::filesystem::path file) : file_(std::move(file)) {}

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  /// Any thread but control. Only the newest numbers count.
  void keep(const OrderNumbers& numbers);
  /// Returns a thread that writes what `keep` is given. Requires: this outlives it.
  [[nodiscard]] Worker writer(const Tell& tell);
  /// Writes at once what is not written yet. Returns what a Tell gets. Requires: the writer has
  /// ended.
  [[nodiscard]] std::string end();

 private:
  void write_newest(const std::stop_token& stop, const Tell& tell);
  [[nodiscard]] std::string write(const OrderNumbers& numbers) const;

  const std::filesystem::path file_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  OrderNumbers newest_;
  bool changed_ = false;
};

}  // namespace galilean::robot
