// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"

namespace galilean::robot {

/// The topics on which a robot tells what it does.
struct RobotWriters {
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  RobotWriters(wire::Participant& participant, const std::string& robot)
      : state(participant, wire::robot_topic(robot, "state")),
        transition(participant, wire::robot_topic(robot, "transition")),
        variables(participant, wire::robot_topic(robot, "variables")),
        forces(participant, wire::robot_topic(robot, "forces")),
        sightings(participant, wire::robot_topic(robot, "sightings")),
        program(participant, wire::robot_topic(robot, "program")),
        catalog(participant, wire::robot_topic(robot, "catalog")),
        odometry(participant, wire::robot_topic(robot, "odom")),
        transform(participant, wire::kTfTopic),
        diagnostics(participant, wire::kDiagnosticsTopic),
        log(participant, wire::kLogTopic) {}

  wire::Writer<msg::RobotState> state;
  wire::Writer<msg::Transition> transition;
  wire::Writer<msg::Variables> variables;
  wire::Writer<msg::Forces> forces;
  wire::Writer<msg::Sightings> sightings;
  wire::Writer<msg::Program> program;
  wire::Writer<msg::Catalog> catalog;
  wire::Writer<msg::Odometry> odometry;
  wire::Writer<msg::TFMessage> transform;
  wire::Writer<msg::DiagnosticArray> diagnostics;
  wire::Writer<msg::Log> log;
};

}  // namespace galilean::robot
