// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <memory>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/device/frame.h"
#include "core/random.h"
#include "robot/vision/blobs.h"
#include "robot/vision/supercomponent.h"

// Compares the robot's whole vision with what a programmer would write with OpenCV, and with
// CMVision's method (a colour class by table look-up). All find blobs in three colours and in the
// dark.
namespace galilean::robot {
namespace {

constexpr std::size_t kPixels = Frame::kBytes / 3;
constexpr int kColourLevel = 60;
constexpr int kDarkLevel = 45;
constexpr int kMinArea = 12;

/// Returns an office: floor and wall with a sensor's noise, and objects of all colours.
const Frame& office() {
  static const auto frame = [] {
    auto made = std::make_unique<Frame>();
    cv::Mat picture(Frame::kHeight, Frame::kWidth, CV_8UC3, made->rgb.data());
    picture.setTo(cv::Scalar(190, 190, 185));
    cv::rectangle(picture, {0, 93, Frame::kWidth, 93}, {120, 118, 115}, cv::FILLED);
    cv::rectangle(picture, {200, 60, 120, 60}, {40, 60, 170}, cv::FILLED);
    for (int i = 0; i < 6; ++i)
      cv::rectangle(picture, {205 + 18 * i, 60, 4, 60}, {14, 18, 44}, cv::FILLED);
    cv::rectangle(picture, {20, 70, 60, 60}, {18, 18, 20}, cv::FILLED);
    cv::rectangle(picture, {110, 84, 50, 16}, {30, 170, 50}, cv::FILLED);
    cv::rectangle(picture, {112, 100, 46, 14}, {18, 18, 20}, cv::FILLED);
    for (int i = 0; i < 6; ++i)
      cv::rectangle(picture, {15 + 55 * i, 110 + 8 * i, 6 + 2 * i, 12 + 4 * i}, {200, 40, 40},
                    cv::FILLED);
    Random random(1);
    for (auto& byte : made->rgb) byte = cv::saturate_cast<std::uint8_t>(byte + 4 * random.normal());
    return made;
  }();
  return *frame;
}

struct Planes {
  std::vector<std::uint8_t> red = std::vector<std::uint8_t>(kPixels), green = red, blue = red,
                            dark = red;
};

void galilean_vision(benchmark::State& state) {
  const Frame& frame = office();
  Planes planes;
  const auto finder = std::make_unique<BlobFinder>();
  std::size_t blobs = 0;
  for (auto _ : state) {
    split_components(
        frame.rgb, normalising_gain(frame.rgb, Frame::kWidth),
        {planes.red.data(), planes.green.data(), planes.blue.data(), planes.dark.data()});
    blobs = 0;
    for (const auto* plane : {&planes.red, &planes.green, &planes.blue})
      blobs += finder->find(*plane, {kColourLevel, Polarity::kBright}, kMinArea).size();
    blobs += finder->find(planes.dark, {kDarkLevel, Polarity::kDark}, kMinArea).size();
    benchmark::DoNotOptimize(blobs);
  }
  state.counters["blobs"] = static_cast<double>(blobs);
}
BENCHMARK(galilean_vision)->Unit(benchmark::kMicrosecond);

void galilean_split_only(benchmark::State& state) {
  const Frame& frame = office();
  Planes planes;
  for (auto _ : state)
    split_components(
        frame.rgb, normalising_gain(frame.rgb, Frame::kWidth),
        {planes.red.data(), planes.green.data(), planes.blue.data(), planes.dark.data()});
}
BENCHMARK(galilean_split_only)->Unit(benchmark::kMicrosecond);

std::size_t opencv_blobs(const cv::Mat& mask, cv::Mat& labels, cv::Mat& stats, cv::Mat& centroids) {
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids);
  std::size_t blobs = 0;
  for (int i = 1; i < count; ++i) blobs += stats.at<int>(i, cv::CC_STAT_AREA) >= kMinArea;
  return blobs;
}

void opencv_pipeline(benchmark::State& state) {
  cv::setNumThreads(1);
  const cv::Mat picture(Frame::kHeight, Frame::kWidth, CV_8UC3,
                        const_cast<std::uint8_t*>(office().rgb.data()));
  cv::Mat channel[3], rest, super, grey, mask, labels, stats, centroids;
  std::size_t blobs = 0;
  for (auto _ : state) {
    blobs = 0;
    cv::split(picture, channel);
    for (int i = 0; i < 3; ++i) {
      cv::add(channel[(i + 1) % 3], channel[(i + 2) % 3], rest);
      cv::subtract(channel[i], rest, super);
      cv::threshold(super, mask, kColourLevel - 1, 255, cv::THRESH_BINARY);
      blobs += opencv_blobs(mask, labels, stats, centroids);
    }
    cv::cvtColor(picture, grey, cv::COLOR_RGB2GRAY);
    cv::threshold(grey, mask, kDarkLevel - 1, 255, cv::THRESH_BINARY_INV);
    blobs += opencv_blobs(mask, labels, stats, centroids);
    benchmark::DoNotOptimize(blobs);
  }
  state.counters["blobs"] = static_cast<double>(blobs);
}
BENCHMARK(opencv_pipeline)->Unit(benchmark::kMicrosecond);

/// Returns a table from 5 bits a channel to one bit a class, like CMVision's tables.
std::vector<std::uint8_t> class_table() {
  std::vector<std::uint8_t> table(1 << 15);
  for (int i = 0; i < 1 << 15; ++i) {
    const int r = i >> 10 << 3, g = (i >> 5 & 31) << 3, b = (i & 31) << 3;
    const bool dark = (r + 2 * g + b) / 4 < kDarkLevel;
    table[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
        (r - g - b >= kColourLevel ? 1 : 0) | (g - r - b >= kColourLevel ? 2 : 0) |
        (b - r - g >= kColourLevel ? 4 : 0) | (dark ? 8 : 0));
  }
  return table;
}

/// Finds classes by look-up, and then the same runs and unions. It shows what the look-up alone
/// gains.
void lookup_table_pipeline(benchmark::State& state) {
  const Frame& frame = office();
  const auto table = class_table();
  Planes planes;
  const auto finder = std::make_unique<BlobFinder>();
  std::size_t blobs = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPixels; ++i) {
      const auto* rgb = frame.rgb.data() + 3 * i;
      const auto entry =
          table[static_cast<std::size_t>(rgb[0] >> 3 << 10 | rgb[1] >> 3 << 5 | rgb[2] >> 3)];
      planes.red[i] = entry & 1;
      planes.green[i] = entry & 2;
      planes.blue[i] = entry & 4;
      planes.dark[i] = entry & 8;
    }
    blobs = 0;
    for (const auto* plane : {&planes.red, &planes.green, &planes.blue, &planes.dark})
      blobs += finder->find(*plane, {1, Polarity::kBright}, kMinArea).size();
    benchmark::DoNotOptimize(blobs);
  }
  state.counters["blobs"] = static_cast<double>(blobs);
}
BENCHMARK(lookup_table_pipeline)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace galilean::robot
