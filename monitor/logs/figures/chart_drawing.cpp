// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>

#include "monitor/logs/figures/chart.h"
#include "monitor/logs/figures/chart_frame.h"

namespace galilean::logs {
namespace {

constexpr double kPictureWidth = 960, kPictureHeight = 360, kMargin = 60;
constexpr double kBarHeight = 16, kBarDistance = 44;  // a bar and its legend
constexpr std::size_t kBarLabelLetters = 10;
constexpr double kLegendWidth = 200, kLetters = 12, kSmallLetters = 10, kSmallLetterWidth = 6;
/// What stands left of the axis, in kLetters.
constexpr std::size_t kValueLetters = 8;

Stroke curve_of(const NamedSeries& each, const char* colour, const ChartFrame& frame) {
  const double width = kPictureWidth - 2 * kMargin, height = kPictureHeight - 2 * kMargin;
  const auto columns =
      each.series.columns(frame.from_s, frame.to_s, static_cast<std::size_t>(width));
  Stroke stroke{{}, colour};
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column].empty()) continue;
    for (const double value : {columns[column].most, columns[column].least})
      stroke.points.push_back(
          {kMargin + static_cast<double>(column), kMargin + (1 - frame.height_of(value)) * height});
  }
  return stroke;
}

/// Draws the bar of texts whose top is at `top_y`, with its legend below.
void draw_bar(const NamedBars& each, double top_y, const ChartFrame& frame, Drawing& to) {
  const auto width = static_cast<std::size_t>(kPictureWidth - 2 * kMargin);
  const auto columns = each.bars.columns(frame.from_s, frame.to_s, width);
  to.shapes.push_back(Label{.x = kMargin - 6,
                            .y = top_y + 12,
                            .text = label_of(each.name, kBarLabelLetters),
                            .ends_there = true});
  for (std::size_t begin = 0, end = 0; begin < width; begin = end) {
    while (end < width && columns[end] == columns[begin]) ++end;
    if (!columns[begin]) continue;
    to.shapes.push_back(Patch{kMargin + static_cast<double>(begin), top_y,
                              static_cast<double>(end - begin), kBarHeight,
                              kColours[*columns[begin] % kColours.size()]});
  }
  double x = kMargin;
  for (std::size_t i = 0; i < each.bars.names().size(); ++i) {
    to.shapes.push_back(Label{.x = x,
                              .y = top_y + kBarHeight + 12,
                              .text = each.bars.names()[i],
                              .colour = kColours[i % kColours.size()],
                              .size = kSmallLetters});
    x += 12 + kSmallLetterWidth * static_cast<double>(each.bars.names()[i].size());
  }
}

void draw_axes(const ChartFrame& frame, bool has_values, Drawing& to) {
  const double right_x = kPictureWidth - kMargin, bottom_y = kPictureHeight - kMargin;
  to.shapes.push_back(
      Stroke{{{kMargin, kMargin}, {kMargin, bottom_y}, {right_x, bottom_y}}, "#000000"});
  const auto add = [&](double x, double y, const std::string& text, bool ends_there) {
    to.shapes.push_back(Label{.x = x, .y = y, .text = text, .ends_there = ends_there});
  };
  const auto add_value = [&](double y, double value) {
    const auto text = fitting_text(value, kValueLetters);
    to.shapes.push_back(Label{.x = kMargin - 6,
                              .y = y,
                              .text = text,
                              .size = text.size() > kValueLetters ? kSmallLetters : kLetters,
                              .ends_there = true});
  };
  if (has_values) {
    add_value(kMargin + 4, frame.values.most);
    add_value(bottom_y, frame.values.least);
  }
  add(kMargin, bottom_y + 20, short_text(frame.from_s) + " s", false);
  add(right_x, bottom_y + 20, short_text(frame.to_s) + " s", true);
}

}  // namespace

Drawing chart_drawing(const std::vector<NamedSeries>& all, const std::vector<NamedBars>& bars) {
  const ChartFrame frame(all, bars);
  Drawing drawing{
      kPictureWidth, kPictureHeight + kBarDistance * static_cast<double>(bars.size()), {}};
  draw_axes(frame, !all.empty(), drawing);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* colour = kColours[i % kColours.size()];
    const std::size_t row = i / 4;
    drawing.shapes.push_back(curve_of(all[i], colour, frame));
    drawing.shapes.push_back(Label{.x = kMargin + kLegendWidth * static_cast<double>(i % 4),
                                   .y = 20 + 16 * static_cast<double>(row),
                                   .text = all[i].name,
                                   .colour = colour});
  }
  for (std::size_t i = 0; i < bars.size(); ++i)
    draw_bar(bars[i], kPictureHeight - kMargin + 36 + kBarDistance * static_cast<double>(i), frame,
             drawing);
  return drawing;
}

}  // namespace galilean::logs
