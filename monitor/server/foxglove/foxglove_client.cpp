// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/cut_text.h"
#include "core/json_text.h"
#include "monitor/access/access.h"
#include "monitor/background/guarded.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/foxglove/ids.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor::foxglove {
namespace {

/// Returns how many frames of one subscription may wait for a slow client. 0 means that all frames
/// must arrive, so they wait in the outbox's queue.
std::size_t lane_depth(wire::Delivery delivery) {
  switch (delivery) {
    case wire::Delivery::kEvent:
    case wire::Delivery::kJournal:
    case wire::Delivery::kCommand:
    case wire::Delivery::kRecord:
      return 0;
    case wire::Delivery::kFlow:  // several robots write to the same topic
      return 10;
    case wire::Delivery::kState:
    case wire::Delivery::kStream:
      return 1;
  }
  return 1;
}

/// A service call that waits for its answer. It is counted for as long as somebody may answer it.
struct OpenCall {
  explicit OpenCall(std::shared_ptr<std::size_t> count) : waiting(std::move(count)) { ++*waiting; }
  ~OpenCall() { --*waiting; }
  OpenCall(const OpenCall&) = delete;
  OpenCall& operator=(const OpenCall&) = delete;
  std::shared_ptr<std::size_t> waiting;
  bool is_answered = false;
};

}  // namespace

using Request = RequestFields&;
const std::map<std::string, void (*)(Hub::Client&, Request)> Hub::Client::kOperations{
    {"subscribe", [](Client& client, Request request) { client.subscribe(request); }},
    {"unsubscribe", [](Client& client, Request request) { client.unsubscribe(request); }},
    {"getParameters", [](Client& client, Request request) { client.get_parameters(request); }},
    {"setParameters", [](Client& client, Request request) { client.set_parameters(request); }},
    {"subscribeParameterUpdates",
     [](Client& client, Request request) { client.watch_parameters(request, true); }},
    {"unsubscribeParameterUpdates",
     [](Client& client, Request request) { client.watch_parameters(request, false); }},
    {"subscribeConnectionGraph", [](Client& client, Request) { client.watch_graph(true); }},
    {"unsubscribeConnectionGraph", [](Client& client, Request) { client.watch_graph(false); }},
};

Hub::Client::Client(Hub& hub, Link& link, bool may_call, OperatorId who)
    : hub_(hub), link_(link), may_call_(may_call), who_(std::move(who)) {
  hub_.clients_.push_back(this);
  outbox_->on_taken([all = hub_.queued_bytes_](std::size_t bytes) { *all -= bytes; });
  tell(server_info(hub_.server_name_, hub_.session_id_));
  if (!hub_.services_.empty()) tell(advertise_services(hub_.services_));
  if (!hub_.topics_.empty()) push(hub_.advertisement());
}

Hub::Client::~Client() {
  while (!channel_of_.empty()) unsubscribe_one(channel_of_.begin()->first);
  hub_.past_.superseded += outbox_->superseded();
  outbox_->clear();
  std::erase(hub_.clients_, this);
  *alive_ = false;
}

void Hub::Client::receive_text(std::string_view text) {
  if (text.size() > hub_.limits_.message.bytes) hub_.limit_counts_->reached(Limit::kMessage);
  const auto request = read_untrusted_json(text, hub_.limits_.message);
  if (!request) return refuse(request.error().message);
  RequestFields fields(request.value());
  const auto op = fields.text("op");
  if (!fields.ok() || op.empty())
    return refuse("A message must be a JSON object with a string \"op\".");
  const auto known = kOperations.find(op);
  if (known == kOperations.end())
    return refuse("This server does not know the operation \"" + std::string(cut_text(op, 40)) +
                  "\".");
  const auto done = guarded("a client's message", [&] { known->second(*this, fields); });
  if (!done) return refuse("The monitor cannot do this now: " + done.error().message + ".");
  if (!fields.ok()) refuse(fields.objection());
}

void Hub::Client::receive_binary(std::span<const std::uint8_t> bytes) {
  ServiceCall request;
  if (read_service_call(bytes, request))
    call(request);
  else
    refuse("A binary message must be a service call.");
}

void Hub::Client::subscribe(RequestFields& request) {
  std::string first;
  std::size_t refused = 0;
  for (const auto& item : request.list("subscriptions")) {
    const auto id = id_of(item, "id");
    const auto channel_id = id_of(item, "channelId");
    Result<void> done =
        Error{"A subscription must have a number \"id\" and a number \"channelId\"."};
    if (id && channel_id) done = subscribe_one(*id, *channel_id);
    if (!done && ++refused == 1) first = done.error().message;
  }
  tell_first(StatusLevel::kError, first, refused);
}

