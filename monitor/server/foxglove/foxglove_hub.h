// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "monitor/access/operator_id.h"
#include "monitor/server/foxglove/foxglove_messages.h"
#include "monitor/server/limits/limit_counts.h"
#include "monitor/server/limits/server_limits.h"
#include "monitor/server/websocket/outbox.h"

namespace galilean::monitor {
class RequestFields;
}

namespace galilean::monitor::foxglove {

/// The connection to one client, as the hub uses it.
class Link {
 public:
  virtual ~Link() = default;
  /// Called when a frame waits in the client's outbox.
  virtual void flush() = 0;
  /// Closes the connection; nothing more is sent.
  /// Requires: `reason` has at most 123 bytes.
  virtual void close(const std::string& reason) = 0;
};

/// Fans the team's messages out to clients of Foxglove's protocol, ws-protocol version 1, and takes
/// their service calls. A new subscriber to a *state* gets the newest message at once. One to an
/// *event* gets the last 64, as a late joiner on DDS does.
///
/// For use by one thread. The hub knows no sockets: a socket's session opens a Client with
/// `connect`.
class Hub {
 public:
  class Client;
  using Answer = std::function<void(Result<nlohmann::json>)>;
  using Handler = std::function<void(const nlohmann::json& request, Answer answer)>;
  /// Called when a channel gets its first subscriber and when it loses its last one.
  using Demand = std::function<void(std::uint32_t channel_id, bool wanted)>;

  /// Orders a parameter's new value. The answer says that it was ordered, or why it is refused.
  using SetParameter = std::function<void(const Parameter& wanted, Answer answer)>;

  Hub(std::string server_name, Demand demand);
  ~Hub();

  /// Requires: no client is connected yet, because only new clients hear of services.
  void add_service(Service service, Handler handler);
  /// Announces a channel to all clients.
  /// Requires: `channel` outlives the hub.
  void add_channel(const Channel& channel);
  /// Sends a message to the channel's subscribers. Ignores messages of channels that were not
  /// added.
  void send(const Message& message);
  /// Sends the time to all clients. A newer time replaces one that still waits for a slow client.
  void send_time(std::int64_t since_epoch_ns);
  void on_set_parameter(SetParameter set) { set_parameter_ = std::move(set); }
  /// Takes the parameters' present values. Sends each client those that changed since the last call
  /// and that it subscribed to.
  void send_parameters(ParameterValues now);
  /// Sends the graph's changes to the clients that subscribed to it. The hub adds its services.
  void send_graph(ConnectionGraph now);
  [[nodiscard]] bool graph_is_watched() const;
  /// Sets what each client may ask for.
  void limit(const ServerLimits& limits) { limits_ = limits; }
  /// Returns what counts the limits that clients reach.
  [[nodiscard]] const std::shared_ptr<LimitCounts>& limit_counts() const noexcept {
    return limit_counts_;
  }
  /// Stops calling Demand. Call it if clients outlive the object that Demand uses.
  void forget_demand() { demand_ = nullptr; }

  /// Returns a client that is served until it is destroyed. `may_call` says whether it may call
  /// services and set parameters, and `who` does that then.
  /// Requires: `link` and the hub outlive the client.
  [[nodiscard]] std::unique_ptr<Client> connect(Link& link, bool may_call, OperatorId who = {});
  /// Returns who calls the service or sets the parameter.
  /// Requires: a Handler or SetParameter is being called.
  [[nodiscard]] const OperatorId& caller() const noexcept { return caller_; }

  struct Counts {
    std::size_t clients = 0;
    std::size_t subscriptions = 0;
    std::uint64_t frames = 0;      ///< frames put into clients' outboxes, without the time
    std::uint64_t superseded = 0;  ///< frames not sent because a newer one came first
    std::uint64_t dismissed = 0;   ///< clients that were closed because they were too slow
  };
  [[nodiscard]] Counts counts() const;

