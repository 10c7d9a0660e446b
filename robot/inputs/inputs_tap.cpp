// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inputs/inputs_tap.h"

#include "core/device/devices.h"
#include "core/device/frame_grabber.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

void InputsTap::on_event(const Event& event) noexcept {
  switch (event.kind) {
    case Event::Kind::kStarted:
    case Event::Kind::kSwapped:
      next_.taken_over = event.program;
      return;
    case Event::Kind::kRolledBack:
      if (event.fault != Fault::kOrdered) return;  // the executive finds the others by itself
      next_.rolled_back = event.from_program;
      next_.reason = event.text;
      return;
    case Event::Kind::kTransition:
      if (event.cause == Event::Cause::kCondition) next_.outcome.fired = event.condition;
      return;
    case Event::Kind::kConfirmed:
    case Event::Kind::kSchemaFailed:
      return;
  }
}

void InputsTap::on_tick(const TickView& view) noexcept {
  if (!wanted_.load(std::memory_order_relaxed)) {
    last_frame_ = 0;  // the next reader has seen no picture
    return begin_anew();
  }
  copy(view);
  copy_memory(view);
  const Frame& frame = view.devices.frame_grabber.frame();
  next_.has_picture = frame.number != 0 && (frame.number != last_frame_ || next_.memory_words > 0);
  if ((!next_.has_picture || hand_over_picture(frame)) && records_.push(next_)) {
    last_frame_ = frame.number;
  } else {
    ++lost_;
    if (next_.memory_words > 0) memory_is_free_.store(true, std::memory_order_relaxed);
  }
  begin_anew();
}

/// With its memory a run begins anew for who reads it: the picture comes with it.
void InputsTap::copy_memory(const TickView& view) noexcept {
  next_.memory_words = 0;
  if (!wants_memory_.load(std::memory_order_relaxed) || !view.program) return;
  if (!memory_is_free_.exchange(false, std::memory_order_acquire)) return;
  wants_memory_.store(false, std::memory_order_relaxed);
  next_.memory_words = view.executive->save(memory_);
  next_.has_predecessor = view.executive->has_predecessor();
  if (next_.memory_words == 0) memory_is_free_.store(true, std::memory_order_relaxed);
}

void InputsTap::copy(const TickView& view) noexcept {
  next_.tick = view.tick.number;
  next_.now = view.tick.now;
  next_.period = view.tick.period;
  next_.tick_time = view.tick_time;
  next_.orders = view.orders;
  next_.break_table = view.break_table;
  next_.health = view.health;
  next_.board = view.devices.comm_port.status();
  next_.frame = view.devices.frame_grabber.frame().number;
  next_.captured = view.devices.frame_grabber.frame().captured;
  outcome_.take(view, next_.outcome);
}

bool InputsTap::hand_over_picture(const Frame& frame) noexcept {
  Frame* place = pictures_.writing();
  if (!place) return false;
  *place = frame;
  pictures_.publish();
  return true;
}

/// Forgets the events of the tick that is over.
void InputsTap::begin_anew() noexcept {
  next_.taken_over = next_.rolled_back = 0;
  next_.reason = {};
  next_.outcome.fired = Event::kNone;
}

/// A picture whose tick found no room is passed over.
bool InputsTap::take(TickRecord& to) {
  if (holds_picture_) pictures_.release();
  holds_picture_ = false;
  if (taken_words_ > 0) memory_is_free_.store(true, std::memory_order_release);
  taken_words_ = 0;
  const auto record = records_.pop();
  if (!record) return false;
  to = *record;
  taken_words_ = to.memory_words;
  if (!to.has_picture) return true;
  while (pictures_.oldest()->number != to.frame) pictures_.release();
  holds_picture_ = true;
  return true;
}

}  // namespace galilean::robot
