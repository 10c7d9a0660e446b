// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/monitor.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <iostream>
#include <new>
#include <optional>
#include <system_error>

#include "bhdl/program/catalog_file.h"
#include "core/installation.h"
#include "core/visible_text.h"
#include "core/wire/refusals.h"
#include "core/wire/ros_time.h"
#include "monitor/access/operator_key.h"
#include "monitor/access/token_watch.h"
#include "monitor/background/end_watch.h"
#include "monitor/background/guarded.h"
#include "monitor/ingest/ingest.h"
#include "monitor/pushes/history/history_folder.h"
#include "monitor/recordings/upload.h"
#include "monitor/server/api/api.h"
#include "monitor/server/api/lease_json.h"
#include "monitor/server/api/lease_teller.h"
#include "monitor/server/api/team_parameters.h"
#include "monitor/server/foxglove/domain_graph.h"
#include "monitor/server/limits/descriptors.h"
#include "monitor/server/limits/server_limits.h"
#include "monitor/server/map_teller.h"
#include "monitor/tls/certificate_watch.h"

namespace galilean::monitor {
namespace {
namespace asio = boost::asio;

constexpr auto kTellPeriod = std::chrono::milliseconds(100);
/// A socket whose token was revoked is closed within one period, and cut within two.
constexpr auto kTokenPeriod = std::chrono::milliseconds(400);

/// Returns an empty catalog if the file cannot be read, because robots publish catalogs of their
/// own.
Catalog catalog_or_none(const std::filesystem::path& file) {
  auto catalog = bhdl::load_catalog(file.empty() ? bhdl::default_catalog_path() : file);
  if (catalog) return std::move(catalog).value();
  std::clog << "galilean-monitor: " << catalog.error().message << std::endl;
  return {};
}

std::filesystem::path library_folder(const MonitorOptions& options) {
  return options.library_folder.empty() ? default_library_folder() : options.library_folder;
}

/// Says where another history is if this one is only begun.
Result<std::unique_ptr<History>> open_history(const MonitorOptions& options, std::uint32_t domain) {
  const auto usual = options.data_folder / kHistoryFile;
  const auto file =
      options.shares_data_folder ? history_file(options.data_folder, domain, options.port) : usual;
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown) && std::filesystem::exists(usual, unknown))
    std::clog << "galilean-monitor: the history of pushes in this domain and on this port begins "
              << "in " << file.string() << "; another one is in " << usual.string()
              << " and is shown with --data " << options.data_folder.string() << std::endl;
  return History::open(file);
}

std::filesystem::path recordings_folder(const MonitorOptions& options) {
  return options.recordings_folder.empty() ? options.data_folder / "recordings"
                                           : options.recordings_folder;
}

/// Returns the limits where so many file descriptors may be open. A connection with TLS takes two
/// more than one without: the ends of the pair between its relay and its session.
ServerLimits limits_for(std::size_t descriptors, bool tls) {
  const std::size_t each = tls ? 3 : 1;
  ServerLimits limits;
  if (tls) limits.reserved_connections /= each;
  const auto left = (descriptors - kOwnDescriptors) / each - limits.reserved_connections;
  limits.connections = std::min(limits.connections, left);
  return limits;
}

template <class M, class Take>
void decode_for(const Message& message, Take take) {
  if (message.channel.schema->ros_type != M::kRosType) return;
  M decoded;
  if (msg::decode_cdr(*message.cdr, decoded)) take(decoded);
}

/// Decodes an answer to a push. One that fills a gap says so wherever its words are kept or shown.
template <class Take>
void decode_reply_for(const Message& message, Take take) {
  decode_for<msg::ProgramReply>(message, [&](msg::ProgramReply& reply) {
    if (message.filled)
      reply.message += reply.message.empty() ? "filled after a gap" : " (filled after a gap)";
    take(reply);
  });
}

}  // namespace

