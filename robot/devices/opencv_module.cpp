// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/opencv_module.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <system_error>
#include <utility>

namespace galilean::robot {
namespace {

constexpr Duration kOpenAgain = std::chrono::seconds(1);
/// A still picture is repeated at this rate, as a camera would deliver it.
constexpr double kStillRate_hz = 10;
constexpr double kSlowest_hz = 0.5;

bool is_picture(const std::string& device) {
  constexpr std::array endings{".png", ".jpg", ".jpeg", ".bmp", ".ppm", ".tif", ".tiff", ".webp"};
  std::string ending = std::filesystem::path(device).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(endings, ending) != endings.end();
}

bool is_camera(const std::string& device) {
  return device.starts_with("/dev/");
}

std::string advice(const std::error_code& error) {
  return error == std::errc::permission_denied
             ? "give this user access to its folder"
             : "name another one in frame_grabber, or with --camera";
}

/// Returns the part of a picture that has the shape of the paper's: 4:3, whose rows are squeezed
/// later. The camera's geometry depends on that shape. Of a wider picture the middle is taken. A
/// picture that already has the final size is taken whole.
cv::Mat paper_shape(const cv::Mat& picture) {
  const int width = picture.rows * 4 / 3;
  if (picture.size() == cv::Size(Frame::kWidth, Frame::kHeight) || picture.cols <= width)
    return picture;
  return picture(cv::Rect((picture.cols - width) / 2, 0, width, picture.rows));
}

void convert(const cv::Mat& bgr, Frame& frame) {
  cv::Mat rgb(Frame::kHeight, Frame::kWidth, CV_8UC3, frame.rgb.data());
  cv::Mat scaled;
  cv::resize(paper_shape(bgr), scaled, rgb.size(), 0, 0, cv::INTER_AREA);
  cv::cvtColor(scaled, rgb, cv::COLOR_BGR2RGB);
}

/// A camera, video or still picture. `grab` waits for a camera's next picture. Files are read at
/// their own rate, and a video starts again at its end.
class OpencvSource final : public FrameSource {
 public:
  explicit OpencvSource(std::string device)
      : device_(std::move(device)), problem_("The camera " + device_ + " was not opened yet.") {}

  bool grab(Frame& frame, Time now) override {
    try {
      return take(frame, now);
    } catch (const cv::Exception& failure) {
      return lose("cannot be used (" + failure.err + "): check it, or name another one");
    }
  }

  [[nodiscard]] std::string problem() const override { return problem_; }

 private:
  bool take(Frame& frame, Time now) {
    if (!open_ && !open(now)) return false;
    if (!is_camera(device_) && now - last_frame_ < period_) return false;
    if (!next_picture()) return lose("gives no more pictures: check it and its cable");
    convert(picture_, frame);
    last_frame_ = now;
    return true;
  }

  bool open(Time now) {
    if (attempted_ && now - last_attempt_ < kOpenAgain) return false;
    attempted_ = true;
    last_attempt_ = now;
    std::error_code unknown;
    if (!std::filesystem::exists(device_, unknown))
      return lose(unknown ? "cannot be looked for (" + unknown.message() + "): " + advice(unknown)
                          : "is not there: plug it in, or name another one in frame_grabber");
    open_ = is_picture(device_) ? open_picture() : open_video();
    if (!open_) return lose("cannot be opened as a camera, video or picture");
    problem_.clear();
    return true;
  }

  bool open_picture() {
    still_ = cv::imread(device_, cv::IMREAD_COLOR);
    set_rate(kStillRate_hz);
    return !still_.empty();
  }

  bool open_video() {
    const bool opened =
        is_camera(device_) ? video_.open(device_, cv::CAP_V4L2) : video_.open(device_);
    if (opened) set_rate(video_.get(cv::CAP_PROP_FPS));
    return opened;
  }

  void set_rate(double rate_hz) {
    period_ = from_seconds(1 / (rate_hz >= kSlowest_hz ? rate_hz : kStillRate_hz));
  }

  bool next_picture() {
    if (!still_.empty()) {
      picture_ = still_;
      return true;
    }
    if (video_.read(picture_)) return true;
    return !is_camera(device_) && video_.open(device_) && video_.read(picture_);
  }

  bool lose(const std::string& what) {
    open_ = false;
    still_.release();
    video_.release();
    problem_ = "The camera " + device_ + ' ' + what + '.';
    return false;
  }

  std::string device_;
  std::string problem_;
  cv::VideoCapture video_;
  cv::Mat still_;
  cv::Mat picture_;
  Duration period_{};
  Time last_frame_{};
  Time last_attempt_{};
  bool attempted_ = false;
  bool open_ = false;
};

}  // namespace
}  // namespace galilean::robot

extern "C" galilean::robot::FrameSource* galilean_make_opencv_source(const char* device) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  return new galilean::robot::OpencvSource(device);
}
