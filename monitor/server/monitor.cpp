// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/monitor.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <iostream>

#include "bhdl/program/catalog_file.h"
#include "core/installation.h"
#include "core/wire/ros_time.h"
#include "monitor/background/guarded.h"
#include "monitor/ingest/ingest.h"
#include "monitor/recordings/upload.h"
#include "monitor/server/api/api.h"
#include "monitor/server/api/team_parameters.h"
#include "monitor/server/foxglove/domain_graph.h"
#include "monitor/server/limits/descriptors.h"
#include "monitor/server/limits/server_limits.h"

namespace galilean::monitor {
namespace {
namespace asio = boost::asio;

constexpr auto kTellPeriod = std::chrono::milliseconds(100);

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

std::filesystem::path recordings_folder(const MonitorOptions& options) {
  return options.recordings_folder.empty() ? options.data_folder / "recordings"
                                           : options.recordings_folder;
}

/// Returns the limits where so many file descriptors may be open.
ServerLimits limits_for(std::size_t descriptors) {
  ServerLimits limits;
  const auto left = descriptors - kOwnDescriptors - limits.reserved_connections;
  limits.connections = std::min(limits.connections, left);
  return limits;
}

template <class M, class Take>
void decode_for(const Message& message, Take take) {
  if (message.channel.schema->ros_type != M::kRosType) return;
  M decoded;
  if (msg::decode_cdr(*message.cdr, decoded)) take(decoded);
}

}  // namespace

// The members are destroyed in the reverse order. The io_context destroys the sessions, and these
// use the hub, so the hub must stand before it.
struct Monitor::Parts {
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
  asio::signal_set signals{io, SIGINT, SIGTERM};
  asio::steady_timer tell_timer{io};
  SendRounds rounds{io};
  Worker worker{io};
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
  SimulationDesk simulations;
  Operations operations;
  Api api;
  HttpServer server;
  Ingest ingest;
  wire::Graph graph;
  std::uint16_t port = 0;
  std::string new_operator_token;

  Parts(const MonitorOptions& options, const ServerLimits& limits,
        std::unique_ptr<wire::Participant> joined, std::unique_ptr<History> opened, Tokens tokens);
  ~Parts() {
    playbacks.finish();
    checks.drop_waiting();
    push_checks.drop_waiting();
    coverage.stop();
    coverage_worker.finish();
    recording_worker.finish();
    transfer_worker.finish();
    worker.finish();
    command_worker.finish();
    checks.finish();
    push_checks.finish();
    language_worker.finish();
    hub.forget_demand();
  }

  [[nodiscard]] Ingest::Callbacks callbacks();
  void receive(const Message& message);
  void tell_regularly();
};

Monitor::Parts::Parts(const MonitorOptions& options, const ServerLimits& bounds,
                      std::unique_ptr<wire::Participant> joined, std::unique_ptr<History> opened,
                      Tokens tokens)
    : limits(bounds),
      participant(std::move(joined)),
      history(std::move(opened)),
      team(clock, options.map.silent_after),
      library(library_folder(options), catalog_or_none(options.catalog_file)),
      page(options.page_folder.empty() ? default_page_folder() : options.page_folder),
      hub("galilean-monitor",
          [this](std::uint32_t channel_id, bool wanted) { ingest.want(channel_id, wanted); }),
      recordings(recordings_folder(options)),
      language{language_worker, team, library.catalog(), library_folder(options)},
      map(*participant, clock, options.map),
      trials(io, team,
             options.simulator.empty() ? program_folder() / "galilean-sim" : options.simulator,
             options.data_folder / "trials"),
      desk({io, worker, push_checks, team, library, *history, trials}, clock, *participant),
      simulations(io, worker, clock, *participant),
      operations(command_worker, checks, team, library, desk, *hub.limit_counts(), *participant),
      api({page,
           team,
           library,
           map,
           hub,
           operations,
           desk,
           simulations,
           worker,
           checks,
           push_checks,
           *history,
           {recordings, recording_list, recording_worker, coverage},
           *hub.limit_counts(),
           limits}),
      server(io, {Guard(options.address, options.allowed_origins),
                  Access(std::move(tokens), is_loopback(options.address)),
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
  signals.async_wait([this](boost::system::error_code error, int) {
    if (!error) io.stop();
  });
  hub.on_set_parameter([this](const auto& wanted, auto answer) {
    set_team_parameter(operations, wanted, std::move(answer));
  });
  recording_worker.run([this] { remove_abandoned_uploads(recordings); });
  tell_regularly();
}

Ingest::Callbacks Monitor::Parts::callbacks() {
  // An exception from one topic or message must not keep the next ones from being handled.
  return {[this](const Channel& channel) {
            (void)guarded(channel.topic, [&] { hub.add_channel(channel); });
          },
          [this](const Message& message) {
            (void)guarded(message.channel.topic, [&] { receive(message); });
          },
          [](const std::string& problem) {
            std::clog << "galilean-monitor: " << problem << std::endl;
          }};
}

void Monitor::Parts::receive(const Message& message) {
  hub.send(message);  // first, because a viewer waits for it
  team.receive(message);
  map.receive(message);
  trials.receive(message);
  decode_for<msg::ProgramReply>(message, [this](const auto& reply) { desk.note(reply); });
  decode_for<msg::ProgramPush>(message, [this](const auto& push) { desk.note(push); });
  decode_for<msg::SimulationState>(message, [this](const auto& state) { simulations.note(state); });
  decode_for<msg::SimulationEvent>(message, [this](const auto& event) { simulations.note(event); });
}

void Monitor::Parts::tell_regularly() {
  (void)guarded("telling the clients", [this] {
    hub.send_time(wire::wall_clock_ns());
    hub.send_parameters(team_parameters(team));
    if (hub.graph_is_watched()) hub.send_graph(connection_graph(graph.topics()));
  });
  tell_timer.expires_after(kTellPeriod);
  tell_timer.async_wait([this](boost::system::error_code error) {
    if (!error) tell_regularly();
  });
}

Result<std::unique_ptr<Monitor>> Monitor::make(const MonitorOptions& options) try {
  // This comes first, because DDS fails where it cannot say so if it has too few.
  const auto descriptors = raise_descriptor_limit();
  if (!descriptors) return descriptors.error();
  auto history = History::open(options.data_folder / "history.sqlite");
  if (!history) return history.error();
  auto tokens = open_tokens(options.data_folder);
  if (!tokens) return tokens.error();
  auto participant = wire::Participant::join(wire::kMonitorName, options.domain);
  if (!participant) return participant.error();
  auto blocks = std::make_unique<Parts>(options, limits_for(descriptors.value()),
                                        std::move(participant).value(), std::move(history).value(),
                                        tokens.value());
  if (tokens.value().are_new) blocks->new_operator_token = tokens.value().operator_;
  const auto port = blocks->server.listen(options.address, options.port);
  if (!port) return port.error();
  blocks->port = port.value();
  return std::unique_ptr<Monitor>(new Monitor(std::move(blocks)));
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

void Monitor::run() {
  // An exception that comes this far has ended its handler. The others go on.
  while (!parts_->io.stopped()) (void)guarded("a handler", [this] { parts_->io.run(); });
}

void Monitor::stop() {
  parts_->io.stop();
}

}  // namespace galilean::monitor
