// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/api.h"

#include <algorithm>

#include "core/json_text.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/history/json.h"
#include "monitor/server/api/intake_json.h"
#include "monitor/server/api/lease_json.h"
#include "monitor/server/api/metrics.h"
#include "monitor/server/api/team_json.h"
#include "monitor/server/http/http_caching.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor {
namespace {

std::string rest(const HttpRequest& request, std::string_view prefix) {
  return request.path.substr(prefix.size());
}

bool is_reading(const HttpRequest& request) {
  return request.method == "GET" || request.method == "HEAD";
}

/// So much JSON is read within a millisecond. More is read on another thread.
constexpr std::size_t kReadAtOnce_bytes = std::size_t{64} << 10;

/// Returns what a handler of JSON may still want of a request.
HttpRequest without_body(const HttpRequest& request) {
  HttpRequest kept{.method = request.method, .path = request.path};
  kept.right = request.right;
  kept.who = request.who;
  return kept;
}

/// A browser asks so before a page of another site may post, or ask for a part of a file.
HttpResponse what_other_pages_may(const std::string& path) {
  const bool is_file = path.starts_with(Guard::kSharedPath);
  return {204,
          {},
          nullptr,
          {{"Access-Control-Allow-Methods", is_file ? "GET, HEAD" : "GET, POST, PUT"},
           {"Access-Control-Allow-Headers",
            is_file ? "range, if-range, if-none-match, authorization"
                    : "content-type, authorization, x-galilean-operator, "
                      "x-galilean-client"}}};
}

}  // namespace

Api::Api(Parts parts) : parts_(parts) {
  add_routes();
}

void Api::add_routes() {
  const auto get = [this](std::string path, Handler handler) {
    routes_.push_back({"GET", std::move(path), Right::kRead, std::move(handler)});
  };
  routes_.push_back({"GET", "/healthz", Right::kNone,
                     [](auto&, auto& respond) { respond(text_response("ok\n", "text/plain")); }});
  get("/metrics", [this](auto&, auto& respond) {
    respond(text_response(
        metrics_text(parts_.team, parts_.hub.counts(), counts_ ? counts_() : HttpServer::Counts{},
                     intake_ ? intake_() : Intake{}, parts_.limit_counts, parts_.map,
                     parts_.history_watch),
        "text/plain; version=0.0.4; charset=utf-8"));
  });
  get("/api/status", [this](auto& request, auto& respond) { status(request, respond); });
  get("/api/team", [this](auto&, auto& respond) { respond(json_response(to_json(parts_.team))); });
  get("/api/strategies", [this](auto&, auto& respond) {
    respond(json_response({{"strategies", strategies_json(parts_.team)}}));
  });
  get("/api/programs", [this](auto&, auto& respond) { programs(respond); });
  get("/api/programs/",
      [this](auto& request, auto& respond) { program(rest(request, "/api/programs/"), respond); });
  get("/api/pushes", [this](auto&, auto& respond) { pushes(respond); });
  get("/api/orders", [this](auto&, auto& respond) { orders(respond); });
  get("/api/pushes/", [this](auto& request, auto& respond) {
    parts_.desk.describe(
        rest(request, "/api/pushes/"),
        [finish = finish_of(respond)](const PushAnswer& answer) { finish(outcome_of(answer)); });
  });
  get("/api/pushed/", [this](auto& request, auto& respond) {
    pushed_program(rest(request, "/api/pushed/"), respond);
  });
  add_map_routes();
  add_simulation_routes();
  add_recording_routes();
  const auto& limits = parts_.limits;
  post("/api/check", Right::kRead, limits.program, operation(&Operations::check));
  post("/api/push", Right::kOperate, limits.program, operation(&Operations::push));
  post("/api/pushes/", Right::kOperate, limits.command,
       [this](auto& request, auto& body, auto& respond) { cancel_push(request, body, respond); });
  post("/api/command", Right::kOperate, limits.command, operation(&Operations::command));
  post("/api/breaks", Right::kOperate, limits.breaks, operation(&Operations::order_breaks));
  post("/api/lease", Right::kOperate, limits.breaks, operation(&Operations::change_lease));
}

