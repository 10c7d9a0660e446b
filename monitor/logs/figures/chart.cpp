// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/chart.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "core/visible_text.h"

namespace galilean::logs {
namespace {

constexpr std::size_t kLabelWidth = 10;

/// The frame that all is drawn in.
struct Frame {
  double from_s = std::numeric_limits<double>::infinity(), to_s = -from_s;
  ValueRange values;

  Frame(const std::vector<NamedSeries>& all, const std::vector<NamedBars>& bars) {
    for (const auto& each : all) {
      include(each.series.first_s(), each.series.last_s());
      values.take(each.series.range());
    }
    for (const auto& each : bars) include(each.bars.first_s(), each.bars.last_s());
  }
  void include(double first_s, double last_s) {
    from_s = std::min(from_s, first_s);
    to_s = std::max(to_s, last_s);
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

char bar_letter(std::size_t name) {
  return static_cast<char>('A' + name);  // of at most 26
}

std::string legend_of(const NamedBars& each) {
  std::string text = visible(each.name) + ":";
  for (std::size_t i = 0; i < each.bars.names().size(); ++i)
    text +=
        (i == 0 ? " " : ", ") + std::string(1, bar_letter(i)) + ' ' + visible(each.bars.names()[i]);
  return text + '\n';
}

/// Returns the last part of a name, as much of it as a label has room for.
std::string label_of(const NamedBars& each) {
  const std::string name = visible(each.name.substr(each.name.rfind('.') + 1));
  return name.substr(0, kLabelWidth);
}

std::string bar_row(const NamedBars& each, const Frame& frame, std::size_t width) {
  std::string row;
  for (const auto& name : each.bars.columns(frame.from_s, frame.to_s, width))
    row += name ? bar_letter(*name) : ' ';
  return right(label_of(each)) + " |" + row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
}

constexpr double kPictureWidth = 960, kPictureHeight = 360, kMargin = 60;
constexpr double kBarHeight = 16, kBarDistance = 44;  // a bar and its legend
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

/// Returns the bar of texts whose top is at `top_y`, with its legend below.
std::string svg_bar(const NamedBars& each, double top_y, const Frame& frame) {
  const auto width = static_cast<std::size_t>(kPictureWidth - 2 * kMargin);
  const auto columns = each.bars.columns(frame.from_s, frame.to_s, width);
  std::string text = svg_text(kMargin - 6, top_y + 12, label_of(each), "text-anchor=\"end\"");
  for (std::size_t begin = 0, end = 0; begin < width; begin = end) {
    while (end < width && columns[end] == columns[begin]) ++end;
    if (!columns[begin]) continue;
    text += "  <rect x=\"" + short_text(kMargin + static_cast<double>(begin)) + "\" y=\"" +
            short_text(top_y) + "\" width=\"" + short_text(static_cast<double>(end - begin)) +
            "\" height=\"" + short_text(kBarHeight) + "\" fill=\"" +
            kColours[*columns[begin] % kColours.size()] + "\"/>\n";
  }
  double x = kMargin;
  for (std::size_t i = 0; i < each.bars.names().size(); ++i) {
    const std::string fill =
        "fill=\"" + std::string(kColours[i % kColours.size()]) + "\" font-size=\"10\"";
    text += svg_text(x, top_y + kBarHeight + 12, each.bars.names()[i], fill.c_str());
    x += 12 + 6 * static_cast<double>(each.bars.names()[i].size());
  }
  return text;
}

}  // namespace

std::string chart_text(const std::vector<NamedSeries>& all, std::size_t width, std::size_t height,
                       const std::vector<NamedBars>& bars) {
  const Frame frame(all, bars);
  if (all.empty()) height = 0;
  std::vector<std::string> rows(height, std::string(width, ' '));
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char letter = letter_of(i, all.size());
    draw(all[i], letter, frame, rows);
    text += std::string(1, letter) + " " + visible(all[i].name) + ": " +
            short_text(all[i].series.range().least) + " to " +
            short_text(all[i].series.range().most) + '\n';
  }
  for (const auto& each : bars) text += legend_of(each);
  for (std::size_t row = 0; row < height; ++row) {
    const std::string label = row == 0            ? short_text(frame.values.most)
                              : row + 1 == height ? short_text(frame.values.least)
                                                  : "";
    text += right(label) + " |" + rows[row].substr(0, rows[row].find_last_not_of(' ') + 1) + '\n';
  }
  for (const auto& each : bars) text += bar_row(each, frame, width);
  const std::string from = short_text(frame.from_s) + " s", to = short_text(frame.to_s) + " s";
  const std::size_t used = from.size() + to.size();
  text += std::string(kLabelWidth + 1, ' ') + '+' + std::string(width, '-') + '\n';
  return text + std::string(kLabelWidth + 2, ' ') + from +
         std::string(width > used ? width - used : 1, ' ') + to + '\n';
}

std::string chart_svg(const std::vector<NamedSeries>& all, const std::vector<NamedBars>& bars) {
  const Frame frame(all, bars);
  const std::string height =
      short_text(kPictureHeight + kBarDistance * static_cast<double>(bars.size()));
  const double right_x = kPictureWidth - kMargin, bottom_y = kPictureHeight - kMargin;
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 " + height +
                     "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                     "  <rect width=\"960\" height=\"" +
                     height +
                     "\" fill=\"white\"/>\n"
                     "  <path d=\"M60 60 V300 H900\" fill=\"none\" stroke=\"black\"/>\n";
  if (!all.empty()) {
    text +=
        svg_text(kMargin - 6, kMargin + 4, short_text(frame.values.most), "text-anchor=\"end\"");
    text += svg_text(kMargin - 6, bottom_y, short_text(frame.values.least), "text-anchor=\"end\"");
  }
  text += svg_text(kMargin, bottom_y + 20, short_text(frame.from_s) + " s", "");
  text += svg_text(right_x, bottom_y + 20, short_text(frame.to_s) + " s", "text-anchor=\"end\"");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* colour = kColours[i % kColours.size()];
    const std::string fill = "fill=\"" + std::string(colour) + "\"";
    text += svg_line(all[i], colour, frame);
    text += svg_text(kMargin + 200 * static_cast<double>(i % 4),
                     20 + 16 * static_cast<double>(i / 4), all[i].name, fill.c_str());
  }
  for (std::size_t i = 0; i < bars.size(); ++i)
    text += svg_bar(bars[i], bottom_y + 36 + kBarDistance * static_cast<double>(i), frame);
  return text + "</svg>\n";
}

}  // namespace galilean::logs
