// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/replay_session.h"

#include <boost/asio/post.hpp>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/cut_text.h"
#include "core/json_text.h"
#include "monitor/background/guarded.h"
#include "monitor/server/foxglove/foxglove_messages.h"
#include "monitor/server/foxglove/ids.h"
#include "monitor/server/foxglove/subprotocol.h"
#include "monitor/server/limits/server_limits.h"
#include "monitor/server/replay/viewer_playback.h"
#include "monitor/server/text/request_fields.h"
#include "monitor/server/text/url_text.h"

namespace galilean::monitor {
namespace {

using boost::system::error_code;

constexpr std::size_t kMostOrderBytes = std::size_t{512} << 10;
constexpr std::uint32_t kTimeLane = 0;
/// What a close frame can hold besides its code.
constexpr std::size_t kLongestReason = 123;

/// Reads a number of seconds; an empty text is 0.
Result<Duration> read_seconds(const std::string& text) {
  if (text.empty()) return Duration{};
  constexpr double kLongest_s = 1e9;
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !std::isfinite(seconds) || seconds < 0 || seconds > kLongest_s)
    return Error{"'at' must be a number of seconds since the recording's start."};
  return from_seconds(seconds);
}

class ReplaySession final : public Revocable, public std::enable_shared_from_this<ReplaySession> {
 public:
  ReplaySession(boost::asio::ip::tcp::socket socket, SendRounds& rounds, ReplayContext& context,
                std::shared_ptr<Connections::Place> place)
      : executor_(socket.get_executor()),
        socket_(std::move(socket), rounds, kMostOrderBytes, std::move(place)),
        context_(context) {}
  ~ReplaySession() override {
    if (line_) line_->leave();
  }

  void start(const WebSocket::Upgrade& upgrade) {
    const auto subprotocol = foxglove::subprotocol_for(upgrade);
    const std::string_view target(upgrade.target().data(), upgrade.target().size());
    name_ = query_value(target, "recording");
    at_ = query_value(target, "at");
    socket_.accept(
        upgrade, subprotocol,
        [self = shared_from_this(), understood = !subprotocol.empty()](error_code error) {
          if (error) return;
          if (understood)
            self->attempt([&] { self->begin(); });
          else
            self->close(CloseCode::kPolicy, foxglove::kNoSubprotocol);
          self->read();
        });
  }

  void revoke(const std::string& reason) override {
    if (line_) line_->leave();
    close(CloseCode::kPolicy, reason);
  }

  void cut() override { socket_.cut(); }

 private:
  /// Runs `work`, and closes the connection if it throws, because it may have been done by half.
  template <class Work>
  void attempt(Work work) {
    if (!guarded("a client of /replay", work))
      close(CloseCode::kInternalError, "the monitor failed; its log says why");
  }

  void begin() {
    const auto at = read_seconds(at_);
    if (!at) return refuse(at.error().message);
    if (name_.empty())
      return refuse("Name a recording: /replay?recording=NAME; /api/recordings lists them.");
    auto line = std::make_shared<PlaybackLine>(
        [executor = executor_, weak = weak_from_this()](ForViewer what) {
          boost::asio::post(executor, [weak, what = std::move(what)]() mutable {
            if (const auto self = weak.lock())
              self->attempt([&] { self->deliver(std::move(what)); });
          });
        });
    outbox_->on_taken([line](std::size_t bytes) { line->taken(bytes); });
    socket_.send_from(outbox_);
    const bool begun = context_.playbacks.begin(
        line, [&folder = context_.folder, name = name_, at = at.value()](PlaybackLine& to) {
          play_to_viewer(folder, name, at, to);
        });
    if (!begun)
      return refuse(std::to_string(Playbacks::kMost) +
                    " replays run already, and no more are possible at once; close one.");
    line_ = std::move(line);
  }

  void deliver(ForViewer what) {
    if (closing_) return;
    if (!what.end_reason.empty()) return refuse(what.end_reason);
    for (auto& frame : what.frames)
      (void)outbox_->push(std::move(frame));  // the line bounds what waits
    if (what.time) outbox_->offer(kTimeLane, std::move(*what.time), 1);
    socket_.flush();
  }

