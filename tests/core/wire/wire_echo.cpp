// SPDX-License-Identifier: BSD-3-Clause
// For tests in other languages. `wire_echo --schemas` prints every message type with its IDL as
// JSON. `wire_echo DOMAIN` reads lines "TYPE HEX", HEX a message in CDR that somebody else encoded;
// decodes it, publishes it on DDS, takes it off again and prints the bytes that came, as HEX.
#include <chrono>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/schemas.h"
#include "core/wire/writer.h"

namespace {

using namespace galilean;
using Bytes = std::vector<std::uint8_t>;
using Echo = Bytes (*)(wire::Participant&, const Bytes&);

template <class Condition>
bool wait_until(Condition condition) {
  for (int i = 0; i < 5000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

template <class M>
Bytes echo(wire::Participant& participant, const Bytes& cdr) {
  M message;
  if (!msg::decode_cdr(cdr, message)) return {};
  const std::string topic = std::string("rt/echo/") + M::kRosType;
  wire::Reader reader(participant, topic, M::kRosType);
  wire::Writer<M> writer(participant, topic);
  wait_until([&] { return writer.readers() > 0 && reader.writers() > 0; });
  if (!writer.write(message)) return {};
  Bytes got;
  wait_until([&] {
    reader.take_unchecked([&](const wire::Received& received) {
      got.assign(received.cdr.begin(), received.cdr.end());
    });
    return !got.empty();
  });
  return got;
}

template <class... M>
std::map<std::string, Echo> echoes() {
  return {{M::kRosType, &echo<M>}...};
}

const auto kEchoes =
    echoes<msg::RobotState, msg::Transition, msg::Variables, msg::Forces, msg::Sightings,
           msg::Program, msg::ProgramPush, msg::ProgramReply, msg::PushProgress, msg::Catalog,
           msg::Command, msg::BreakOrder, msg::TeamStop, msg::Breaks, msg::TickInputs,
           msg::ObjectMap, msg::Score, msg::SimulationOrder, msg::SimulationEvent,
           msg::SimulationState, msg::LeaseChange, msg::CompressedImage, msg::Odometry,
           msg::OccupancyGrid, msg::TFMessage, msg::MarkerArray, msg::DiagnosticArray, msg::Log,
           msg::Clock>();

Bytes from_hex(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

std::string to_hex(const Bytes& bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  for (const auto byte : bytes) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15];
  }
  return hex;
}

void print_schemas() {
  auto list = nlohmann::json::array();
  for (const auto& schema : wire::schemas())
    list.push_back({{"ros_type", schema.ros_type},
                    {"dds_type", schema.dds_type},
                    {"idl", schema.idl},
                    {"published", kEchoes.contains(std::string(schema.ros_type))}});
  std::cout << list.dump() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: wire_echo --schemas | DOMAIN\n", 2;
  if (std::string(argv[1]) == "--schemas") return print_schemas(), 0;
  const auto participant = wire::Participant::join("wire_echo", std::stoi(argv[1]));
  if (!participant) return std::cerr << participant.error().message << '\n', 1;
  for (std::string type, hex; std::cin >> type >> hex;) {
    const auto found = kEchoes.find(type);
    if (found == kEchoes.end()) return std::cerr << "no message is called " << type << '\n', 1;
    std::cout << to_hex(found->second(*participant.value(), from_hex(hex))) << std::endl;
  }
  return 0;
}
