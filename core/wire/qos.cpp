// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/qos.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace galilean::wire {
namespace {

constexpr auto kDeliveries = std::to_array<std::pair<std::string_view, Delivery>>({
    {"galilean_msgs/msg/RobotState", Delivery::kState},
    {"galilean_msgs/msg/Variables", Delivery::kState},
    {"galilean_msgs/msg/Program", Delivery::kState},
    {"galilean_msgs/msg/Catalog", Delivery::kState},
    {"galilean_msgs/msg/Breaks", Delivery::kState},
    {"galilean_msgs/msg/ObjectMap", Delivery::kState},
    {"galilean_msgs/msg/Score", Delivery::kState},
    {"galilean_msgs/msg/SimulationState", Delivery::kState},
    {"nav_msgs/msg/OccupancyGrid", Delivery::kState},
    {"visualization_msgs/msg/MarkerArray", Delivery::kState},
    {"galilean_msgs/msg/Transition", Delivery::kJournal},
    {"galilean_msgs/msg/ProgramReply", Delivery::kEvent},
    {"galilean_msgs/msg/PushProgress", Delivery::kEvent},
    {"galilean_msgs/msg/SimulationEvent", Delivery::kEvent},
    {"galilean_msgs/msg/LeaseChange", Delivery::kEvent},
    {"rcl_interfaces/msg/Log", Delivery::kEvent},
    {"galilean_msgs/msg/TickInputs", Delivery::kRecord},
    {"galilean_msgs/msg/ProgramPush", Delivery::kCommand},
    {"galilean_msgs/msg/ProgramRollback", Delivery::kCommand},
    {"galilean_msgs/msg/Command", Delivery::kCommand},
    {"galilean_msgs/msg/BreakOrder", Delivery::kCommand},
    {"galilean_msgs/msg/TeamStop", Delivery::kCommand},
    {"galilean_msgs/msg/SimulationOrder", Delivery::kCommand},
    {"nav_msgs/msg/Odometry", Delivery::kFlow},
    {"tf2_msgs/msg/TFMessage", Delivery::kFlow},
    {"diagnostic_msgs/msg/DiagnosticArray", Delivery::kFlow},
    {"galilean_msgs/msg/Forces", Delivery::kStream},
    {"galilean_msgs/msg/Sightings", Delivery::kStream},
    {"sensor_msgs/msg/CompressedImage", Delivery::kStream},
    {"rosgraph_msgs/msg/Clock", Delivery::kStream},
});

constexpr dds_duration_t kMaxBlocking = DDS_MSECS(20);

void set_history(dds_qos_t* qos, int depth, bool kept_for_late_joiners) {
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  dds_qset_durability(
      qos, kept_for_late_joiners ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  if (kept_for_late_joiners)
    dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
}

}  // namespace

Delivery delivery_of(std::string_view ros_type) noexcept {
  for (const auto& [type, delivery] : kDeliveries)
    if (type == ros_type) return delivery;
  return Delivery::kStream;
}

Qos make_qos(Delivery delivery) {
  Qos qos(dds_create_qos());
  const bool best_effort = delivery == Delivery::kStream;
  dds_qset_reliability(qos.get(),
                       best_effort ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                       kMaxBlocking);
  switch (delivery) {
    case Delivery::kState:
      set_history(qos.get(), 1, true);
      break;
    case Delivery::kEvent:
      set_history(qos.get(), 64, true);
      break;
    case Delivery::kJournal:
      set_history(qos.get(), kJournalDepth, true);
      break;
    case Delivery::kCommand:
      set_history(qos.get(), 64, false);
      break;
    case Delivery::kFlow:
      set_history(qos.get(), 10, false);
      break;
    case Delivery::kRecord:
      set_history(qos.get(), 64, true);
      dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, DDS_LENGTH_UNLIMITED);
      break;
    case Delivery::kStream:
      set_history(qos.get(), 1, false);
      break;
  }
  dds_qset_writer_data_lifecycle(qos.get(), false);
  return qos;
}

Qos make_reader_qos(const EndpointQos& asked, int depth) {
  Qos qos(dds_create_qos());
  const char* every_partition = "*";
  dds_qset_reliability(qos.get(),
                       asked.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, 0);
  dds_qset_durability(qos.get(), static_cast<dds_durability_kind_t>(asked.durability));
  dds_qset_ownership(qos.get(), asked.exclusive ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  dds_qset_latency_budget(qos.get(), DDS_INFINITY);
  dds_qset_partition(qos.get(), 1, &every_partition);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  return qos;
}

std::int32_t checked(std::int32_t result, const std::string& what) {
  if (result < 0) throw std::runtime_error(what + ": " + dds_strretcode(result));
  return result;
}

}  // namespace galilean::wire
