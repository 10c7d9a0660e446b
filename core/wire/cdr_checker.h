// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/wire/cdr.h"
#include "core/wire/robot_name.h"

namespace galilean::msg {

/// Walks through one message in CDR and notes the first field that is outside of its bounds. It
/// neither allocates nor reads past the end. The functions that are generated from the bounds call
/// it, field by field. The texts that they give must live as long as the program.
class CdrChecker {
 public:
  explicit CdrChecker(std::span<const std::uint8_t> bytes) noexcept : from_(bytes) {}

  /// Returns whether all that was read so far is whole and within its bounds.
  [[nodiscard]] bool good() const noexcept { return fault_.empty() && from_.ok(); }
  /// Returns what is wrong with the message; empty: nothing is.
  [[nodiscard]] std::string_view fault() const noexcept {
    if (!fault_.empty() || from_.ok()) return fault_;
    return "it is cut short, or is not in plain CDR";
  }
  /// Returns the first robot's name that the message gives as its own; empty: none.
  [[nodiscard]] std::string_view robot() const noexcept { return robot_; }

  /// Reads a number that must not be outside of `low` and `high`, nor NaN.
  template <class T>
  void within(double low, double high, std::string_view fault) {
    T value{};
    from_.read(value);
    const auto number = static_cast<double>(value);
    require(number >= low && number <= high, fault);
  }
  /// Returns whether the message ends here, as those of earlier releases do before a field that was
  /// appended to them.
  [[nodiscard]] bool ends() { return good() && from_.ends(); }
  /// Leaves out numbers of `size` bytes that may be any.
  void skip(std::size_t count, std::size_t size) { from_.skip(count, size); }
  void text(std::size_t most_bytes, std::string_view fault) {
    std::string_view value;
    from_.read(value);
    require(value.size() <= most_bytes, fault);
  }
  /// Reads the name of the robot that the message is of.
  void own_name(std::string_view fault) {
    std::string_view name;
    from_.read(name);
    require(is_robot_name(name), fault);
    if (robot_.empty()) robot_ = name;
  }
  void robot_name(std::string_view fault) {
    std::string_view name;
    from_.read(name);
    require(is_robot_name(name), fault);
  }
  void robot_name_or_empty(std::string_view fault) {
    std::string_view name;
    from_.read(name);
    require(name.empty() || is_robot_name(name), fault);
  }
  /// Returns how many entries a sequence has; 0 if they are too many, which is a fault.
  [[nodiscard]] std::uint32_t entries(std::uint32_t most, std::string_view fault) {
    std::uint32_t count = 0;
    from_.read(count);
    require(count <= most, fault);
    return good() ? count : 0;
  }

 private:
  /// What is cut short is no other fault.
  void require(bool holds, std::string_view fault) noexcept {
    if (!holds && good()) fault_ = fault;
  }

  CdrReader from_;
  std::string_view fault_;
  std::string_view robot_;
};

}  // namespace galilean::msg
