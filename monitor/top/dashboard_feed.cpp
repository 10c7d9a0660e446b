// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard_feed.h"

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor::top {
namespace {

template <class M>
bool is(const Channel& channel) {
  return channel.schema->ros_type == M::kRosType;
}

}  // namespace

DashboardFeed::DashboardFeed(wire::Participant& participant, const Clock& clock)
    : model_(clock),
      history_(clock),
      clock_(clock),
      ingest_(
          participant,
          {.channel =
               [this](const Channel& channel) {
                 if (is<msg::Sightings>(channel)) sightings_[channel.topic] = channel.id;
                 if (is<msg::Variables>(channel)) variables_[channel.topic] = channel.id;
               },
           .message =
               [this](const Message& message) {
                 model_.receive(message);
                 history_.note(message);
               },
           .forgotten = [this](const std::string& robot) { model_.forget(robot); }},
          [this] { wake_.ring(); },
          [](const Channel& channel) {
            return DashboardModel::shows(channel.schema->ros_type) && !is<msg::Sightings>(channel);
          }) {}

void DashboardFeed::poll() {
  wake_.clear();
  let_variables_rest();
  ingest_.poll();
  note_intake();
}

void DashboardFeed::note_intake() {
  constexpr Duration kEach = std::chrono::seconds(1);
  const Time now = clock_.now();
  if (now < intake_due_) return;
  intake_due_ = now + kEach;
  model_.note(ingest_.intake());
}

void DashboardFeed::let_variables_rest() {
  const Time now = clock_.now();
  const bool all = now >= all_due_;
  if (all) all_due_ = now + History::kEach;
  for (const auto& [topic, channel] : variables_)
    ingest_.rest(channel, !all && topic != shown_variables_);
}

void DashboardFeed::look_through(const std::string& robot) {
  shown_variables_ = wire::robot_topic(robot, "variables");
  const auto found = sightings_.find(wire::robot_topic(robot, "sightings"));
  const bool is_wanted = !model_.objects() && found != sightings_.end();
  const std::uint32_t channel = is_wanted ? found->second : 0;
  if (channel == looked_through_) return;
  ingest_.want(looked_through_, false);
  ingest_.want(channel, true);
  looked_through_ = channel;
}

}  // namespace galilean::monitor::top
