// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace galilean::logs {

// A picture as shapes, in pixels from its upper left corner. Colours are written "#1f77b4".

struct DrawnPoint {
  double x = 0, y = 0;
  bool operator==(const DrawnPoint&) const = default;
};
/// A line through points.
struct Stroke {
  std::vector<DrawnPoint> points;
  std::string colour;
  double width = 1;
};
/// A filled rectangle.
struct Patch {
  double x = 0, y = 0, width = 0, height = 0;
  std::string colour;
};
/// A text on one line, whose baseline begins at the point, or ends there.
struct Label {
  double x = 0, y = 0;
  std::string text;
  std::string colour = "#000000";
  double size = 12;  ///< of its letters
  bool ends_there = false;
};

/// Later shapes lie over earlier ones, on white.
struct Drawing {
  double width = 0, height = 0;
  std::vector<std::variant<Stroke, Patch, Label>> shapes;
};

/// Colours that are told apart side by side.
inline constexpr std::array kColours{"#1f77b4", "#d62728", "#2ca02c", "#9467bd",
                                     "#ff7f0e", "#17becf", "#8c564b", "#7f7f7f"};

/// Returns a number as pictures show it, with five digits.
[[nodiscard]] std::string short_text(double number);
/// Returns the drawing as an SVG picture.
[[nodiscard]] std::string svg_of(const Drawing& drawing);

}  // namespace galilean::logs
