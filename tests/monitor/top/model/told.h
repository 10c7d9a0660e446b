// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/wire/delivery.h"
#include "core/wire/messages.h"
#include "monitor/top/model/view.h"

namespace galilean::monitor::top {

/// Plain CDR of what these tests tell, written by hand: the model takes bytes.
class Bytes {
 public:
  Bytes() : bytes_{0, 1, 0, 0} {}
  template <class T>
  Bytes& number(T value) {
    while ((bytes_.size() - 4) % sizeof(T)) bytes_.push_back(0);
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), raw, raw + sizeof value);
    return *this;
  }
  Bytes& text(const std::string& value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    bytes_.push_back(0);
    return *this;
  }
  [[nodiscard]] Payload payload() const {
    return std::make_shared<const std::vector<std::uint8_t>>(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// A model that is told messages.
class Told : public testing::Test {
 protected:
  bool replayed = false;  ///< a replay sends what is told

  virtual void receive(const Message& message) { model.receive(message); }
  void tell(const std::string& topic, std::string_view type, const Bytes& bytes) {
    const Channel channel{1, topic, wire::find_schema_by_ros_type(type), wire::Delivery::kState};
    receive({channel, 0, 0, bytes.payload(), replayed});
  }
  /// Tells of io's variable "trash", which is bits with this value.
  void tell_of_io(double bits = 1) {
    tell("rt/io/variables", msg::Variables::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .text("io")
             .number<std::uint64_t>(1)
             .number<std::uint32_t>(1)
             .text("trash")
             .number<std::uint8_t>(4)
             .text("")
             .number<std::uint8_t>(1)
             .number(0.5F)
             .number(0.1F)
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(1)
             .number(bits));
  }
  struct State {
    std::string robot = "io", state = "wander";
    std::uint32_t overruns = 0;
    bool held = false;
    double x_m = 0;
    bool out_of_service = false;
    std::string program_hash = "3f2a91c0";
  };
  void tell_of(const State& state) {
    tell("rt/" + state.robot + "/state", msg::RobotState::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .text(state.robot)
             .text("office")
             .text(state.program_hash)
             .text(state.state)
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint64_t>(++tick_)
             .number<std::uint64_t>(0)
             .number(0.05F)
             .number(10.0F)
             .number(20.0F)
             .number(state.overruns)
             .number<std::uint8_t>(state.held)
             .number<std::uint8_t>(0)
             .number<std::uint8_t>(state.out_of_service)
             .number(state.x_m)
             .number(0.0)
             .number(0.0)
             .number<std::uint32_t>(0));
  }
  void tell_of_breaks(const msg::Breaks& breaks) {
    Bytes bytes;
    bytes.number(breaks.stamp.sec)
        .number(breaks.stamp.nanosec)
        .text(breaks.robot)
        .number(static_cast<std::uint32_t>(breaks.points.size()));
    for (const auto& point : breaks.points)
      bytes.text(point.from_state).text(point.to_state).number(point.kind);
    bytes.number<std::uint8_t>(breaks.stepping)
        .number<std::uint8_t>(breaks.stopped)
        .number(breaks.stopped_by)
        .number<std::uint64_t>(breaks.stopped_at)
        .text(breaks.break_robot)
        .text(breaks.break_point.from_state)
        .text(breaks.break_point.to_state)
        .number(breaks.break_point.kind)
        .text(breaks.author)
        .text(breaks.waits_at_from)
        .text(breaks.waits_at_to)
        .number(breaks.waits_since.sec)
        .number(breaks.waits_since.nanosec)
        .number(static_cast<std::uint32_t>(breaks.answers.size()));
    for (const auto& answer : breaks.answers) bytes.text(answer.id).text(answer.refused);
    tell("rt/" + breaks.robot + "/breaks", msg::Breaks::kRosType, bytes);
  }
  /// Tells of a program that a robot runs: its name, hash, files and the names of its states.
  void tell_of_program(const msg::Program& program) {
    Bytes bytes;
    bytes.number<std::int32_t>(0)
        .number<std::uint32_t>(0)
        .text(program.robot)
        .text(program.name)
        .text(program.hash)
        .text(program.start_state)
        .number(static_cast<std::uint32_t>(program.files.size()));
    for (const auto& file : program.files) bytes.text(file.path).text(file.text);
    bytes.number(static_cast<std::uint32_t>(program.states.size()));
    for (const auto& state : program.states)
      bytes.text(state.name)
          .text("")
          .number<std::uint32_t>(0)
          .number<std::uint32_t>(0)
          .number<std::uint32_t>(0);
    bytes.number<std::uint32_t>(0);
    tell("rt/" + program.robot + "/program", msg::Program::kRosType, bytes);
  }
  void tell_of_catalog(const std::string& robot, const std::string& json) {
    tell("rt/" + robot + "/catalog", msg::Catalog::kRosType,
         Bytes().text(robot).text("cccc").text(json));
  }
  void tell_of_map(double x_m) {
    tell("rt/team/objects", msg::ObjectMap::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(1)
             .number<std::uint32_t>(7)
             .text("trash")
             .number(x_m)
             .number(2.0)
             .number(0.0)
             .number(0.0)
             .number(0.0)
             .number(0.9F)
             .number(0.1F)
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(0)
             .text("")
             .number<std::uint32_t>(0));
  }
  /// Tells of a robot that the monitor last heard so long ago.
  void tell_of_map_robot(const std::string& robot, float age_s) {
    tell("rt/team/objects", msg::ObjectMap::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(1)
             .text(robot)
             .number(1.0)
             .number(2.0)
             .number(0.0)
             .number(0.0)
             .number(0.0)
             .number(0.0)
             .number(age_s)
             .number<std::uint8_t>(1));
  }

  [[nodiscard]] View view_of(const std::string& robot) const {
    return make_view({model, clock, model.identities()}, {.robot = robot});
  }

  SteppedClock clock;
  DashboardModel model{clock};
  std::uint64_t tick_ = 0;
};

}  // namespace galilean::monitor::top
