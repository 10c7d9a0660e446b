// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace galilean::logs {

/// Which of some texts was so over time, such as a robot's state, in bounded memory.
class StateBars {
 public:
  static constexpr std::size_t kMostRuns = 65'536;
  static constexpr std::size_t kMostNames = 25;
  /// Stands for all texts beyond the first kMostNames.
  static constexpr const char* kOthers = "others";

  /// Requires: times do not fall.
  void add(double at_s, const std::string& text);

  [[nodiscard]] bool empty() const noexcept { return runs_.empty(); }
  [[nodiscard]] double first_s() const noexcept { return runs_.front().at_s; }
  [[nodiscard]] double last_s() const noexcept { return last_s_; }
  /// Returns the texts in the order in which they came first.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// Returns for each of so many columns from one time to another the index in `names` of what was
  /// so at its end; nothing before the first text and behind the last.
  [[nodiscard]] std::vector<std::optional<std::size_t>> columns(double from_s, double to_s,
                                                                std::size_t count) const;

 private:
  struct Run {
    double at_s = 0;
    std::size_t name = 0;
  };
  std::size_t index_of(const std::string& text);
  void halve();

  std::vector<Run> runs_;
  std::vector<std::string> names_;
  double last_s_ = 0;
};

}  // namespace galilean::logs
