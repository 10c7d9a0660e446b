// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "bhdl/graph/graph.h"
#include "bhdl/graph/layout.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr double kLoop = 42;  ///< how far an arrow within a column bulges [px]

// A picture on its own brings its canvas and colours. Within a page it takes the page's.
constexpr std::string_view kStyle =
    "<style>\n"
    "  svg:root { color: #1c2128; color-scheme: light dark; }\n"
    "  @media (prefers-color-scheme: dark) { svg:root { color: #dbe2ea; } }\n"
    "  .bhdl text { fill: currentColor; font: 12px ui-monospace, monospace; }\n"
    "  .bhdl .name { font-weight: bold; }\n"
    "  .bhdl .box { fill: currentColor; fill-opacity: .06; stroke: currentColor; }\n"
    "  .bhdl .start .box { stroke-width: 2.5; }\n"
    "  .bhdl .arrow { fill: none; stroke: currentColor; stroke-opacity: .55; }\n"
    "  .bhdl .arrow:hover { stroke-opacity: 1; stroke-width: 2.5; }\n"
    "  .bhdl .head { fill: currentColor; }\n"
    "</style>\n"
    "<defs><marker id=\"bhdl-head\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"8\" "
    "markerHeight=\"8\" orient=\"auto\"><path class=\"head\" d=\"M0 0L8 4L0 "
    "8z\"/></marker></defs>\n";

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

// Rounding to a tenth of a pixel loses nothing that can be seen, and keeps the text the same.
std::string pixels(double value) {
  return number_text(std::round(value * 10) / 10);
}

std::string attribute(std::string_view name, double value) {
  return ' ' + std::string(name) + "=\"" + pixels(value) + '"';
}

std::string names(std::string_view what, const std::vector<std::string>& list) {
  std::string text(what);
  for (const auto& each : list) text += ' ' + each;
  return text;
}

std::string svg_text(double x, double y, std::string_view text, std::string_view more = {}) {
  return "<text" + attribute("x", x) + attribute("y", y) + std::string(more) + '>' +
         xml_text(text) + "</text>\n";
}

double row_y(const Box& box, std::size_t way) {
  return box.y + GraphLayout::kTitleHeight + GraphLayout::kRowHeight * (double(way) + 0.5);
}

std::string svg_box(const Box& box, bool is_start) {
  const double left = box.x + 10;
  std::string text = is_start ? "<g class=\"start\">" : "<g>";
  text += "<title>" +
          xml_text(names("perceptual_schemas:", box.state->perceptual_schemas) + '\n' +
                   names("motor_schemas:", box.state->motor_schemas)) +
          "</title>\n<rect class=\"box\" rx=\"5\"" + attribute("x", box.x) + attribute("y", box.y) +
          attribute("width", box.width) + attribute("height", box.height) + "/>\n" +
          svg_text(left, box.y + 17, box.state->name, " class=\"name\"");
  for (std::size_t way = 0; way < box.ways.size(); ++way)
    text += svg_text(left, row_y(box, way) + 4, box.ways[way].cause);
  return text + "</g>\n";
}

struct Point {
  double x = 0;
  double y = 0;
};

std::string point(const Point& at) {
  return pixels(at.x) + ' ' + pixels(at.y);
}

std::string curve(const Point& from, const Point& to) {
  const double middle = (from.x + to.x) / 2;
  return "C" + point({middle, from.y}) + ' ' + point({middle, to.y}) + ' ' + point(to);
}

std::string path_within_column(const Box& from, const Box& to, double y) {
  const Point start{from.x + from.width, y};
  const Point end{to.x + to.width, to.y + GraphLayout::kTitleHeight / 2};
  const double bulge = std::max(start.x, end.x) + kLoop;
  return "M" + point(start) + "C" + point({bulge, start.y}) + ' ' + point({bulge, end.y}) + ' ' +
         point(end);
}

std::string path(const Box& from, const Box& to, const Arrow& arrow) {
  const double y = row_y(from, arrow.way);
  if (from.column == to.column) return path_within_column(from, to, y);
  const bool rightwards = from.column < to.column;
  Point at{from.x + (rightwards ? from.width : 0), y};
  std::string text = "M" + point(at);
  for (const auto& passage : arrow.passages) {
    text += curve(at, {passage.x + (rightwards ? 0 : passage.width), passage.y});
    at = {passage.x + (rightwards ? passage.width : 0), passage.y};
    text += "L" + point(at);
  }
  return text +
         curve(at, {to.x + (rightwards ? 0 : to.width), to.y + GraphLayout::kTitleHeight / 2});
}

std::string svg_arrow(const GraphLayout& layout, const Arrow& arrow) {
  const Box& from = layout.boxes[arrow.from];
  const Box& to = layout.boxes[arrow.to];
  return "<path class=\"arrow\" marker-end=\"url(#bhdl-head)\" d=\"" + path(from, to, arrow) +
         "\"><title>" +
         xml_text(from.state->name + ": " + from.ways[arrow.way].cause + " → " + to.state->name) +
         "</title></path>\n";
}

}  // namespace

std::string to_svg(const Program& program) {
  const GraphLayout layout = lay_out_graph(program);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"bhdl\"" +
                     attribute("width", layout.width) + attribute("height", layout.height) +
                     " viewBox=\"0 0 " + pixels(layout.width) + ' ' + pixels(layout.height) +
                     "\">\n<title>" + xml_text(program.name) + "</title>\n" + std::string(kStyle);
  for (const auto& arrow : layout.arrows) text += svg_arrow(layout, arrow);
  for (const auto& box : layout.boxes) text += svg_box(box, box.state->name == program.start_state);
  return text + "</svg>\n";
}

}  // namespace galilean::bhdl
