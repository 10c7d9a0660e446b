// SPDX-License-Identifier: BSD-3-Clause
// wire_stranger DOMAIN: somebody who means no good, for tests of those who listen. It announces a
// thousand topics of robots that are not there, and writes without end: states of twenty thousand
// invented robots, a frame whose angle of view is infinite, and a map that tells of countless
// robots. It says "strange" when it begins, and ends with its standard input.
#include <poll.h>
#include <unistd.h>

#include <deque>
#include <iostream>
#include <limits>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"

namespace {

using namespace galilean;

constexpr int kTopics = 1000;
constexpr int kNames = 20'000;

std::string invented(int number) {
  return "invented_" + std::to_string(number % kNames);
}

msg::RobotState state_of(int number) {
  msg::RobotState state;
  state.robot = invented(number);
  return state;
}

msg::Sightings endless_frame() {
  msg::Sightings frame;
  frame.robot = "stranger";
  frame.view_angle_rad = std::numeric_limits<float>::infinity();
  return frame;
}

msg::ObjectMap countless_robots() {
  msg::ObjectMap map;
  for (int i = 0; i < kNames; ++i) map.robots.emplace_back().name = invented(i);
  return map;
}

bool input_ended() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, 1) > 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto joined = wire::Participant::join("stranger", std::stoi(argv[1]));
  if (!joined) return std::cerr << joined.error().message << '\n', 1;
  wire::Participant& participant = *joined.value();
  wire::Writer<msg::Sightings> frames(participant, wire::robot_topic("stranger", "sightings"));
  wire::Writer<msg::RobotState> states(participant, wire::robot_topic("stranger", "state"));
  wire::Writer<msg::ObjectMap> maps(participant, wire::kObjectsTopic);
  std::deque<wire::Writer<msg::Breaks>> topics;
  for (int i = 0; i < kTopics; ++i)
    topics.emplace_back(participant, wire::robot_topic(invented(i), "breaks"));
  std::cout << "strange" << std::endl;
  // What DDS does not take at once is no loss to a stranger.
  for (int number = 0; !input_ended(); ++number) {
    for (int i = 0; i < 20; ++i) static_cast<void>(states.write(state_of(20 * number + i)));
    static_cast<void>(frames.write(endless_frame()));
    if (number % 1000 == 0) static_cast<void>(maps.write(countless_robots()));
  }
  return 0;
}