// The members are destroyed in the reverse order. The io_context destroys the sessions, and these
// use the hub, so the hub must stand before it.
struct Monitor::Parts {
  std::optional<EndWatch> end_watch;  ///< the last to go, since the end of the others may hang
  ServerLimits limits;
  std::unique_ptr<wire::Participant> participant;
  std::unique_ptr<History> history;
  SteadyClock clock;
  Team team;
  ProgramLibrary library;
  PageFiles page;
  foxglove::Hub hub;
  RecordingFolder recordings;
  RecordingList recording_list{recordings};
  Playbacks playbacks;
  ReplayContext replay{recordings, playbacks};
  asio::io_context io{1};
  asio::steady_timer tell_timer{io};
  asio::steady_timer token_timer{io};
  TokenWatch token_watch;
  SendRounds rounds{io};
  Worker worker{io};
  Worker telling_worker{io};  ///< tells on DDS how things stand, and so never waits for a disk
  Worker language_worker{io};
  Worker recording_worker{io, 1, limits.waiting_recordings};
  Worker transfer_worker{io};
  Worker coverage_worker{io, 1, limits.waiting_coverages};
  /// Stop, hold and the other commands. It has no other jobs, so that nothing delays them.
  Worker command_worker{io, 1, limits.waiting_commands};
  /// What operators push, so that nobody without a token keeps it waiting.
  Worker push_checks{io, 1, limits.waiting_checks};
  Worker checks{io, limits.check_threads, limits.waiting_checks, Worker::Priority::kLow};
  CoverageDesk coverage{recordings, coverage_worker};
  LanguageServerContext language;
  MapService map;
  TrialRoom trials;
  PushDesk desk;
  LeaseDesk leases{clock};
  LeaseTeller lease_teller;
  MapTeller map_teller;
  SimulationDesk simulations;
  OrderLog orders;
  HistoryWatch history_watch;
  Operations operations;
  Api api;
  HttpServer server;
  Ingest ingest;
  wire::Graph graph;
  Time graph_due{};  ///< when the graph may be told again
  std::uint16_t port = 0;
  std::string new_operator_token;
  std::string fingerprint;
  std::optional<CertificateWatch> certificates;  ///< of TLS

  Parts(const MonitorOptions& options, const ServerLimits& limits,
        std::unique_ptr<wire::Participant> joined, std::unique_ptr<History> opened,
        const Tokens& tokens, const std::shared_ptr<OrderSigner>& signer);
  ~Parts() {
    end_watch->forget();
    playbacks.finish();
    checks.drop_waiting();
    push_checks.drop_waiting();
    coverage.stop();
    coverage_worker.finish();
    recording_worker.finish();
    transfer_worker.finish();
    telling_worker.finish();
    worker.finish();
    command_worker.finish();
    checks.finish();
    push_checks.finish();
    language_worker.finish();
    hub.forget_demand();
  }

  [[nodiscard]] Ingest::Callbacks callbacks();
  void receive(const Message& message);
  void forget(const std::string& robot);
  [[nodiscard]] Result<void> begin_tls(const MonitorOptions& options);
  void keep_order(const Message& message);
  void tell_regularly();
  [[nodiscard]] Result<void> open_door(const CertificateFiles& files);
  void look_at_certificate();
  void look_at_tokens();
  void look_at_tokens_regularly();
  void tell_graph();
};

Monitor::Parts::Parts(const MonitorOptions& options, const ServerLimits& bounds,
                      std::unique_ptr<wire::Participant> joined, std::unique_ptr<History> opened,
                      const Tokens& tokens, const std::shared_ptr<OrderSigner>& signer)
    : limits(bounds),
      participant(std::move(joined)),
      history(std::move(opened)),
      team(clock, options.map.silent_after),
      library(library_folder(options), catalog_or_none(options.catalog_file)),
      page(options.page_folder.empty() ? default_page_folder() : options.page_folder),
      hub("galilean-monitor",
          [this](std::uint32_t channel_id, bool wanted) { ingest.want(channel_id, wanted); }),
      recordings(recordings_folder(options)),
      token_watch(named_tokens_file(options.data_folder)),
      language{language_worker, team, library.catalog(), library_folder(options)},
      map(*participant, clock, options.map),
      trials(io, team,
             options.simulator.empty() ? program_folder() / "galilean-sim" : options.simulator,
             options.data_folder / "trials"),
      desk({io, worker, push_checks, team, library, *history, trials, signer}, clock, *participant),
      lease_teller(leases, telling_worker, *participant),
      map_teller(map, telling_worker, clock, *participant),
      simulations(io, worker, clock, *participant),
      orders({io, worker, team, *history, clock, participant->refusals()}),
      history_watch({io, worker, telling_worker, *history, clock}, *participant),
      operations({command_worker, checks, team, library, desk, leases, orders, *hub.limit_counts()},
                 *participant, signer),
      api({page,
           team,
           library,
           map,
           hub,
           operations,
           leases,
           desk,
           simulations,
           worker,
           checks,
           push_checks,
           *history,
           history_watch,
           {recordings, recording_list, recording_worker, coverage},
           *hub.limit_counts(),
           limits}),
      server(io, {Guard(options.address, options.allowed_origins, options.tls ? "https" : "http"),
                  Access(tokens, is_loopback(options.address)),
                  [this](const HttpRequest& request, const Respond& respond) {
                    api.answer(request, respond);
                  },
                  hub, rounds, language, replay, transfer_worker,
                  [this](const std::string& path) { return api.most_body_bytes(path); }, limits}),
      ingest(*participant, callbacks(), [this] { asio::post(io, [this] { ingest.poll(); }); }),
      graph(*participant) {
  hub.limit(limits);
  operations.offer(hub);
  api.set_counts([this] { return server.counts(); });
  api.set_intake([this] { return ingest.intake(); });
  hub.on_set_parameter([this](const auto& wanted, auto answer) {
    set_team_parameter(operations, wanted, hub.caller(), std::move(answer));
  });
  recording_worker.run([this] { remove_abandoned_uploads(recordings); });
  tell_regularly();
  look_at_tokens_regularly();
  end_watch.emplace([this] { io.stop(); });
}