void Api::post(std::string path, Right needs, const JsonLimits& limits, JsonHandler handler) {
  const auto handle = [handler = std::move(handler)](const HttpRequest& request,
                                                     const Result<nlohmann::json>& body,
                                                     const Respond& respond) {
    if (!body) return respond(problem(400, body.error().message));
    handler(request, body.value(), respond);
  };
  routes_.push_back(
      {"POST", std::move(path), needs,
       [this, handle, limits, needs](const HttpRequest& request, const Respond& respond) {
         if (request.body.empty()) return handle(request, nlohmann::json::object(), respond);
         if (request.body.size() <= kReadAtOnce_bytes)
           return handle(request, read_untrusted_json(request.body, limits), respond);
         Worker& reader = needs == Right::kOperate ? parts_.push_checks : parts_.checks;
         const bool is_taken = reader.offer(
             [body = request.body, limits] { return read_untrusted_json(body, limits); },
             [handle, respond, kept = without_body(request)](const Result<nlohmann::json>& body) {
               handle(kept, body, respond);
             },
             failed(finish_of(respond)));
         if (is_taken) return;
         parts_.limit_counts.reached(Limit::kChecks);
         finish_of(respond)(busy());
       },
       limits.bytes});
}

std::size_t Api::most_body_bytes(const std::string& path) const {
  std::size_t most = parts_.limits.command.bytes;
  for (const Route* route : routes_to(path)) most = std::max(most, route->most_body_bytes);
  return most;
}

void Api::answer(const HttpRequest& request, const Respond& respond) {
  if (request.method == "OPTIONS") return respond(what_other_pages_may(request.path));
  const auto here = routes_to(request.path);
  if (here.empty() && is_reading(request)) return respond(parts_.page.get(request));
  const auto route =
      std::ranges::find_if(here, [&](const Route* each) { return takes(*each, request.method); });
  if (route == here.end()) return respond(not_allowed(request, here));
  if (request.right < (*route)->needs) return respond(refusal(request.right, (*route)->needs));
  // Whatever an operator asks keeps what it holds, so that a page needs no other sign of life.
  if (request.right == Right::kOperate) parts_.leases.hear(request.who);
  HttpRequest conditions{.method = request.method,
                         .if_none_match = request.if_none_match,
                         .accepts_gzip = request.accepts_gzip};
  (*route)->handler(request, [respond, conditions = std::move(conditions)](HttpResponse response) {
    respond(with_caching_and_compression(std::move(response), conditions));
  });
}

std::vector<const Api::Route*> Api::routes_to(const std::string& path) const {
  std::vector<const Route*> found;
  for (const auto& route : routes_) {
    const bool takes_rest = route.path.back() == '/';
    if (takes_rest ? path.starts_with(route.path) : path == route.path) found.push_back(&route);
  }
  return found;
}

bool Api::takes(const Route& route, const std::string& method) {
  return route.method == method || (route.method == "GET" && method == "HEAD");
}

HttpResponse Api::not_allowed(const HttpRequest& request, const std::vector<const Route*>& here) {
  auto response = problem(405, request.path + " does not accept " + request.method + ".");
  std::string allowed = here.empty() ? "GET" : "";
  for (const Route* route : here) allowed += (allowed.empty() ? "" : ", ") + route->method;
  response.headers.emplace_back("Allow", allowed);
  return response;
}

Finish Api::finish_of(const Respond& respond) {
  return [respond](const Outcome& outcome) {
    if (outcome.status < 400) return respond(json_response(outcome.json, outcome.status));
    respond(problem(outcome.status, outcome.detail, outcome.json));
  };
}

Api::JsonHandler Api::operation(void (Operations::*operate)(const nlohmann::json&, Finish)) {
  return [this, operate](const HttpRequest&, const nlohmann::json& body, const Respond& respond) {
    (parts_.operations.*operate)(body, finish_of(respond));
  };
}

Api::JsonHandler Api::operation(void (Operations::*operate)(const nlohmann::json&,
                                                            const OperatorId&, Finish)) {
  return [this, operate](const HttpRequest& request, const nlohmann::json& body,
                         const Respond& respond) {
    (parts_.operations.*operate)(body, request.who, finish_of(respond));
  };
}

