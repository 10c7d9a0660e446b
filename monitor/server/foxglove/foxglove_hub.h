// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/server/foxglove/foxglove_messages.h"
#include "monitor/server/websocket/outbox.h"

namespace galilean::monitor {
class RequestFields;
}

namespace galilean::monitor::foxglove {

/// The connection to one client, as the hub uses it.
class Link {
 public:
  virtual ~Link() = default;
  /// Called when something waits in the client's outbox.
  virtual void flush() = 0;
  /// Closes the connection; nothing more is sent.
  /// Requires: `reason` has at most 123 bytes.
  virtual void close(const std::string& reason) = 0;
};

/// Fans the team's messages out to clients of Foxglove's protocol, ws-protocol version 1, and takes
/// their service calls. A new subscriber to a *state* gets the newest message at once, one to an
/// *event* the last 64, as a late joiner on DDS does.
///
/// For use by one thread. The hub knows no sockets: the owner of a socket opens a Client for it.
class Hub {
 public:
  class Client;
  using Answer = std::function<void(Result<nlohmann::json>)>;
  using Handler = std::function<void(const nlohmann::json& request, Answer answer)>;
  /// Called when the first client wants a channel's messages and when the last one ceases to.
  using Demand = std::function<void(std::uint32_t channel_id, bool wanted)>;

  /// Takes a parameter's new value, and answers when that was ordered, or why it is refused.
  using SetParameter = std::function<void(const Parameter& wanted, Answer answer)>;

  Hub(std::string server_name, Demand demand);
  ~Hub();

  void add_service(Service service, Handler handler);
  /// `channel` must outlive the hub.
  void add_channel(const Channel& channel);
  void send(const Message& message);
  void send_time(std::int64_t since_epoch_ns);
  void on_set_parameter(SetParameter set) { set_parameter_ = std::move(set); }
  /// Takes the parameters' present values, and sends each client those that changed and that it
  /// watches.
  void send_parameters(ParameterValues now);
  /// Sends the connection graph; the hub adds the services to it.
  void send_graph(ConnectionGraph now);
  [[nodiscard]] bool graph_is_watched() const;
  /// Calls Demand no more. Needed where clients outlive the object that Demand calls.
  void forget_demand() { demand_ = nullptr; }

  /// Returns a client that is served until it is destroyed. `may_call`: it may call services.
  [[nodiscard]] std::unique_ptr<Client> connect(Link& link, bool may_call);

  struct Counts {
    std::size_t clients = 0;
    std::size_t subscriptions = 0;
    std::uint64_t frames = 0;      ///< handed to clients' outboxes
    std::uint64_t superseded = 0;  ///< left out because a newer one came before they were sent
    std::uint64_t dismissed = 0;   ///< clients closed for being too slow
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Subscriber {
    Client* client;
    std::uint32_t subscription_id;
  };
  struct Topic {
    const Channel* channel;
    std::vector<Subscriber> subscribers;
    std::deque<Message> kept;  ///< for clients that subscribe later
  };

  [[nodiscard]] Topic* find(std::uint32_t channel_id);

  std::string server_name_;
  std::string session_id_;
  Demand demand_;
  std::vector<Service> services_;
  std::vector<Handler> handlers_;
  std::map<std::uint32_t, Topic> topics_;
  ParameterValues parameters_;
  SetParameter set_parameter_;
  ConnectionGraph graph_;
  std::vector<Client*> clients_;
  Counts past_;
};

/// One connected client and what it subscribed to.
class Hub::Client {
 public:
  Client(Hub& hub, Link& link, bool may_call);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Handles a message from the client, which came as text or as binary message.
  void receive_text(std::string_view text);
  void receive_binary(std::span<const std::uint8_t> bytes);
  [[nodiscard]] Outbox& outbox() noexcept { return *outbox_; }
  /// Returns the outbox for the code that sends from it. It expires with the client.
  [[nodiscard]] std::weak_ptr<Outbox> outbox_while_connected() const noexcept { return outbox_; }

 private:
  friend class Hub;
  /// The operations by the "op" of a client's message. The client hears of errors in a request when
  /// the operation returns.
  static const std::map<std::string, void (*)(Client&, RequestFields& request)> kOperations;

  void subscribe(RequestFields& request);
  void subscribe_one(std::uint32_t subscription_id, std::uint32_t channel_id);
  void unsubscribe(RequestFields& request);
  void unsubscribe_one(std::uint32_t subscription_id);
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
  void tell(const std::string& text) { push(text_frame(text)); }
  void refuse(const std::string& why) { tell(status(StatusLevel::kError, why)); }

  Hub& hub_;
  Link& link_;
  bool may_call_;
  std::shared_ptr<Outbox> outbox_ = std::make_shared<Outbox>();
  bool dismissed_ = false;
  std::map<std::uint32_t, std::uint32_t> channel_of_;  ///< by subscription id
  std::set<std::string> watched_parameters_;
  bool watches_graph_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< for answers that come late
};

}  // namespace galilean::monitor::foxglove