Ingest::Callbacks Monitor::Parts::callbacks() {
  // An exception from one topic or message must not keep the next ones from being handled.
  return {
      [this](const Channel& channel) {
        (void)guarded(channel.topic, [&] { hub.add_channel(channel); });
      },
      [this](const Message& message) {
        (void)guarded(message.channel.topic, [&] { receive(message); });
      },
      [](const std::string& problem) { std::clog << "galilean-monitor: " << problem << std::endl; },
      [this](const std::string& robot) { (void)guarded(robot, [&] { forget(robot); }); }};
}

void Monitor::Parts::receive(const Message& message) {
  hub.send(message);  // first, because a viewer waits for it
  team.receive(message);
  map.receive(message);
  trials.receive(message);
  decode_reply_for(message, [this](const auto& reply) { desk.note(reply); });
  decode_for<msg::ProgramPush>(message, [this](const auto& push) { desk.note(push); });
  decode_for<msg::SimulationState>(message, [this](const auto& state) { simulations.note(state); });
  decode_for<msg::SimulationEvent>(message, [this](const auto& event) { simulations.note(event); });
  if (!message.replayed) keep_order(message);
}

/// Keeps an order, or what became of one, whoever gave it: through this monitor or past it.
void Monitor::Parts::keep_order(const Message& message) {
  const auto note = [this](const auto& told) { orders.note(told); };
  decode_for<msg::Command>(message, note);
  decode_for<msg::BreakOrder>(message, note);
  decode_for<msg::ProgramRollback>(message, note);
  decode_for<msg::SimulationOrder>(message, note);
  decode_for<msg::Breaks>(message, note);
  decode_reply_for(message, note);
  decode_for<msg::SimulationEvent>(message, note);
}

void Monitor::Parts::forget(const std::string& robot) {
  std::clog
      << "galilean-monitor: " << visible(robot)
      << " is forgotten: it was silent for more than an hour, and another robot needs its place"
      << std::endl;
  team.forget(robot);
  map.forget(robot);
  leases.forget(robot);
}

void Monitor::Parts::tell_regularly() {
  (void)guarded("telling the clients", [this] {
    hub.send_time(wire::wall_clock_ns());
    lease_teller.tell();
    map_teller.tell();
    auto parameters = team_parameters(team, leases);
    parameters["/team.history_problem"] = history_watch.problem();
    parameters["/team.map_problem"] = map.watch().problem();
    hub.send_parameters(std::move(parameters));
    tell_graph();
  });
  tell_timer.expires_after(kTellPeriod);
  tell_timer.async_wait([this](boost::system::error_code error) {
    if (!error) tell_regularly();
  });
}

Result<void> Monitor::Parts::begin_tls(const MonitorOptions& options) {
  auto files = options.certificate;
  if (files.certificate.empty()) {
    files = own_certificate(options.data_folder);
    if (auto made = ensure_own_certificate(files); !made) return made;
  }
  // Before the files are read: what changes meanwhile is seen at the next look.
  certificates.emplace(files);
  return open_door(files);
}

