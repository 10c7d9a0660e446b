// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/chart.h"

#include <algorithm>
#include <cmath>

#include "core/visible_text.h"
#include "monitor/logs/figures/chart_frame.h"
#include "monitor/logs/pictures/drawing.h"

namespace galilean::logs {
namespace {

constexpr std::size_t kLabelWidth = 10;

std::string right(const std::string& text) {
  return std::string(text.size() < kLabelWidth ? kLabelWidth - text.size() : 0, ' ') + text;
}

std::string value_label(double value) {
  return right(fitting_text(value, kLabelWidth));
}

std::size_t row_of(double value, const ChartFrame& frame, std::size_t height) {
  const double from_top = (1 - frame.height_of(value)) * static_cast<double>(height - 1);
  return std::min(static_cast<std::size_t>(std::lround(from_top)), height - 1);
}

void draw(const NamedSeries& each, char letter, const ChartFrame& frame,
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

std::string bar_row(const NamedBars& each, const ChartFrame& frame, std::size_t width) {
  std::string row;
  for (const auto& name : each.bars.columns(frame.from_s, frame.to_s, width))
    row += name ? bar_letter(*name) : ' ';
  return right(label_of(each.name, kLabelWidth)) + " |" +
         row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
}

}  // namespace

std::string chart_text(const std::vector<NamedSeries>& all, std::size_t width, std::size_t height,
                       const std::vector<NamedBars>& bars) {
  const ChartFrame frame(all, bars);
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
    const std::string label = row == 0            ? value_label(frame.values.most)
                              : row + 1 == height ? value_label(frame.values.least)
                                                  : right("");
    text += label + " |" + rows[row].substr(0, rows[row].find_last_not_of(' ') + 1) + '\n';
  }
  for (const auto& each : bars) text += bar_row(each, frame, width);
  const std::string from = short_text(frame.from_s) + " s", to = short_text(frame.to_s) + " s";
  const std::size_t used = from.size() + to.size();
  text += std::string(kLabelWidth + 1, ' ') + '+' + std::string(width, '-') + '\n';
  return text + std::string(kLabelWidth + 2, ' ') + from +
         std::string(width > used ? width - used : 1, ' ') + to + '\n';
}

}  // namespace galilean::logs
