// SPDX-License-Identifier: BSD-3-Clause
// wire_talker NAME DOMAIN: a robot that only talks, for tests of those who listen. Its states are
// numbered by their tick; with each go variables and a picture. Says "talking" once somebody reads
// its states. At a byte on its standard input it sends no more, and says in JSON how many messages
// of each topic it has sent. It ends with its standard input.
#include <poll.h>
#include <unistd.h>

#include <iostream>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"

namespace {

using namespace galilean;

msg::RobotState state_at(const std::string& name, std::uint64_t tick) {
  msg::RobotState state;
  state.stamp = wire::ros_time(wire::wall_clock_ns());
  state.robot = name;
  state.program_name = "talk";
  state.program_hash = "3f2a91c0";
  state.state = tick / 50 % 2 ? "talk" : "breathe";
  state.state_since = state.stamp;
  state.tick = tick;
  state.tick_period_s = 0.05F;
  state.x_m = static_cast<double>(tick) * 0.01;
  return state;
}

msg::Program program_of(const std::string& name) {
  msg::Program program;
  program.robot = name;
  program.name = "talk";
  program.hash = "3f2a91c0";
  program.files = {{.path = "talk.bhdl", .text = "; talks and breathes\n"}};
  program.states = {{.name = "talk"}, {.name = "breathe"}};
  return program;
}

msg::Variables variables_at(const std::string& name, std::uint64_t tick) {
  msg::Variables variables;
  variables.robot = name;
  variables.tick = tick;
  variables.items = {{.name = "bumpers",
                      .type = msg::Variable_Constants::BITS,
                      .valid = true,
                      .certainty = 0.75F,
                      .values = {2}}};
  return variables;
}

msg::CompressedImage picture_at(std::uint64_t tick) {
  msg::CompressedImage picture;
  picture.format = "jpeg";
  for (std::uint64_t i = 0; i < 5000; ++i)
    picture.data.push_back(static_cast<std::uint8_t>((i * 2654435761 + tick * 40503) >> 8));
  return picture;
}

/// Waits for the end of the input, at most `patience_ms`. This is also the talker's period.
bool input_ended(int patience_ms) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, patience_ms) > 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string name = argv[1];
  const auto joined = wire::Participant::join(name, std::stoi(argv[2]));
  if (!joined) return std::cerr << joined.error().message << '\n', 1;
  wire::Participant& participant = *joined.value();
  wire::Writer<msg::RobotState> states(participant, wire::robot_topic(name, "state"));
  wire::Writer<msg::Program> programs(participant, wire::robot_topic(name, "program"));
  wire::Writer<msg::Variables> variables(participant, wire::robot_topic(name, "variables"));
  wire::Writer<msg::CompressedImage> pictures(participant,
                                              wire::robot_topic(name, "camera/compressed"));
  if (!programs.write(program_of(name))) return 1;
  bool heard = false;
  std::uint64_t sent = 0, pictures_sent = 0;
  for (std::uint64_t tick = 1; !input_ended(10); ++tick) {
    if (!states.write(state_at(name, tick)) || !variables.write(variables_at(name, tick))) return 1;
    ++sent;
    if (pictures.readers() > 0) {
      if (!pictures.write(picture_at(tick))) return 1;
      ++pictures_sent;
    }
    if (!heard && states.readers() > 0) std::cout << "talking" << std::endl;
    heard = heard || states.readers() > 0;
  }
  std::cout << R"({"program":1,"state":)" << sent << R"(,"variables":)" << sent
            << R"(,"camera/compressed":)" << pictures_sent << '}' << std::endl;
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) > 0) {
  }
  return 0;
}
