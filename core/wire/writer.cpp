// SPDX-License-Identifier: BSD-3-Clause
#include <dds/dds.h>

#include <array>
#include <cstddef>
#include <memory_resource>

#include "core/wire/delivery.h"
#include "core/wire/lending.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/qos.h"
#include "core/wire/security.h"
#include "core/wire/writer.h"

namespace galilean::wire {
namespace {

/// Returns no entity if DDS Security does not permit it.
Entity permitted_writer(Participant& participant, const std::string& topic,
                        const std::string& ros_type) {
  const auto of = participant.topic(topic, ros_type);
  if (of == 0) return {};
  return Entity(permitted(
      dds_create_writer(participant.handle(), of, make_qos(delivery_of(ros_type)).get(), nullptr),
      "write", topic));
}

}  // namespace

template <class M>
Writer<M>::Writer(Participant& participant, const std::string& topic)
    : entity_(permitted_writer(participant, topic, M::kRosType)) {}

template <class M>
bool Writer<M>::write(const M& message) {
  if (entity_.handle() == 0) return false;
  std::array<std::byte, 16 * 1024> first_room;
  std::pmr::monotonic_buffer_resource arena(first_room.data(), first_room.size());
  typename msg::Lent<M>::type sample;
  msg::lend(message, sample, arena);
  const bool is_taken = dds_write(entity_.handle(), &sample) == DDS_RETCODE_OK;
  if (is_taken) entity_.note_written();
  return is_taken;
}

template <class M>
int Writer<M>::readers() const {
  dds_publication_matched_status_t status{};
  dds_get_publication_matched_status(entity_.handle(), &status);
  return static_cast<int>(status.current_count);
}

template class Writer<msg::RobotState>;
template class Writer<msg::Transition>;
template class Writer<msg::Variables>;
template class Writer<msg::Forces>;
template class Writer<msg::Sightings>;
template class Writer<msg::Program>;
template class Writer<msg::ProgramPush>;
template class Writer<msg::ProgramRollback>;
template class Writer<msg::ProgramReply>;
template class Writer<msg::PushProgress>;
template class Writer<msg::Catalog>;
template class Writer<msg::Command>;
template class Writer<msg::BreakOrder>;
template class Writer<msg::TeamStop>;
template class Writer<msg::Breaks>;
template class Writer<msg::TickInputs>;
template class Writer<msg::ObjectMap>;
template class Writer<msg::Score>;
template class Writer<msg::SimulationOrder>;
template class Writer<msg::SimulationEvent>;
template class Writer<msg::SimulationState>;
template class Writer<msg::LeaseChange>;
template class Writer<msg::CompressedImage>;
template class Writer<msg::Odometry>;
template class Writer<msg::OccupancyGrid>;
template class Writer<msg::TFMessage>;
template class Writer<msg::MarkerArray>;
template class Writer<msg::DiagnosticArray>;
template class Writer<msg::Log>;
template class Writer<msg::Clock>;

}  // namespace galilean::wire
