// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/lsp/language_session.h"

#include <deque>

#include "bhdl/lsp/server.h"
#include "monitor/server/text/url_text.h"

namespace galilean::monitor {
namespace {

using error_code = boost::system::error_code;

constexpr std::size_t kMostMessageBytes = 32 << 20;
constexpr std::size_t kMostWaiting = 64;  ///< messages that are read but not handled yet
constexpr std::size_t kMostWaitingBytes = std::size_t{4} << 20;  ///< of them, or one longer one
constexpr std::size_t kMostUnsentBytes = 64 << 20;

/// Returns a robot's catalog as JSON, or an empty string if no robot has published one.
std::string catalog_of(const Team& team, const std::string& robot) {
  const Robot* named = team.find(robot);
  if (named != nullptr && named->catalog) return named->catalog->json;
  for (const auto& [name, each] : team.robots())
    if (each.catalog && !team.silent(each)) return each.catalog->json;
  return {};
}

class LanguageSession final : public Revocable,
                              public std::enable_shared_from_this<LanguageSession> {
 public:
  LanguageSession(boost::asio::ip::tcp::socket socket, SendRounds& rounds,
                  LanguageServerContext& context, std::shared_ptr<Connections::Place> place)
      : socket_(std::move(socket), rounds, kMostMessageBytes, std::move(place)),
        context_(context),
        sessions_(context.sessions) {
    ++*sessions_;
  }
  ~LanguageSession() override { --*sessions_; }
  LanguageSession(const LanguageSession&) = delete;
  LanguageSession& operator=(const LanguageSession&) = delete;

  void start(const WebSocket::Upgrade& upgrade) {
    const std::string_view target(upgrade.target().data(), upgrade.target().size());
    socket_.accept(
        upgrade, {},
        [self = shared_from_this(), robot = query_value(target, "robot")](error_code error) {
          if (error) return;
          if (*self->sessions_ > kMostLanguageSessions)
            return self->close(CloseCode::kPolicy,
                               "as many editors are open as the monitor serves; close one");
          self->begin(robot);
        });
  }

  void revoke(const std::string& reason) override { close(CloseCode::kPolicy, reason); }

  void cut() override { socket_.cut(); }

 private:
  /// The result of one job on the worker.
  struct Turn {
    std::vector<std::string> messages;
    bool has_work = false;
    bool over = false;
  };

  void begin(const std::string& robot) {
    run([self = shared_from_this(), json = catalog_of(context_.team, robot)] {
      const auto own = json.empty() ? Result<Catalog>(Error{}) : catalog_from_json(json);
      self->server_ = std::make_unique<bhdl::lsp::Server>(
          own ? own.value() : self->context_.installed,
          std::make_unique<bhdl::lsp::DiskFolder>(self->context_.library_folder));
      return std::vector<std::string>();
    });
    read();
  }

  // Reading pauses while too many messages wait, so that TCP holds the client up.
  void read() {
    reading_ = true;
    socket_.read([self = shared_from_this()](error_code error) {
      self->reading_ = false;
      if (error) return self->end();
      const auto message = self->socket_.message();
      self->waiting_.emplace_back(message.begin(), message.end());
      self->waiting_bytes_ += message.size();
      if (self->has_room()) self->read();
      self->take_turn();
    });
  }

  [[nodiscard]] bool has_room() const {
    return waiting_.size() < kMostWaiting && waiting_bytes_ < kMostWaitingBytes;
  }

  void take_turn() {
    if (busy_ || closed_) return;
    if (!waiting_.empty()) {
      waiting_bytes_ -= waiting_.front().size();
      run([self = shared_from_this(), message = std::move(waiting_.front())] {
        return self->server_->receive(message);
      });
      waiting_.pop_front();
      if (!reading_ && has_room()) read();
    } else if (has_work_) {
      run([self = shared_from_this()] { return self->server_->work(); });
    }
  }

  template <class Job>
  void run(Job job) {
    busy_ = true;
    context_.worker.run(
        [self = shared_from_this(), job = std::move(job)] {
          Turn turn{job()};
          turn.has_work = self->server_->has_work();
          turn.over = self->server_->exit_status().has_value();
          return turn;
        },
        [self = shared_from_this()](Turn turn) { self->finish_turn(std::move(turn)); },
        [self = shared_from_this()](const std::string&) {
          self->close(CloseCode::kInternalError);
        });
  }

  void finish_turn(Turn turn) {
    busy_ = false;
    has_work_ = turn.has_work;
    for (auto& message : turn.messages) send(std::move(message));
    if (turn.over || unsent_bytes_ > kMostUnsentBytes) return close(CloseCode::kNormal);
    take_turn();
  }

  void send(std::string message) {
    if (closed_) return;
    unsent_bytes_ += message.size();
    unsent_.push_back(std::move(message));
    if (unsent_.size() == 1) write();
  }

  void write() {
    socket_.write(unsent_.front(), [self = shared_from_this()](error_code error) {
      if (error) return self->end();
      self->unsent_bytes_ -= self->unsent_.front().size();
      self->unsent_.pop_front();
      if (!self->unsent_.empty()) self->write();
    });
  }

  void close(CloseCode code, const std::string& reason = {}) {
    if (std::exchange(closed_, true)) return;
    socket_.close(code, reason, [self = shared_from_this()](error_code) {});
  }

  void end() {
    closed_ = true;
    waiting_.clear();
    waiting_bytes_ = 0;
  }

  WebSocket socket_;
  LanguageServerContext& context_;
  std::shared_ptr<std::size_t> sessions_;
  std::unique_ptr<bhdl::lsp::Server> server_;  ///< used on the worker only
  std::deque<std::string> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::deque<std::string> unsent_;
  std::size_t unsent_bytes_ = 0;
  bool reading_ = false;
  bool busy_ = false;
  bool has_work_ = false;
  bool closed_ = false;
};

}  // namespace

std::weak_ptr<Revocable> serve_language(boost::asio::ip::tcp::socket socket,
                                        const WebSocket::Upgrade& upgrade, SendRounds& rounds,
                                        LanguageServerContext& context,
                                        std::shared_ptr<Connections::Place> place) {
  const auto session =
      std::make_shared<LanguageSession>(std::move(socket), rounds, context, std::move(place));
  session->start(upgrade);
  return session;
}

}  // namespace galilean::monitor
