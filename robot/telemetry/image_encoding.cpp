// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/image_encoding.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/device/frame.h"

namespace galilean::robot {
namespace {

constexpr int kQuality = 80;
/// The fastest level, because a picture is of use for a tenth of a second only.
constexpr int kCompression = 1;

}  // namespace

void encode_jpeg(std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& to) {
  cv::Mat bgr(Frame::kHeight, Frame::kWidth, CV_8UC3);
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    bgr.data[i] = rgb[i + 2];
    bgr.data[i + 1] = rgb[i + 1];
    bgr.data[i + 2] = rgb[i];
  }
  cv::imencode(".jpg", bgr, to, {cv::IMWRITE_JPEG_QUALITY, kQuality});
}

void encode_png(std::span<const std::uint8_t> gray, std::vector<std::uint8_t>& to) {
  const cv::Mat picture(Frame::kHeight, Frame::kWidth, CV_8UC1,
                        const_cast<std::uint8_t*>(gray.data()));
  cv::imencode(".png", picture, to, {cv::IMWRITE_PNG_COMPRESSION, kCompression});
}

}  // namespace galilean::robot
