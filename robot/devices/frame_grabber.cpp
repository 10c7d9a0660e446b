// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/frame_grabber.h"

#include <utility>

namespace galilean::robot {

CameraGrabber::CameraGrabber(FrameSource& source, const FrameGrabberSettings& settings)
    : source_(source), problem_("The camera was not opened yet.") {
  configure(settings);
}

void CameraGrabber::configure(const FrameGrabberSettings& settings) noexcept {
  timeout_ = from_seconds(settings.timeout_s);
  geometry_ = settings.geometry();
}

void CameraGrabber::pump(Time now) {
  Frame& next = frames_.writing();
  if (source_.grab(next, now)) {
    next.number = ++grabbed_;
    next.captured = now;
    frames_.publish();
  }
  note_problem(source_.problem());
  failed_ = false;
}

void CameraGrabber::fail(const std::string& why) {
  failed_ = true;
  note_problem("The camera cannot be used (" + why +
               "), which is tried again: check it, or name another one in frame_grabber.");
}

void CameraGrabber::note_problem(std::string problem) {
  const std::lock_guard lock(problem_mutex_);
  problem_ = std::move(problem);
}

void CameraGrabber::sense(Time now) noexcept {
  frames_.take();
  healthy_ = !failed_ && frame().number > 0 && now - frame().captured <= timeout_;
}

std::string CameraGrabber::problem() const {
  const std::lock_guard lock(problem_mutex_);
  return problem_;
}

}  // namespace galilean::robot