Result<void> Hub::Client::subscribe_one(std::uint32_t subscription_id, std::uint32_t channel_id) {
  Topic* topic = hub_.find(channel_id);
  if (!topic) return Error{"There is no channel " + std::to_string(channel_id) + "."};
  if (channel_of_.size() >= hub_.limits_.subscriptions) {
    hub_.limit_counts_->reached(Limit::kSubscriptions);
    return Error{"A client has at most " + std::to_string(hub_.limits_.subscriptions) +
                 " subscriptions."};
  }
  if (subscriptions_to_[channel_id] >= hub_.limits_.subscriptions_of_channel) {
    hub_.limit_counts_->reached(Limit::kSubscriptions);
    return Error{"A client has at most " + std::to_string(hub_.limits_.subscriptions_of_channel) +
                 " subscriptions to one channel."};
  }
  if (!channel_of_.emplace(subscription_id, channel_id).second)
    return Error{"Subscription id " + std::to_string(subscription_id) + " is in use already."};
  ++subscriptions_to_[channel_id];
  topic->subscribers.emplace(this, subscription_id);
  if (topic->subscribers.size() == 1 && hub_.demand_) hub_.demand_(channel_id, true);
  for (const auto& message : topic->kept) deliver(subscription_id, message);
  return {};
}

void Hub::Client::unsubscribe(RequestFields& request) {
  std::string first;
  std::size_t unknown = 0;
  for (const auto& item : request.list("subscriptionIds")) {
    const auto id = id_of(item);
    if (id && channel_of_.contains(*id))
      unsubscribe_one(*id);
    else if (++unknown == 1)
      first = "There is no subscription " + json_text(item) + ".";
  }
  tell_first(StatusLevel::kWarning, first, unknown);
}

void Hub::Client::unsubscribe_one(std::uint32_t subscription_id) {
  const auto channel_id = channel_of_.at(subscription_id);
  channel_of_.erase(subscription_id);
  --subscriptions_to_[channel_id];
  outbox_->close_lane(subscription_id);
  auto& subscribers = hub_.find(channel_id)->subscribers;
  subscribers.erase({this, subscription_id});
  if (subscribers.empty() && hub_.demand_) hub_.demand_(channel_id, false);
}

void Hub::Client::tell_first(StatusLevel level, const std::string& first, std::size_t count) {
  if (count == 0) return;
  const auto more =
      count == 1 ? "" : " The same request has " + std::to_string(count - 1) + " more such faults.";
  tell(status(level, first + more));
}

void Hub::Client::call(const ServiceCall& call) {
  const auto service_id = call.service_id;
  const auto call_id = call.call_id;
  if (service_id == 0 || service_id > hub_.handlers_.size())
    return answer(service_id, call_id,
                  Error{"There is no service " + std::to_string(service_id) + "."});
  if (!may_call_) return answer(service_id, call_id, Error{missing_right(Right::kOperate)});
  if (call.encoding != "json")
    return answer(service_id, call_id, Error{"A service call must be encoded as json."});
  if (*waiting_calls_ >= hub_.limits_.waiting_calls) {
    hub_.limit_counts_->reached(Limit::kCalls);
    return answer(service_id, call_id,
                  Error{"More service calls wait for an answer than the monitor keeps; wait for "
                        "one."});
  }
  const auto request = read_untrusted_json(call.request, hub_.limits_.program);
  if (!request) return answer(service_id, call_id, request.error());
  const auto once =
      [this, alive = alive_, service_id, call_id,
       open = std::make_shared<OpenCall>(waiting_calls_)](const Result<nlohmann::json>& result) {
        if (*alive && !std::exchange(open->is_answered, true)) answer(service_id, call_id, result);
      };
  hub_.caller_ = who_;
  const auto called =
      guarded("a service call", [&] { hub_.handlers_[service_id - 1](request.value(), once); });
  if (!called) once(Error{"The monitor cannot do this now: " + called.error().message + "."});
}

void Hub::Client::answer(std::uint32_t service_id, std::uint32_t call_id,
                         const Result<nlohmann::json>& result) {
  if (result)
    return push(service_response_frame(service_id, call_id, "json", json_text(result.value())));
  const auto& why = result.error().message;
  tell(service_failure(service_id, call_id, why));
  refuse(why);  // because Lichtblick 1.28 does not show a service call's failure
}

void Hub::Client::deliver(std::uint32_t subscription_id, const Message& message) {
  const auto depth = lane_depth(message.channel.delivery);
  if (depth == 0) return push(message_frame(subscription_id, message));
  if (dismissed_) return;
  ++hub_.past_.frames;
  outbox_->offer(subscription_id, message_frame(subscription_id, message), depth);
  link_.flush();
}

void Hub::Client::push(Frame frame) {
  if (dismissed_) return;
  ++hub_.past_.frames;
  *hub_.queued_bytes_ += frame.kept_size();
  if (outbox_->push(std::move(frame))) {
    link_.flush();
  } else {
    hub_.limit_counts_->reached(Limit::kWaitingEvents);
    dismiss();
  }
  hub_.bound_queues();
}

void Hub::Client::dismiss() {
  dismissed_ = true;
  ++hub_.past_.dismissed;
  outbox_->clear();
  link_.close("too slow: more events waited for this client than the server keeps");
}

}  // namespace galilean::monitor::foxglove
