// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/snapshot.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace galilean::sim {

Result<std::string> write_snapshot(const Frame& frame, const std::string& path) {
  const cv::Mat rgb(Frame::kHeight, Frame::kWidth, CV_8UC3,
                    const_cast<std::uint8_t*>(frame.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  try {
    if (cv::imwrite(path, bgr)) return path;
  } catch (const cv::Exception&) {
    return Error{path + ": no picture format has this extension; use .png"};
  }
  return Error{path + ": cannot be written; check the folder and its permissions"};
}

}  // namespace galilean::sim
