// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard_feed.h"

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor::top {
namespace {

bool is_sightings(const Channel& channel) {
  return channel.schema->ros_type == msg::Sightings::kRosType;
}

}  // namespace

DashboardFeed::DashboardFeed(wire::Participant& participant, const Clock& clock)
    : model_(clock),
      history_(clock),
      ingest_(
          participant,
          {.channel =
               [this](const Channel& channel) {
                 if (is_sightings(channel)) sightings_[channel.topic] = channel.id;
               },
           .message =
               [this](const Message& message) {
                 model_.receive(message);
                 history_.note(message);
               }},
          [this] { wake_.ring(); },
          [](const Channel& channel) {
            return DashboardModel::shows(channel.schema->ros_type) && !is_sightings(channel);
          }) {}

void DashboardFeed::poll() {
  wake_.clear();
  ingest_.poll();
}

void DashboardFeed::look_through(const std::string& robot) {
  const auto found = sightings_.find(wire::robot_topic(robot, "sightings"));
  const bool is_wanted = !model_.objects() && found != sightings_.end();
  const std::uint32_t channel = is_wanted ? found->second : 0;
  if (channel == looked_through_) return;
  ingest_.want(looked_through_, false);
  ingest_.want(channel, true);
  looked_through_ = channel;
}

}  // namespace galilean::monitor::top
