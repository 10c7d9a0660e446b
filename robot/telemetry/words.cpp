// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/words.h"

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

std::vector<Problem> problems_of(const Snapshot& snapshot, const Description* program,
                                 const Devices& devices) {
  std::vector<Problem> problems;
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