  void read() {
    socket_.read([self = shared_from_this()](error_code error) {
      if (error) return self->end();
      self->socket_.in_turn([self] {
        self->attempt([&] { self->receive(); });
        self->read();
      });
    });
  }

  void receive() {
    if (!line_ || closing_) return;
    const auto message = socket_.message();
    if (socket_.message_is_text())
      receive_text({reinterpret_cast<const char*>(message.data()), message.size()});
    else if (auto request = read_playback_request(message); request)
      order(std::move(request).value());
    else
      object(request.error().message);
  }

  void receive_text(std::string_view text) {
    const auto json = read_untrusted_json(text, ServerLimits().message);
    if (!json) return object(json.error().message);
    RequestFields fields(json.value());
    const auto op = fields.text("op");
    if (op == "subscribe")
      subscribe(fields.list("subscriptions"));
    else if (op == "unsubscribe")
      unsubscribe(fields.list("subscriptionIds"));
    else
      fields.refuse("A replay does not know the operation \"" + std::string(cut_text(op, 40)) +
                    "\".");
    if (!fields.ok()) object(fields.objection());
  }

  void subscribe(const nlohmann::json& subscriptions) {
    for (const auto& item : subscriptions) {
      const auto id = foxglove::id_of(item, "id");
      const auto channel_id = foxglove::id_of(item, "channelId");
      if (id && channel_id)
        order(Subscribe{*id, *channel_id});
      else
        return object("A subscription must have a number \"id\" and a number \"channelId\".");
    }
  }

  void unsubscribe(const nlohmann::json& ids) {
    for (const auto& item : ids) {
      if (const auto id = foxglove::id_of(item))
        order(Unsubscribe{*id});
      else
        return object("A subscription's id must be a number.");
    }
  }

  void order(PlaybackOrder what) {
    if (!line_->order(std::move(what)))
      close(CloseCode::kPolicy, "more orders wait than a replay keeps");
  }

  /// Tells the viewer that a message of it makes no sense.
  void object(const std::string& why) {
    if (!outbox_->push(text_frame(foxglove::status(foxglove::StatusLevel::kError, why))))
      return close(CloseCode::kPolicy, "more answers wait for this client than the server keeps");
    socket_.flush();
  }

  /// Tells the viewer why there is no replay, and closes the connection.
  void refuse(const std::string& why) {
    socket_.send_from({});
    if (std::exchange(closing_, true)) return;
    refusal_ = foxglove::status(foxglove::StatusLevel::kError, why);
    socket_.write(refusal_, [self = shared_from_this(), why](error_code error) {
      if (!error)
        self->socket_.close(CloseCode::kPolicy, std::string(cut_text(why, kLongestReason)),
                            [self](error_code) {});
    });
  }

  void close(CloseCode code, const std::string& reason) {
    socket_.send_from({});
    if (std::exchange(closing_, true)) return;
    socket_.close(code, reason, [self = shared_from_this()](error_code) {});
  }

  /// Lets the playback end now, though a write may keep this session for a while.
  void end() {
    closing_ = true;
    if (line_) line_->leave();
  }

  boost::asio::any_io_executor executor_;
  WebSocket socket_;
  ReplayContext& context_;
  std::string name_, at_, refusal_;
  std::shared_ptr<PlaybackLine> line_;
  std::shared_ptr<Outbox> outbox_ = std::make_shared<Outbox>();
  bool closing_ = false;
};

}  // namespace

std::weak_ptr<Revocable> serve_replay(boost::asio::ip::tcp::socket socket,
                                      const WebSocket::Upgrade& upgrade, SendRounds& rounds,
                                      ReplayContext& context,
                                      std::shared_ptr<Connections::Place> place) {
  const auto session =
      std::make_shared<ReplaySession>(std::move(socket), rounds, context, std::move(place));
  session->start(upgrade);
  return session;
}

}  // namespace galilean::monitor
