// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/pictures/drawing.h"

#include <cstdio>

#include "core/visible_text.h"

namespace galilean::logs {
namespace {

std::string attribute(const char* name, const std::string& value) {
  return " " + std::string(name) + "=\"" + value + "\"";
}
std::string attribute(const char* name, double value) {
  return attribute(name, short_text(value));
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : visible(text))
    safe += letter == '<' ? "&lt;" : letter == '&' ? "&amp;" : std::string(1, letter);
  return safe;
}

std::string element(const Stroke& stroke) {
  std::string points;
  for (const auto& point : stroke.points)
    points += (points.empty() ? "" : " ") + short_text(point.x) + "," + short_text(point.y);
  return "  <polyline fill=\"none\"" + attribute("stroke", stroke.colour) +
         attribute("stroke-width", stroke.width) + attribute("points", points) + "/>\n";
}

std::string element(const Patch& patch) {
  return "  <rect" + attribute("x", patch.x) + attribute("y", patch.y) +
         attribute("width", patch.width) + attribute("height", patch.height) +
         attribute("fill", patch.colour) + "/>\n";
}

std::string element(const Label& label) {
  return "  <text" + attribute("x", label.x) + attribute("y", label.y) +
         attribute("fill", label.colour) + attribute("font-size", label.size) +
         (label.ends_there ? attribute("text-anchor", "end") : "") + ">" + escaped(label.text) +
         "</text>\n";
}

}  // namespace

std::string short_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", number);
  return text.data();
}

std::string svg_of(const Drawing& drawing) {
  const std::string size = short_text(drawing.width) + " " + short_text(drawing.height);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size +
                     "\" font-family=\"sans-serif\">\n" +
                     element(Patch{0, 0, drawing.width, drawing.height, "#ffffff"});
  for (const auto& shape : drawing.shapes)
    text += std::visit([](const auto& each) { return element(each); }, shape);
  return text + "</svg>\n";
}

}  // namespace galilean::logs
