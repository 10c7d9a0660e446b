// SPDX-License-Identifier: BSD-3-Clause
// wire_neighbour NAME COUNT DOMAIN: one process of a team. Publishes its state, says "met" once it
// has read the states of COUNT robots, and stays until its standard input ends.
#include <iostream>
#include <map>

#include "core/wire/discovery.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/schemas.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "tests/core/wire/wait_until.h"

namespace {

using namespace galilean;

class Neighbourhood {
 public:
  explicit Neighbourhood(wire::Participant& participant)
      : participant_(participant), discovery_(participant) {}

  /// Returns how many robots' states were read so far.
  std::size_t met() {
    for (const auto& publication : discovery_.publications())
      if (publication.dds_type == wire::find_schema_by_ros_type(kType)->dds_type)
        readers_.try_emplace(publication.topic, participant_, publication.topic, kType);
    std::size_t count = 0;
    for (auto& [topic, neighbour] : readers_) {
      neighbour.reader.take_unchecked(
          [&heard = neighbour.heard](const wire::Received&) { heard = true; });
      count += neighbour.heard;
    }
    return count;
  }

 private:
  static constexpr const char* kType = msg::RobotState::kRosType;
  struct Neighbour {
    Neighbour(wire::Participant& participant, const std::string& topic, const char* type)
        : reader(participant, topic, type) {}
    wire::Reader reader;
    bool heard = false;
  };

  wire::Participant& participant_;
  wire::Discovery discovery_;
  std::map<std::string, Neighbour> readers_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto participant = wire::Participant::join(argv[1], std::stoi(argv[3]));
  if (!participant) return std::cerr << participant.error().message << '\n', 1;
  wire::Writer<msg::RobotState> writer(*participant.value(), wire::robot_topic(argv[1], "state"));
  if (!writer.write({})) return 1;
  Neighbourhood neighbourhood(*participant.value());
  const std::size_t count = std::stoul(argv[2]);
  const bool all = wire::wait_until([&] { return neighbourhood.met() >= count; });
  std::cout << (all ? "met" : "alone") << std::endl;
  std::cin.get();
  return all ? 0 : 1;
}
