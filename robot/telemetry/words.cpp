// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/words.h"

#include <array>
#include <cstdio>

#include "core/device/comm_port.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {
namespace {

std::string schema_name(std::size_t schema, const Description& of) {
  return schema < of.schemas.size() ? of.schemas[schema] : "?";
}

Problem device_problem(const std::string& name, const Device& device) {
  const std::string reason = device.problem();
  return {name, reason.empty() ? "It does not answer: check its power and its cable." : reason};
}

/// Returns "3.2 s", "57 s" or "12 min".
std::string lasted_words(Duration lasted) {
  const double lasted_s = to_seconds(lasted);
  std::array<char, 32> text{};
  if (lasted_s < 120)
    std::snprintf(text.data(), text.size(), lasted_s < 10 ? "%.1f s" : "%.0f s", lasted_s);
  else
    std::snprintf(text.data(), text.size(), "%.0f min", lasted_s / 60);
  return text.data();
}

/// Returns what happened, without the full stop, and without for how long while it goes on: the
/// sentence of one fault stays the same meanwhile.
std::string what_happened(const FaultReport& fault) {
  const std::string gone = fault.over ? " was gone for " + lasted_words(fault.lasted) : " is gone";
  switch (fault.cause) {
    case FaultCause::kSerialLine:
      return "the serial line" + gone;
    case FaultCause::kBoard:
      return "the serial line" + gone + ", and the board was restarted or exchanged";
    case FaultCause::kMotorDrive:
      return "the motor drive" + gone;
    case FaultCause::kCamera:
      return "the camera" + gone;
    case FaultCause::kStall:
      return "the robot program stood still for " + lasted_words(fault.lasted);
    case FaultCause::kRestart:
      return "the robot program died while the robot was running, and was started again";
    case FaultCause::kUnknownEnd:
      return "it is not known whether the robot program died while the robot was running";
    case FaultCause::kNamesake:
      return "another robot of this name was there when this one started";
    case FaultCause::kNone:
      break;
  }
  return "no reason is known";
}

std::string when_to_resume(const FaultReport& fault) {
  if (fault.cause == FaultCause::kNamesake) return "; resume it when that one is gone";
  return fault.over ? "; resume it" : "; resume it when it is back";
}

}  // namespace

std::string cause_of(const Event& transition, const Description& from) {
  if (transition.cause == Event::Cause::kSwap) return "program swapped";
  if (transition.cause == Event::Cause::kRollback)
    return "rolled back: " + fault_of(transition, from);
  const auto& state = from.program.states.at(transition.from_state);
  const auto& condition = state.conditions.at(transition.condition);
  return condition.bits_variable + "[" + std::to_string(condition.bit_index) + "] became " +
         (condition.bit_value ? "1" : "0");
}

std::string fault_of(const Event& rollback, const Description& of) {
  switch (rollback.fault) {
    case Fault::kSchemaThrew:
      return "schema '" + schema_name(rollback.schema, of) +
             "' threw: " + std::string(rollback.text.view());
    case Fault::kOverran:
      return std::to_string(Probation::kOverrunsInARow) +
             " ticks in a row took longer than their period";
    case Fault::kDeviceLost:
      return std::string(rollback.text.view()) +
             " answered before the swap and does not answer now";
    case Fault::kThrashed:
      return "it changed its state more than " +
             std::to_string(of.probation.most_transitions_per_s) + " times within a second";
    case Fault::kOrdered:
      return "ordered " + std::string(rollback.text.view());
    case Fault::kNone:
      break;
  }
  return "no reason is known";
}

std::optional<Problem> hold_of(const Snapshot& snapshot) {
  if (snapshot.standstill.hold != Hold::kFault) return std::nullopt;
  const bool by_bumper = ends_at_a_bumper(snapshot.fault.cause);
  return Problem{"held", what_happened(snapshot.fault) + when_to_resume(snapshot.fault) +
                             (by_bumper ? ", or push a bumper." : ".")};
}

std::vector<Problem> problems_of(const Snapshot& snapshot, const Description* program,
                                 const Devices& devices) {
  std::vector<Problem> problems;
  if (auto held = hold_of(snapshot)) problems.push_back(std::move(*held));
  if (!program) problems.push_back({"executive", "No program runs."});
  if (!snapshot.health.comm_port)
    problems.push_back(device_problem(kCommPortName, devices.comm_port));
  else if (!snapshot.health.motor_drive)
    problems.push_back(device_problem(kMotorDriveName, devices.motor_drive));
  if (snapshot.uses_camera && !snapshot.health.frame_grabber)
    problems.push_back(device_problem(kFrameGrabberName, devices.frame_grabber));
  if (!program) return problems;
  for (const auto& failure : snapshot.failures)
    problems.push_back(
        {schema_name(failure.schema, *program),
         "It is switched off, since it threw: " + std::string(failure.reason.view())});
  return problems;
}

}  // namespace galilean::robot