void Api::programs(const Respond& respond) const {
  auto list = nlohmann::json::array();
  for (const auto& entry : parts_.library.list())
    list.push_back({{"name", entry.name}, {"source", "shipped"}, {"hash", entry.hash}});
  respond(json_response({{"programs", std::move(list)}}));
}

void Api::program(const std::string& name, const Respond& respond) const {
  const auto files = parts_.library.read(name);
  if (!files) return respond(problem(404, "There is no program '" + name + "' here."));
  respond(json_response({{"name", name}, {"files", to_json(*files)}}));
}

void Api::pushes(const Respond& respond) {
  constexpr int kMost = 200;
  parts_.worker.run([this] { return parts_.history.pushes(kMost); },
                    [this, respond](const auto& records) {
                      if (!records)
                        return respond(problem(503, "The monitor cannot do this now: " +
                                                        records.error().message + "."));
                      auto list = nlohmann::json::array();
                      for (const auto& record : records.value()) list.push_back(to_json(record));
                      respond(json_response({{"pushes", std::move(list)},
                                             {"problem", parts_.history_watch.problem()}}));
                    },
                    failed(finish_of(respond)));
}

void Api::orders(const Respond& respond) {
  constexpr int kMost = 500;
  parts_.worker.run([this] { return parts_.history.orders(kMost); },
                    [respond](const auto& records) {
                      if (!records)
                        return respond(problem(503, "The monitor cannot do this now: " +
                                                        records.error().message + "."));
                      auto list = nlohmann::json::array();
                      for (const auto& record : records.value()) list.push_back(to_json(record));
                      respond(json_response({{"orders", std::move(list)}}));
                    },
                    failed(finish_of(respond)));
}

// The request is POST /api/pushes/ID/cancel. Its body may name an author.
void Api::cancel_push(const HttpRequest& request, nlohmann::json body, const Respond& respond) {
  constexpr std::string_view kVerb = "/cancel";
  auto id = rest(request, "/api/pushes/");
  if (!id.ends_with(kVerb)) return respond(problem(404, "There is no " + request.path + "."));
  id.resize(id.size() - kVerb.size());
  if (body.is_object()) body["id"] = id;
  parts_.operations.cancel_push(body, request.who, finish_of(respond));
}

void Api::pushed_program(const std::string& hash, const Respond& respond) {
  parts_.worker.run([this, hash] { return parts_.history.program(hash); },
                    [respond, hash](const auto& found) {
                      if (!found) return respond(problem(503, found.error().message + "."));
                      const auto& files = found.value();
                      if (!files)
                        return respond(problem(
                            404, "No program '" + hash +
                                     "' was ever pushed through this monitor. One that robots were "
                                     "started with comes back by its file: push that."));
                      respond(json_response({{"hash", hash}, {"files", to_json(*files)}}));
                    },
                    failed(finish_of(respond)));
}

void Api::status(const HttpRequest& request, const Respond& respond) const {
  const bool may_steer = request.right == Right::kOperate;
  auto robots = nlohmann::json::array();
  for (const auto& robot : parts_.team.statuses()) {
    robots.push_back(to_json(robot));
    robots.back()["lease"] = lease_json(parts_.leases, robot.name, request.who);
  }
  const auto& score = parts_.team.score();
  const Intake intake = intake_ ? intake_() : Intake{};
  respond(json_response({{"name", "galilean-monitor"},
                         {"version", GALILEAN_VERSION},
                         {"scenario", score ? score->scenario : ""},
                         {"may_steer", may_steer},
                         {"operator", may_steer ? operator_json(request.who) : nlohmann::json()},
                         {"program_hash", parts_.team.program_hash()},
                         {"now_ns", wire::wall_clock_ns()},
                         {"channels", channels_json(intake)},
                         {"refused_messages", refused_json(intake)},
                         {"topics_not_read", intake.topics_not_read},
                         {"history_problem", parts_.history_watch.problem()},
                         {"map_problem", parts_.map.watch().problem()},
                         {"robots_forgotten", intake.robots_forgotten},
                         {"robots", std::move(robots)},
                         {"score", score_json(parts_.team)}}));
}

}  // namespace galilean::monitor
