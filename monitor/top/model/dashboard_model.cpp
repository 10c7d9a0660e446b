// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/dashboard_model.h"

#include <algorithm>
#include <array>

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"
#include "monitor/team/monitor_status.h"

namespace galilean::monitor::top {
namespace {
/// The age at which objects and sightings are no longer shown. A monitor sends objects five times a
/// second, and a robot sends sightings with each camera frame, so the sender has then stopped.
constexpr Duration kStaleAfter = std::chrono::seconds(5);
/// A reply that was sent so long before it was received is an old one, which DDS keeps for those
/// who join later.
constexpr std::int64_t kOldReply_ns = 10'000'000'000;
constexpr std::array<std::string_view, 13> kShown{
    msg::RobotState::kRosType,     msg::Transition::kRosType,    msg::Variables::kRosType,
    msg::Program::kRosType,        msg::Catalog::kRosType,       msg::Score::kRosType,
    msg::ObjectMap::kRosType,      msg::OccupancyGrid::kRosType, msg::Sightings::kRosType,
    msg::PushProgress::kRosType,   msg::ProgramReply::kRosType,  msg::Breaks::kRosType,
    msg::DiagnosticArray::kRosType};
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
    note_objects(message);
  else if (type == msg::OccupancyGrid::kRosType)
    note_floor(message);
  else if (type == msg::Sightings::kRosType)
    note(message, sightings_[message.channel.topic]);
  else if (type == msg::ProgramReply::kRosType)
    note_reply(message);
  else if (type == msg::PushProgress::kRosType)
    note_push(message);
  else if (type == msg::DiagnosticArray::kRosType)
    note_diagnostics(message);
  else
    team_.receive(message);
  if (identities_.count() < team_.robots().size())
    for (const auto& [name, robot] : team_.robots()) identities_.meet(name);
}

void DashboardModel::forget(const std::string& robot) {
  team_.forget(robot);
  identities_.forget(robot);
  sightings_.erase(wire::robot_topic(robot, "sightings"));
}

bool DashboardModel::shows(std::string_view ros_type) noexcept {
  return std::ranges::find(kShown, ros_type) != kShown.end();
}

void DashboardModel::note_objects(const Message& message) {
  if (note(message, objects_)) team_.note(objects_->message);
}

void DashboardModel::note_floor(const Message& message) {
  msg::OccupancyGrid grid;
  if (msg::decode_cdr(*message.cdr, grid)) floor_ = std::make_shared<const Floor>(grid);
}

void DashboardModel::note_reply(const Message& message) {
  msg::ProgramReply reply;
  if (message.received_ns - message.sent_ns > kOldReply_ns) return;
  if (!msg::decode_cdr(*message.cdr, reply)) return;
  replies_.push_back(std::move(reply));
  if (replies_.size() > kRepliesKept) replies_.pop_front();
}

void DashboardModel::note_diagnostics(const Message& message) {
  msg::DiagnosticArray array;
  if (!msg::decode_cdr(*message.cdr, array)) return;
  if (auto problem = monitor_problem(array, kHistoryStatusName))
    history_problem_ = Heard<std::string>{std::move(*problem), clock_.now()};
  if (auto problem = monitor_problem(array, kMapStatusName))
    map_problem_ = Heard<std::string>{std::move(*problem), clock_.now()};
}

std::string DashboardModel::told_lately(const std::optional<Heard<std::string>>& told) const {
  if (!told || clock_.now() - told->received > kStaleAfter) return {};
  return told->message;
}

void DashboardModel::note_push(const Message& message) {
  msg::PushProgress push;
  if (!msg::decode_cdr(*message.cdr, push)) return;
  if (!pushed_names_.contains(push.id)) pushes_.push_back(push.id);
  pushed_names_[push.id] = push.program;
  if (pushes_.size() <= kPushedNamesKept) return;
  pushed_names_.erase(pushes_.front());
  pushes_.pop_front();
}

std::string DashboardModel::pushed_name(const std::string& push_id) const {
  const auto found = pushed_names_.find(push_id);
  return found == pushed_names_.end() ? std::string() : found->second;
}

const msg::ObjectMap* DashboardModel::objects() const noexcept {
  const bool current = objects_ && clock_.now() - objects_->received < kStaleAfter;
  return current ? &objects_->message : nullptr;
}

const msg::Sightings* DashboardModel::sightings(const std::string& robot) const noexcept {
  const auto found = sightings_.find(wire::robot_topic(robot, "sightings"));
  if (found == sightings_.end() || !found->second) return nullptr;
  const bool current = clock_.now() - found->second->received < kStaleAfter;
  return current ? &found->second->message : nullptr;
}

}  // namespace galilean::monitor::top