 private:
  using Subscriber = std::pair<Client*, std::uint32_t>;  ///< with the subscription's id
  struct Topic {
    const Channel* channel;
    std::set<Subscriber> subscribers;  ///< in order, so that one of very many is found at once
    std::deque<Message> kept;          ///< sent to clients that subscribe later
  };

  [[nodiscard]] Topic* find(std::uint32_t channel_id);
  /// Dismisses those clients for which most waits, until not too much waits for all of them.
  void bound_queues();
  /// Returns what announces all channels. It is made once for all clients.
  [[nodiscard]] const Frame& advertisement();

  std::string server_name_;
  std::string session_id_;
  Demand demand_;
  std::vector<Service> services_;
  std::vector<Handler> handlers_;
  std::map<std::uint32_t, Topic> topics_;
  Frame advertisement_;  ///< without a payload: a channel came since it was made
  /// What waits in all clients' queues [bytes].
  std::shared_ptr<std::size_t> queued_bytes_ = std::make_shared<std::size_t>(0);
  ParameterValues parameters_;
  SetParameter set_parameter_;
  OperatorId caller_;
  ConnectionGraph graph_;
  std::vector<Client*> clients_;
  ServerLimits limits_;
  std::shared_ptr<LimitCounts> limit_counts_ = std::make_shared<LimitCounts>();
  Counts past_;
};

/// One connected client and its subscriptions.
class Hub::Client {
 public:
  Client(Hub& hub, Link& link, bool may_call, OperatorId who);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Handles one message from the client. An error in it is answered with a status message.
  void receive_text(std::string_view text);
  void receive_binary(std::span<const std::uint8_t> bytes);
  [[nodiscard]] Outbox& outbox() noexcept { return *outbox_; }
  /// Returns the outbox for the socket that sends from it. The pointer expires with the client.
  [[nodiscard]] std::weak_ptr<Outbox> outbox_while_connected() const noexcept { return outbox_; }

 private:
  friend class Hub;
  /// The operations by "op" of a client's message. `receive_text` tells the client the request's
  /// objection after the operation returns.
  static const std::map<std::string, void (*)(Client&, RequestFields& request)> kOperations;

  void subscribe(RequestFields& request);
  /// Errors: there is no such channel, the id is in use, or it has as many as it may, in all or of
  /// the channel.
  [[nodiscard]] Result<void> subscribe_one(std::uint32_t subscription_id, std::uint32_t channel_id);
  void unsubscribe(RequestFields& request);
  void unsubscribe_one(std::uint32_t subscription_id);
  /// Tells the first of what is wrong with the items of one request, and how many more there are.
  void tell_first(StatusLevel level, const std::string& first, std::size_t count);
  void get_parameters(RequestFields& request);
  void set_parameters(RequestFields& request);
  void set_parameter(const Parameter& wanted);
  void watch_parameters(RequestFields& request, bool wanted);
  void tell_parameters(const ParameterValues& changed);
  void watch_graph(bool wanted);
  void call(const ServiceCall& call);
  void answer(std::uint32_t service_id, std::uint32_t call_id,
              const Result<nlohmann::json>& result);
  void deliver(std::uint32_t subscription_id, const Message& message);
  void push(Frame frame);
  /// Drops what waits for the client, and closes its connection.
  void dismiss();
  void tell(const std::string& text) { push(text_frame(text)); }
  void refuse(const std::string& why) { tell(status(StatusLevel::kError, why)); }

  Hub& hub_;
  Link& link_;
  bool may_call_;
  OperatorId who_;
  std::shared_ptr<Outbox> outbox_ = std::make_shared<Outbox>();
  bool dismissed_ = false;
  std::map<std::uint32_t, std::uint32_t> channel_of_;      ///< by subscription id
  std::map<std::uint32_t, std::size_t> subscriptions_to_;  ///< how many, by channel id
  std::set<std::string> watched_parameters_;
  bool watches_graph_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< late answers find it false
  /// How many service calls have no answer yet.
  std::shared_ptr<std::size_t> waiting_calls_ = std::make_shared<std::size_t>(0);
};

}  // namespace galilean::monitor::foxglove
