// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/microcontroller_link.h"

#include <algorithm>
#include <utility>

#include "robot/firmware/hardware.h"

namespace galilean::robot {
namespace {

constexpr Duration kShortestOrder = std::chrono::milliseconds(60);

}  // namespace

MicrocontrollerLink::MicrocontrollerLink(ByteStream& line, const CommPortSettings& settings,
                                         Duration tick_period)
    : timeout_(from_seconds(settings.timeout_s)),
      order_lasts_(std::max(kShortestOrder, tick_period * 6 / 5)),
      line_name_(line.name()),
      session_(line, timeout_, order_lasts_),
      problem_("The serial line " + line_name_ + " was not opened yet.") {}

void MicrocontrollerLink::pump(Time now) {
  if (new_timeout_.take()) session_.set_timeout(new_timeout_.reading());
  if (setup_.take()) {
    counts_per_m_ = setup_.reading().ticks_per_m * firmware::kCountsPerTick;
    session_.configure(setup_.reading().parameters);
  }
  forward_orders(now);
  last_pump_ = now;
  const bool status_came = session_.pump(now);
  if (status_came || session_.ready() != newest_.ready) publish_report(now, status_came);
  note_problem(session_.problem());
  failed_ = false;
}

void MicrocontrollerLink::fail(const std::string& why) {
  failed_ = true;
  note_problem("The serial line " + line_name_ + " cannot be used (" + why +
               "), which is tried again: check it, or name another one in comm_port.");
}

void MicrocontrollerLink::forward_orders(Time now) {
  if (gripper_.take()) session_.grip(gripper_.reading() == GripperCommand::kClose);
  if (!order_.take()) return;
  const Order& order = order_.reading();
  // A process that stood still finds what it ordered before that. It is ordered again if it is
  // still wanted.
  const bool stood_still = now - last_pump_ > order_lasts_;
  if (order.stop) {
    session_.stop();
  } else if (order.number == forwarded_) {
    session_.keep_moving(now);
  } else if (!stood_still) {
    forwarded_ = order.number;
    session_.drive(order.drive, now);
  }
}

void MicrocontrollerLink::publish_report(Time now, bool status_came) {
  newest_.ready = session_.ready();
  if (status_came) {
    const firmware::Status& board = session_.status();
    const bool began_anew =
        newest_.status.received == Time{} || newest_.status.epoch != session_.epoch();
    if (began_anew)
      odometer_.restart(board.left_encoder_counts, board.right_encoder_counts, counts_per_m_);
    odometer_.update(board.left_encoder_counts, board.right_encoder_counts, counts_per_m_);
    newest_.status = {.received = now,
                      .bumpers = board.bumpers,
                      .beam_broken = (board.flags & firmware::status_flag::kBeamBroken) != 0,
                      .gripper_closed = board.gripper_state ==
                                        static_cast<std::uint8_t>(firmware::GripperState::kClosed),
                      .left_travel_m = odometer_.left_m(),
                      .right_travel_m = odometer_.right_m(),
                      .left_speed_mps = board.left_speed_counts_s / counts_per_m_,
                      .right_speed_mps = board.right_speed_counts_s / counts_per_m_,
                      .epoch = session_.epoch()};
  }
  report_.publish(newest_);
}

void MicrocontrollerLink::note_problem(std::string problem) {
  const std::lock_guard lock(problem_mutex_);
  problem_ = std::move(problem);
}

void MicrocontrollerLink::sense(Time now) noexcept {
  report_.take();
  const Report& report = report_.reading();
  healthy_ = !failed_ && report.ready && now - report.status.received <= timeout_;
}

const ControllerStatus& MicrocontrollerLink::status() const noexcept {
  return report_.reading().status;
}

std::string MicrocontrollerLink::problem() const {
  const std::lock_guard lock(problem_mutex_);
  return problem_;
}

void MicrocontrollerLink::command_gripper(GripperCommand command) noexcept {
  gripper_.publish(command);
}

void MicrocontrollerLink::drive(const firmware::Drive& command) noexcept {
  ordered_ = {false, command, ordered_.number + 1};
  order_.publish(ordered_);
}

void MicrocontrollerLink::keep_moving() noexcept {
  if (!ordered_.stop) order_.publish(ordered_);
}

void MicrocontrollerLink::stop() noexcept {
  ordered_ = {true, {}, ordered_.number + 1};
  order_.publish(ordered_);
}

void MicrocontrollerLink::configure(const MotorSetup& setup) noexcept {
  setup_.publish(setup);
}

void MicrocontrollerLink::set_timeout(Duration timeout) noexcept {
  timeout_ = timeout;
  new_timeout_.publish(timeout);
}

}  // namespace galilean::robot
