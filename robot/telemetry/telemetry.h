// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "core/wire/topic_names.h"
#include "robot/log/log_queue.h"
#include "robot/telemetry/break_desk.h"
#include "robot/telemetry/break_publisher.h"
#include "robot/telemetry/command_receiver.h"
#include "robot/telemetry/hold_keeper.h"
#include "robot/telemetry/image_publisher.h"
#include "robot/telemetry/inputs_publisher.h"
#include "robot/telemetry/namesake_alarm.h"
#include "robot/telemetry/order_gate.h"
#include "robot/telemetry/order_reader.h"
#include "robot/telemetry/order_words.h"
#include "robot/telemetry/program_receiver.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

/// All that connects a robot with the DDS domain. The control loop does not depend on it: the loop
/// may run before this object is made and after it is destroyed.
class Telemetry {
 public:
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  Telemetry(const TelemetrySource& source, ImageTap& images, InputsTap& inputs)
      : log_forwarding_(log_),
        executive_(source.executive),
        gate_(source.trust, source.clock, problems_, OrderGate::machine_times(),
              source.order_memory),
        break_place_(order_place(source.participant.domain(), wire::kBreakOrderTopic)),
        break_desk_(source.robot, source.executive, source.held_by),
        holds_(source, break_desk_, problems_),
        breaks_(source, break_desk_),
        namesakes_(source, problems_),
        programs_(source, gate_, problems_.reporter("program_receiver")),
        images_(source, images, problems_.reporter("image_publisher")),
        inputs_(source, inputs, problems_.reporter("inputs_publisher")),
        commands_(source, break_desk_, gate_, problems_.reporter("command_receiver")),
        break_orders_(
            source.participant, wire::kBreakOrderTopic, source.robot,
            [this](const msg::BreakOrder& order, OrderGate::Origin origin) {
              return admit(order, std::move(origin));
            },
            [this](const msg::BreakOrder& order) { break_desk_.obey(order); },
            problems_.reporter("break_receiver")),
        team_stops_(
            source.participant, wire::kTeamStopTopic, source.robot, nullptr,
            [this](const msg::TeamStop& stop) { break_desk_.stop_with_team(stop); },
            problems_.reporter("team_stop_receiver")),
        publisher_(source, log_, problems_,
                   {.event = [this](const Event& event) { listen(event); },
                    .round = [this](const Snapshot& newest) { look_around(newest); }}) {}

  /// Returns where other threads enter their problems, so that these are published too.
  [[nodiscard]] ThreadProblems& problems() noexcept { return problems_; }

 private:
  void look_around(const Snapshot& newest) {
    // First the names of those whose orders were refused: who is answered may leave at once.
    gate_.on_round();
    holds_.on_round(newest);
    breaks_.on_round(newest);
    namesakes_.on_round();
  }
  void listen(const Event& event) {
    breaks_.on_event(event);
    programs_.on_event(event);
  }
  [[nodiscard]] bool admit(const msg::BreakOrder& order, OrderGate::Origin origin) {
    if (!can_move(order, executive_.breaks().points())) return true;
    const auto admitted = gate_.admit(order, break_place_, what_is(order), std::move(origin));
    if (!admitted) break_desk_.refuse(order.id, admitted.error());
    return admitted.ok();
  }

  ThreadProblems problems_;
  LogQueue log_;
  LogForwarding log_forwarding_;
  Executive& executive_;
  OrderGate gate_;
  const std::string break_place_;
  BreakDesk break_desk_;
  HoldKeeper holds_;
  BreakPublisher breaks_;
  NamesakeAlarm namesakes_;
  ProgramReceiver programs_;
  ImagePublisher images_;
  // Ends after the publisher: while that one's writers linger, its own messages are confirmed too.
  InputsPublisher inputs_;
  CommandReceiver commands_;
  OrderReader<msg::BreakOrder> break_orders_;
  OrderReader<msg::TeamStop> team_stops_;
  Publisher publisher_;  // last, so that it ends first: the gate asks the readers in its thread
};

}  // namespace galilean::robot
