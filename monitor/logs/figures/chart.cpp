// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/chart.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/visible_text.h"

namespace galilean::logs {
namespace {

constexpr std::size_t kLabelWidth = 10;

/// The frame that all series are drawn in.
struct Frame {
  double from_s = 0, to_s = 0;
  ValueRange values;

  explicit Frame(const std::vector<NamedSeries>& all)
      : from_s(all.front().series.first_s()), to_s(all.front().series.last_s()) {
    for (const auto& each : all) {
      from_s = std::min(from_s, each.series.first_s());
      to_s = std::max(to_s, each.series.last_s());
      values.take(each.series.range());
    }
  }
  /// Returns where a value is: 0 at the bottom, 1 on top; in the middle if all are one.
  [[nodiscard]] double height_of(double value) const {
    const double range = values.most - values.least;
    return range > 0 ? (value - values.least) / range : 0.5;
  }
};

std::string short_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", number);
  return text.data();
}

std::string right(const std::string& text) {
  return std::string(text.size() < kLabelWidth ? kLabelWidth - text.size() : 0, ' ') + text;
}

std::size_t row_of(double value, const Frame& frame, std::size_t height) {
  const double from_top = (1 - frame.height_of(value)) * static_cast<double>(height - 1);
  return std::min(static_cast<std::size_t>(from_top + 0.5), height - 1);
}

void draw(const NamedSeries& each, char letter, const Frame& frame,
          std::vector<std::string>& rows) {
  const auto columns = each.series.columns(frame.from_s, frame.to_s, rows.front().size());
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column].empty()) continue;
    const auto top = row_of(columns[column].most, frame, rows.size());
    const auto bottom = row_of(columns[column].least, frame, rows.size());
    for (auto row = top; row <= bottom; ++row) rows[row][column] = letter;
  }
}

char letter_of(std::size_t index, std::size_t count) {
  return count == 1 ? '*' : static_cast<char>('a' + index % 26);
}

constexpr double kPictureWidth = 960, kPictureHeight = 360, kMargin = 60;
constexpr std::array kColours{"#1f77b4", "#d62728", "#2ca02c", "#9467bd",
                              "#ff7f0e", "#17becf", "#8c564b", "#7f7f7f"};

std::string svg_text(double x, double y, const std::string& text, const char* more) {
  std::string safe;
  for (const char letter : visible(text))
    safe += letter == '<' ? "&lt;" : letter == '&' ? "&amp;" : std::string(1, letter);
  return "  <text x=\"" + short_text(x) + "\" y=\"" + short_text(y) + "\" " + more + ">" + safe +
         "</text>\n";
}

std::string svg_line(const NamedSeries& each, const char* colour, const Frame& frame) {
  const double width = kPictureWidth - 2 * kMargin, height = kPictureHeight - 2 * kMargin;
  const auto columns =
      each.series.columns(frame.from_s, frame.to_s, static_cast<std::size_t>(width));
  std::string points;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column].empty()) continue;
    const std::string x = short_text(kMargin + static_cast<double>(column));
    for (const double value : {columns[column].most, columns[column].least})
      points += (points.empty() ? "" : " ") + x + "," +
                short_text(kMargin + (1 - frame.height_of(value)) * height);
  }
  return "  <polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" points=\"" + points +
         "\"/>\n";
}

}  // namespace

std::string chart_text(const std::vector<NamedSeries>& all, std::size_t width, std::size_t height) {
  const Frame frame(all);
  std::vector<std::string> rows(height, std::string(width, ' '));
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char letter = letter_of(i, all.size());
    draw(all[i], letter, frame, rows);
    text += std::string(1, letter) + " " + visible(all[i].name) + ": " +
            short_text(all[i].series.range().least) + " to " +
            short_text(all[i].series.range().most) + '\n';
  }
  for (std::size_t row = 0; row < height; ++row) {
    const std::string label = row == 0            ? short_text(frame.values.most)
                              : row + 1 == height ? short_text(frame.values.least)
                                                  : "";
    text += right(label) + " |" + rows[row].substr(0, rows[row].find_last_not_of(' ') + 1) + '\n';
  }
  const std::string from = short_text(frame.from_s) + " s", to = short_text(frame.to_s) + " s";
  const std::size_t used = from.size() + to.size();
  text += std::string(kLabelWidth + 1, ' ') + '+' + std::string(width, '-') + '\n';
  return text + std::string(kLabelWidth + 2, ' ') + from +
         std::string(width > used ? width - used : 1, ' ') + to + '\n';
}

std::string chart_svg(const std::vector<NamedSeries>& all) {
  const Frame frame(all);
  const double right_x = kPictureWidth - kMargin, bottom_y = kPictureHeight - kMargin;
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 360\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n"
      "  <rect width=\"960\" height=\"360\" fill=\"white\"/>\n"
      "  <path d=\"M60 60 V300 H900\" fill=\"none\" stroke=\"black\"/>\n";
  text += svg_text(kMargin - 6, kMargin + 4, short_text(frame.values.most), "text-anchor=\"end\"");
  text += svg_text(kMargin - 6, bottom_y, short_text(frame.values.least), "text-anchor=\"end\"");
  text += svg_text(kMargin, bottom_y + 20, short_text(frame.from_s) + " s", "");
  text += svg_text(right_x, bottom_y + 20, short_text(frame.to_s) + " s", "text-anchor=\"end\"");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* colour = kColours[i % kColours.size()];
    const std::string fill = "fill=\"" + std::string(colour) + "\"";
    text += svg_line(all[i], colour, frame);
    text += svg_text(kMargin + 200 * static_cast<double>(i % 4),
                     20 + 16 * static_cast<double>(i / 4), all[i].name, fill.c_str());
  }
  return text + "</svg>\n";
}

}  // namespace galilean::logs
