// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/command_outbox.h"

namespace galilean::robot {

CommandOutbox::Place CommandOutbox::place_of(firmware::MessageType type) {
  switch (type) {
    case firmware::MessageType::kStop:
      return kStop;
    case firmware::MessageType::kParameters:
      return kParameters;
    case firmware::MessageType::kGripper:
      return kGripper;
    case firmware::MessageType::kDrive:
      return kDrive;
    default:
      return kHello;
  }
}

CommandOutbox::Frame& CommandOutbox::replaced(firmware::MessageType type) {
  const Place place = place_of(type);
  if (place == kStop) waiting_[kDrive].length = 0;
  if (place == kDrive) waiting_[kStop].length = 0;
  waiting_[place].is_command = place == kStop || place == kDrive || place == kGripper;
  return waiting_[place];
}

CommandOutbox::Frame* CommandOutbox::next() {
  if (under_way_.length > 0) return &under_way_;
  for (Frame& frame : waiting_)
    if (frame.length > 0) return &frame;
  return nullptr;
}

void CommandOutbox::note_taken(Frame& frame, std::size_t taken) {
  if (frame.is_command) last_command_ = frame.sequence;
  written_ += taken;
  if (written_ >= frame.length) {
    frame.length = written_ = 0;
  } else if (&frame != &under_way_) {
    // Its place is free for what comes next, while the rest of it is still to be written.
    under_way_ = frame;
    frame.length = 0;
  }
}

void CommandOutbox::drop_commands() {
  for (const Place place : {kStop, kGripper, kDrive}) waiting_[place].length = 0;
  last_command_.reset();
}

void CommandOutbox::clear() {
  for (Frame& frame : waiting_) frame.length = 0;
  under_way_.length = written_ = 0;
  last_command_.reset();
}

}  // namespace galilean::robot
