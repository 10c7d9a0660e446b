// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/ingest/intake.h"
#include "monitor/lease/lease_desk.h"
#include "monitor/map/map_service.h"
#include "monitor/pushes/history_watch.h"
#include "monitor/recordings/recording_list.h"
#include "monitor/server/api/coverage_desk.h"
#include "monitor/server/api/operations.h"
#include "monitor/server/http/http_server.h"
#include "monitor/server/http/page_files.h"
#include "monitor/simulation/simulation_desk.h"

namespace galilean::monitor {

/// Answers plain HTTP requests: the page's files, /healthz, /metrics, /recordings/… and
/// /api/…, as docs/openapi.yaml describes them. For use on the io_context's thread.
class Api {
 public:
  /// The folder of recordings. The list is used on the worker only, which may block on the disk.
  struct Recordings {
    const RecordingFolder& folder;
    RecordingList& list;
    Worker& worker;
    CoverageDesk& coverage;
  };
  struct Parts {
    const PageFiles& page;
    const Team& team;
    const ProgramLibrary& library;
    const MapService& map;
    const foxglove::Hub& hub;
    Operations& operations;
    LeaseDesk& leases;
    PushDesk& desk;
    SimulationDesk& simulations;
    Worker& worker;
    Worker& checks;  ///< reads and checks what takes long; may refuse it because too much waits
    Worker& push_checks;  ///< the same for requests that need the operator's token
    History& history;     ///< used on the worker only
    const HistoryWatch& history_watch;
    Recordings recordings;
    LimitCounts& limit_counts;
    ServerLimits limits = {};
  };

  explicit Api(Parts blocks);

  /// Answers at once, or later on the same thread if the worker must be asked.
  void answer(const HttpRequest& request, const Respond& respond);
  /// Sets where /metrics gets its counts. It is not a constructor's argument because the server
  /// that counts is made after the API.
  void set_counts(std::function<HttpServer::Counts()> counts) { counts_ = std::move(counts); }
  /// Sets where the API gets how messages come in, for the same reason.
  void set_intake(std::function<Intake()> intake) { intake_ = std::move(intake); }
  /// Returns how long a body may be that is sent to `path`, of any method but PUT [bytes].
  [[nodiscard]] std::size_t most_body_bytes(const std::string& path) const;

 private:
  using Handler = std::function<void(const HttpRequest&, const Respond&)>;
  using JsonHandler =
      std::function<void(const HttpRequest&, const nlohmann::json& body, const Respond&)>;
  struct Route {
    std::string method;
    std::string path;  ///< ends with '/' if the rest of the request's path is an argument
    Right needs;
    Handler handler;
    std::size_t most_body_bytes = 0;
  };

  void add_routes();
  void add_map_routes();
  void add_simulation_routes();
  void add_recording_routes();
  /// Adds a route whose handler gets the request's body as JSON that keeps within `limits`. This is
  /// the only way by which a handler gets JSON. No body counts as {}.
  void post(std::string path, Right needs, const JsonLimits& limits, JsonHandler handler);
  [[nodiscard]] static Finish finish_of(const Respond& respond);
  [[nodiscard]] JsonHandler operation(void (Operations::*operate)(const nlohmann::json&, Finish));
  [[nodiscard]] JsonHandler operation(void (Operations::*operate)(const nlohmann::json&,
                                                                  const OperatorId&, Finish));
  [[nodiscard]] std::vector<const Route*> routes_to(const std::string& path) const;
  [[nodiscard]] static bool takes(const Route& route, const std::string& method);
  [[nodiscard]] static HttpResponse not_allowed(const HttpRequest& request,
                                                const std::vector<const Route*>& here);
  void programs(const Respond& respond) const;
  void program(const std::string& name, const Respond& respond) const;
  void pushes(const Respond& respond);
  void orders(const Respond& respond);
  void cancel_push(const HttpRequest& request, nlohmann::json body, const Respond& respond);
  void pushed_program(const std::string& hash, const Respond& respond);
  void list_recordings(const Respond& respond);
  void refuse_recording(const Respond& respond) const;
  void send_recording(const HttpRequest& request, const Respond& respond);
  void send_coverage(const HttpRequest& request, const Respond& respond);
  void status(const HttpRequest& request, const Respond& respond) const;

  Parts parts_;
  std::vector<Route> routes_;
  std::function<HttpServer::Counts()> counts_;
  std::function<Intake()> intake_;
};

}  // namespace galilean::monitor
