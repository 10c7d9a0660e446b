// SPDX-License-Identifier: BSD-3-Clause
#include "sim/headless/headless_robot.h"

#include <algorithm>

#include "core/device/device_names.h"

namespace galilean::sim {
namespace {

/// Returns whether the state lists a schema that drives the motors.
bool drives(const bhdl::Program& program, const bhdl::State& state, const Catalog& catalog) {
  const auto is_driver = [&](const bhdl::Component& schema) {
    const ComponentSpec* spec = catalog.find(schema.type);
    const auto& listed = state.motor_schemas;
    return spec != nullptr && spec->drives == kMotorDriveName &&
           std::find(listed.begin(), listed.end(), schema.name) != listed.end();
  };
  return std::any_of(program.motor_schemas.begin(), program.motor_schemas.end(), is_driver);
}

robot::ExecutiveSetup executive_setup(const HeadlessRobot::Setup& setup, const Devices& devices,
                                      robot::DeviceTuner& tuner) {
  robot::ExecutiveSetup made{.components = setup.components,
                             .devices = devices,
                             .clock = setup.clock,
                             .stopwatch = setup.stopwatch};
  made.seed = setup.seed;
  made.tuner = &tuner;
  if (setup.observer) made.observers.push_back(setup.observer);
  return made;
}

}  // namespace

HeadlessRobot::HeadlessRobot(const Setup& setup)
    : name_(robot_name(setup.index)),
      body_(setup.world.robot(setup.index)),
      start_(body_.pose()),
      catalog_(setup.components.catalog()),
      line_(name_ + "'s serial line"),
      board_(body_, line_.board_end(), name_),
      camera_(setup.scene, setup.index, setup.renderer),
      link_(line_.robot_end(), {}),
      drive_(link_, {}),
      grabber_(camera_, {}),
      executive_(executive_setup(setup, {link_, drive_, grabber_}, *this)),
      last_position_m_(start_.position_m) {}

Result<robot::ProgramId> HeadlessRobot::load(bhdl::Program program) {
  for (const auto& state : program.states)
    state_drives_[state.name] = drives(program, state, catalog_);
  return executive_.load(std::move(program));
}

void HeadlessRobot::tune(const robot::DeviceSettings& settings) noexcept {
  drive_.configure(settings.motor_drive);
  grabber_.configure(settings.frame_grabber);
  uses_camera_ = settings.uses_camera;
}

void HeadlessRobot::run_board(Time now) {
  if (body_.broken().serial_line == line_connected_) {
    line_connected_ = !line_connected_;
    line_.connect(line_connected_);
  }
  link_.pump(now);
  board_.set_power(!body_.broken().board);
  board_.update(static_cast<std::uint32_t>(now.time_since_epoch() / std::chrono::milliseconds(1)));
}

void HeadlessRobot::take_picture(Time now) {
  if (!uses_camera_ || body_.broken().camera) return;
  camera_.expose();
  grabber_.pump(now);
}

void HeadlessRobot::tick() {
  executive_.tick();
  if (!first_belief_ && executive_.program()) first_belief_ = executive_.pose();
}

bool HeadlessRobot::tries_to_move() const {
  const auto state = state_drives_.find(executive_.state_name());
  return state != state_drives_.end() && state->second;
}

void HeadlessRobot::note(double dt_s) {
  const Pose2 pose = body_.pose();
  distance_m_ += (pose.position_m - last_position_m_).norm();
  last_position_m_ = pose.position_m;
  stuck_.see(pose, tries_to_move(), dt_s);
  const auto state = seconds_in_state_.find(executive_.state_name());
  if (state != seconds_in_state_.end())
    state->second += dt_s;
  else if (!executive_.state_name().empty())
    seconds_in_state_.emplace(executive_.state_name(), dt_s);
}

std::vector<std::string> HeadlessRobot::problems() const {
  std::vector<std::string> found;
  for (const std::string& problem : {link_.problem(), grabber_.problem()})
    if (!problem.empty()) found.push_back(problem);
  return found;
}

Pose2 HeadlessRobot::believed_pose() const {
  if (!first_belief_) return start_;
  const Pose2 odom = executive_.pose();
  const double turned_rad = start_.heading_rad - first_belief_->heading_rad;
  return {start_.position_m + rotated(odom.position_m - first_belief_->position_m, turned_rad),
          odom.heading_rad + turned_rad};
}

RobotStatistics HeadlessRobot::statistics() const {
  RobotStatistics statistics;
  statistics.distance_m = distance_m_;
  statistics.drift_m = (believed_pose().position_m - body_.pose().position_m).norm();
  statistics.seconds_in_state = {seconds_in_state_.begin(), seconds_in_state_.end()};
  statistics.stuck = stuck_;
  return statistics;
}

}  // namespace galilean::sim
