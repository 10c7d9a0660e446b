// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/order_keeper.h"

#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/private_file.h"
#include "core/regular_file.h"

namespace galilean::robot {
namespace {

constexpr std::string_view kFirstLine = "galilean orders, version 1";
constexpr std::string_view kLastLine = "end";
constexpr std::uintmax_t kMostOrderBytes = 1 << 20;

/// Reads "KEY_ID NUMBER". Returns false if the line has another form.
bool read_number(const std::string& line, OrderNumbers& numbers) {
  const auto space = line.find(' ');
  if (space == 0 || space == line.npos) return false;
  const char* end = line.data() + line.size();
  std::uint64_t number = 0;
  const auto [rest, wrong] = std::from_chars(line.data() + space + 1, end, number);
  if (wrong != std::errc() || rest != end) return false;
  numbers[line.substr(0, space)] = number;
  return true;
}

/// Returns nothing if the text is cut short or of another kind.
std::optional<OrderNumbers> numbers_in(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != kFirstLine) return {};
  OrderNumbers numbers;
  while (std::getline(lines, line)) {
    if (line == kLastLine) return numbers;
    if (!read_number(line, numbers)) return {};
  }
  return {};
}

}  // namespace

std::filesystem::path order_numbers_file(const std::filesystem::path& state_folder,
                                         const std::string& robot, std::uint32_t domain) {
  return state_folder / "robots" / ("domain_" + std::to_string(domain)) / (robot + ".orders");
}

Result<OrderNumbers> read_order_numbers(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::symlink_status(file, unknown).type() ==
      std::filesystem::file_type::not_found)
    return OrderNumbers();
  const auto text = read_regular_file(file.string(), kMostOrderBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  auto numbers = numbers_in(text.value());
  if (!numbers) return Error{file.string() + " is cut short or not what a robot wrote"};
  return std::move(*numbers);
}

Result<void> write_order_numbers(const std::filesystem::path& file, const OrderNumbers& numbers) {
  if (auto made = make_private_folder(file.parent_path()); !made) return made;
  std::string text(kFirstLine);
  for (const auto& [key_id, number] : numbers) text += "\n" + key_id + " " + std::to_string(number);
  return replace_private_file(file, text + "\n" + std::string(kLastLine) + "\n");
}

void OrderKeeper::keep(const OrderNumbers& numbers) {
  const std::lock_guard lock(mutex_);
  newest_ = numbers;
  changed_ = true;
  wake_.notify_one();
}

Worker OrderKeeper::writer(const Tell& tell) {
  return {[this, tell](const std::stop_token& stop) { write_newest(stop, tell); },
          [tell](const std::string& failure) {
            if (!failure.empty()) tell("Orders cannot be remembered (" + failure + ").");
          }};
}

void OrderKeeper::write_newest(const std::stop_token& stop, const Tell& tell) {
  OrderNumbers numbers;
  {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, stop, [this] { return std::exchange(changed_, false); })) return;
    numbers = newest_;
  }
  tell(write(numbers));
}

std::string OrderKeeper::end() {
  const std::lock_guard lock(mutex_);
  return std::exchange(changed_, false) ? write(newest_) : "";
}

std::string OrderKeeper::write(const OrderNumbers& numbers) const {
  const auto written = write_order_numbers(file_, numbers);
  if (written) return "";
  return written.error().message +
         "; so after a restart, and if the clock is set back, orders of today could be sent again: "
         "check the disk.";
}

}  // namespace galilean::robot
