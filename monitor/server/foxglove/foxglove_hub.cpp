// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/foxglove/foxglove_hub.h"

#include <algorithm>

#include "core/wire/delivery.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor::foxglove {
Hub::Hub(std::string server_name, Demand demand)
    : server_name_(std::move(server_name)),
      session_id_(std::to_string(wire::wall_clock_ns())),
      demand_(std::move(demand)) {}

Hub::~Hub() = default;

void Hub::add_service(Service service, Handler handler) {
  services_.push_back(std::move(service));
  handlers_.push_back(std::move(handler));
}

void Hub::add_channel(const Channel& channel) {
  topics_[channel.id].channel = &channel;
  advertisement_ = {};
  const Frame frame = text_frame(advertise({&channel}));  // clients share its payload
  for (Client* client : std::vector(clients_)) client->push(frame);
}

void Hub::send(const Message& message) {
  Topic* topic = find(message.channel.id);
  if (!topic) return;
  if (const auto depth = wire::kept_for_late_joiners(message.channel.delivery); depth > 0) {
    if (topic->kept.size() >= depth) topic->kept.pop_front();
    topic->kept.push_back(message);
  }
  for (const auto& [client, subscription_id] : topic->subscribers)
    client->deliver(subscription_id, message);
}

void Hub::send_time(std::int64_t since_epoch_ns) {
  constexpr std::uint32_t kTimeLane = 0xffffffff;
  for (Client* client : clients_) {
    client->outbox_->offer(kTimeLane, time_frame(since_epoch_ns), 1);
    client->link_.flush();
  }
}

void Hub::send_parameters(ParameterValues now) {
  ParameterValues changed;
  for (const auto& [name, value] : now)
    if (const auto found = parameters_.find(name);
        found == parameters_.end() || found->second != value)
      changed[name] = value;
  parameters_ = std::move(now);
  if (changed.empty()) return;
  for (Client* client : std::vector(clients_)) client->tell_parameters(changed);
}

void Hub::send_graph(ConnectionGraph now) {
  for (const auto& service : services_) now.services[service.name].insert(server_name_);
  if (now == graph_) return;
  const Frame frame = text_frame(graph_update(graph_, now));
  graph_ = std::move(now);
  for (Client* client : std::vector(clients_))
    if (client->watches_graph_) client->push(frame);
}

bool Hub::graph_is_watched() const {
  return std::ranges::any_of(clients_, [](const Client* client) { return client->watches_graph_; });
}

std::unique_ptr<Hub::Client> Hub::connect(Link& link, bool may_call, OperatorId who) {
  return std::make_unique<Client>(*this, link, may_call, std::move(who));
}

const Frame& Hub::advertisement() {
  if (advertisement_.payload) return advertisement_;
  std::vector<const Channel*> channels;
  for (const auto& [id, topic] : topics_) channels.push_back(topic.channel);
  advertisement_ = text_frame(advertise(channels));
  advertisement_.is_kept_anyway = true;
  return advertisement_;
}

void Hub::bound_queues() {
  while (*queued_bytes_ > limits_.waiting_events_bytes && !clients_.empty()) {
    const auto slowest = std::ranges::max_element(
        clients_, {}, [](const Client* client) { return client->outbox_->queued_bytes(); });
    if ((*slowest)->outbox_->queued_bytes() == 0) return;
    limit_counts_->reached(Limit::kWaitingEventsOfAll);
    (*slowest)->dismiss();
  }
}

Hub::Topic* Hub::find(std::uint32_t channel_id) {
  const auto found = topics_.find(channel_id);
  return found == topics_.end() ? nullptr : &found->second;
}

Hub::Counts Hub::counts() const {
  Counts counts = past_;
  counts.clients = clients_.size();
  for (const Client* client : clients_) {
    counts.subscriptions += client->channel_of_.size();
    counts.superseded += client->outbox_->superseded();
  }
  return counts;
}

}  // namespace galilean::monitor::foxglove
