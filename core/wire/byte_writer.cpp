// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/byte_writer.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"

namespace galilean::wire {
namespace {

using WriteBytes = std::function<bool(std::span<const std::uint8_t>)>;
using MakeWriter = WriteBytes (*)(Participant&, const std::string&);

/// Decodes the bytes and writes the message. Cyclone 0.10 takes encoded bytes only with its own
/// description of their type, which it does not give away. The message encodes to the same bytes.
template <class M>
WriteBytes make_writer(Participant& participant, const std::string& topic) {
  return [writer =
              std::make_shared<Writer<M>>(participant, topic)](std::span<const std::uint8_t> cdr) {
    M message;
    return msg::decode_cdr(cdr, message) && writer->write(message);
  };
}

template <class... M>
constexpr auto table_of() {
  return std::array{std::pair<std::string_view, MakeWriter>{M::kRosType, make_writer<M>}...};
}

constexpr auto kMakers =
    table_of<msg::RobotState, msg::Transition, msg::Variables, msg::Forces, msg::Sightings,
             msg::Program, msg::ProgramPush, msg::ProgramRollback, msg::ProgramReply,
             msg::PushProgress, msg::Catalog, msg::Command, msg::BreakOrder, msg::TeamStop,
             msg::Breaks, msg::ObjectMap, msg::Score, msg::SimulationOrder, msg::SimulationEvent,
             msg::SimulationState, msg::LeaseChange, msg::CompressedImage, msg::Odometry,
             msg::OccupancyGrid, msg::TFMessage, msg::MarkerArray, msg::DiagnosticArray, msg::Log,
             msg::Clock>();

}  // namespace

ByteWriter::ByteWriter(Participant& participant, const std::string& topic,
                       const std::string& ros_type) {
  for (const auto& [type, make] : kMakers)
    if (type == ros_type) write_ = make(participant, topic);
  if (!write_) throw std::runtime_error("no message type is called " + ros_type);
}

}  // namespace galilean::wire
