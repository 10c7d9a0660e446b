// SPDX-License-Identifier: BSD-3-Clause
// The module that draws pictures with OpenCV, and is loaded when a PNG is asked for.
#include "monitor/logs/pictures/png_module.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace {

using namespace galilean::logs;

constexpr double kLargest = 20'000;  // pixels
/// Points are given in sixteenths of a pixel.
constexpr int kFractionBits = 4;
/// Letters of OpenCV's font are so high at scale 1.
constexpr double kFontHeight = 30;

/// Returns the colour that "#1f77b4" names.
cv::Scalar colour_of(const std::string& text) {
  unsigned red = 0, green = 0, blue = 0;
  std::sscanf(text.c_str(), "#%2x%2x%2x", &red, &green, &blue);
  return {static_cast<double>(blue), static_cast<double>(green), static_cast<double>(red)};
}

int fixed(double pixels) {
  return static_cast<int>(std::lround(pixels * (1 << kFractionBits)));
}
cv::Point fixed_point(double x, double y) {
  return {fixed(x), fixed(y)};
}

void draw(cv::Mat& picture, const Stroke& stroke) {
  std::vector<cv::Point> points;
  for (const auto& point : stroke.points) points.push_back(fixed_point(point.x, point.y));
  if (points.empty()) return;
  cv::polylines(picture, points, false, colour_of(stroke.colour),
                std::max(1, static_cast<int>(std::lround(stroke.width))), cv::LINE_AA,
                kFractionBits);
}

void draw(cv::Mat& picture, const Patch& patch) {
  const cv::Rect whole(0, 0, picture.cols, picture.rows);
  const cv::Point from(static_cast<int>(std::lround(patch.x)),
                       static_cast<int>(std::lround(patch.y)));
  const cv::Point to(static_cast<int>(std::lround(patch.x + patch.width)),
                     static_cast<int>(std::lround(patch.y + patch.height)));
  const cv::Rect part = cv::Rect(from, to) & whole;
  if (part.area() > 0) picture(part).setTo(colour_of(patch.colour));
}

/// OpenCV's font has ASCII alone.
std::string ascii(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0x80 && byte < 0xC0) continue;  // the rest of a letter
    safe += byte < 0x20 || byte >= 0x7F ? '?' : letter;
  }
  return safe;
}

void draw(cv::Mat& picture, const Label& label) {
  const std::string text = ascii(label.text);
  const double scale = label.size / kFontHeight;
  int below = 0;
  const auto size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &below);
  const double x = label.ends_there ? label.x - size.width : label.x;
  cv::putText(picture, text,
              {static_cast<int>(std::lround(x)), static_cast<int>(std::lround(label.y))},
              cv::FONT_HERSHEY_SIMPLEX, scale, colour_of(label.colour), 1, cv::LINE_AA);
}

}  // namespace

extern "C" bool galilean_draw_png(const Drawing& drawing, std::string& png) try {
  const bool fits = drawing.width >= 1 && drawing.width <= kLargest && drawing.height >= 1 &&
                    drawing.height <= kLargest;
  if (!fits) return false;
  cv::Mat picture(static_cast<int>(drawing.height), static_cast<int>(drawing.width), CV_8UC3,
                  cv::Scalar(255, 255, 255));
  for (const auto& shape : drawing.shapes)
    std::visit([&](const auto& each) { draw(picture, each); }, shape);
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes)) return false;
  png.assign(bytes.begin(), bytes.end());
  return true;
} catch (const std::exception&) {
  return false;
}
