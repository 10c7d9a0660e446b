// SPDX-License-Identifier: BSD-3-Clause
// foreign_talker DOMAIN: a program of somebody else, for tests of those who listen. It writes a
// message of each foreign type five times a second, each to a topic of its own, and ends with its
// standard input.
#include <poll.h>
#include <unistd.h>

#include <iostream>
#include <vector>

#include "core/wire/participant.h"
#include "tests/core/wire/types/foreign_talk.h"

int main(int argc, char** argv) {
  using namespace galilean::wire;
  if (argc != 2) return 2;
  const auto participant = Participant::join("talker", std::stoi(argv[1]));
  if (!participant) return std::cerr << participant.error().message << '\n', 1;
  const auto handle = participant.value()->handle();
  std::vector<ForeignTalk> talks;
  talks.emplace_back(handle, Foreign::kPlain, "rt/foreign/plain", Cdr::kFirst);
  talks.emplace_back(handle, Foreign::kReport, "rt/foreign/report", Cdr::kSecond);
  talks.emplace_back(handle, Foreign::kSettings, "rt/foreign/settings", Cdr::kSecond);
  talks.emplace_back(handle, Foreign::kKeyed, "rt/foreign/keyed", Cdr::kSecond);
  talks.emplace_back(handle, Foreign::kRobotState, "rt/io/state", Cdr::kFirst);
  talks.emplace_back(handle, Foreign::kBare, "rt/foreign/bare", Cdr::kFirst);
  std::cout << "talking" << std::endl;
  constexpr int kPause_ms = 200;
  for (pollfd input{STDIN_FILENO, POLLIN, 0}; poll(&input, 1, kPause_ms) == 0;)
    for (auto& talk : talks)
      if (!talk.write()) return 1;
  return 0;
}
