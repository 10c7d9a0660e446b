// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/dashboard_model.h"

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor::top {
namespace {
/// The age at which objects and sightings are no longer shown. A monitor sends objects five times a
/// second, and a robot sends sightings with each camera frame, so the sender has then stopped.
constexpr Duration kStaleAfter = std::chrono::seconds(5);
}  // namespace

template <class M>
bool DashboardModel::note(const Message& message, std::optional<Heard<M>>& to) {
  M decoded;
  if (!msg::decode_cdr(*message.cdr, decoded)) return false;
  to = Heard<M>{std::move(decoded), clock_.now()};
  return true;
}

void DashboardModel::receive(const Message& message) {
  const auto type = message.channel.schema->ros_type;
  if (type == msg::ObjectMap::kRosType)
    note(message, objects_);
  else if (type == msg::OccupancyGrid::kRosType)
    note(message, floor_);
  else if (type == msg::Sightings::kRosType)
    note(message, sightings_[message.channel.topic]);
  else
    team_.receive(message);
}

const msg::ObjectMap* DashboardModel::objects() const noexcept {
  const bool current = objects_ && clock_.now() - objects_->received < kStaleAfter;
  return current ? &objects_->message : nullptr;
}

const msg::OccupancyGrid* DashboardModel::floor() const noexcept {
  return floor_ ? &floor_->message : nullptr;
}

const msg::Sightings* DashboardModel::sightings(const std::string& robot) const noexcept {
  const auto found = sightings_.find(wire::robot_topic(robot, "sightings"));
  if (found == sightings_.end() || !found->second) return nullptr;
  const bool current = clock_.now() - found->second->received < kStaleAfter;
  return current ? &found->second->message : nullptr;
}

}  // namespace galilean::monitor::top