Result<void> Monitor::Parts::open_door(const CertificateFiles& files) {
  auto door = TlsDoor::open(files);
  if (!door) return door.error();
  auto read = fingerprint_of(files.certificate);
  if (!read) return read.error();
  fingerprint = std::move(read).value();
  if (const auto why = door.value()->objection(); !why.empty())
    std::clog << "galilean-monitor: " << files.certificate.string() << ": " << why << std::endl;
  server.use_tls(std::move(door).value());
  return {};
}

void Monitor::Parts::look_at_certificate() {
  if (!certificates || !certificates->is_renewed()) return;
  const auto opened = open_door(certificates->files());
  std::clog << "galilean-monitor: "
            << (opened ? "a new certificate is served from now on; its SHA-256 fingerprint: " +
                             fingerprint
                       : opened.error().message + "; the certificate of before is served still")
            << std::endl;
}

void Monitor::Parts::look_at_tokens() {
  const auto changed = token_watch.look();
  if (!changed) return;
  if (*changed) return server.set_named_tokens(changed->value());
  // Nobody can say which of them are still meant to be valid. The operator's own file is.
  server.set_named_tokens({});
  std::clog << "galilean-monitor: " << changed->error().message
            << "; until then no named token gives a right" << std::endl;
}

void Monitor::Parts::look_at_tokens_regularly() {
  (void)guarded("looking at the tokens", [this] {
    look_at_tokens();
    server.end_withdrawn();
  });
  (void)guarded("looking at the certificate", [this] { look_at_certificate(); });
  token_timer.expires_after(kTokenPeriod);
  token_timer.async_wait([this](boost::system::error_code error) {
    if (!error) look_at_tokens_regularly();
  });
}

// A domain of countless endpoints makes the graph dear. It takes no more than a tenth of the time.
void Monitor::Parts::tell_graph() {
  constexpr int kRestFor = 9;
  const Time began = clock.now();
  if (!hub.graph_is_watched() || began < graph_due) return;
  hub.send_graph(connection_graph(graph.topics()));
  const Time ended = clock.now();
  graph_due = ended + kRestFor * (ended - began);
}

Result<std::unique_ptr<Monitor>> Monitor::make(const MonitorOptions& options) try {
  // This comes first, because DDS fails where it cannot say so if it has too few.
  const auto descriptors = raise_descriptor_limit();
  if (!descriptors) return descriptors.error();
  auto tokens = open_tokens(options.data_folder);
  if (!tokens) return tokens.error();
  auto key = open_operator_key(options.data_folder);
  if (!key) return key.error();
  auto participant = wire::Participant::join(wire::kMonitorName, options.domain);
  if (!participant) return participant.error();
  auto history = open_history(options, participant.value()->domain());
  if (!history) return history.error();
  participant.value()->refusals().tell_with([](const std::string& sentence) {
    std::clog << "galilean-monitor: " + sentence + "\n" << std::flush;
  });
  auto blocks = std::make_unique<Parts>(
      options, limits_for(descriptors.value(), options.tls), std::move(participant).value(),
      std::move(history).value(), tokens.value(),
      signer_of(std::move(key).value(), operator_key_file(options.data_folder)));
  if (tokens.value().are_new) blocks->new_operator_token = tokens.value().operator_;
  if (options.tls)
    if (const auto begun = blocks->begin_tls(options); !begun) return begun.error();
  const auto port = blocks->server.listen(options.address, options.port);
  if (!port) return port.error();
  blocks->port = port.value();
  return std::unique_ptr<Monitor>(new Monitor(std::move(blocks)));
} catch (const std::bad_alloc&) {
  return Error{"no memory is left to start with; see 'ulimit -v' and what else runs here"};
} catch (const std::system_error& error) {
  return Error{std::string("the system gives it no thread or no file: ") + error.what() +
               "; see 'ulimit -a'"};
} catch (const std::exception& error) {
  return Error{std::string("DDS cannot be used: ") + error.what()};
}

Monitor::Monitor(std::unique_ptr<Parts> blocks) : parts_(std::move(blocks)) {}
Monitor::~Monitor() = default;

std::uint16_t Monitor::port() const noexcept {
  return parts_->port;
}

std::string Monitor::new_operator_token() const {
  return parts_->new_operator_token;
}

std::string Monitor::fingerprint() const {
  return parts_->fingerprint;
}

void Monitor::run() {
  // An exception that comes this far has ended its handler. The others go on.
  while (!parts_->io.stopped()) (void)guarded("a handler", [this] { parts_->io.run(); });
}

void Monitor::stop() {
  parts_->io.stop();
}

}  // namespace galilean::monitor
