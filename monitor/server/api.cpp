#include "monitor/server/api.h"

#include "monitor/programs/json.h"
#include "monitor/server/metrics.h"
#include "monitor/server/request_fields.h"
#include "monitor/server/team_json.h"

namespace galilean::monitor {
namespace {

HttpResponse response_of(const Outcome& outcome) {
  if (outcome.status < 400) return json_response(outcome.json, outcome.status);
  return problem(outcome.status, outcome.detail, outcome.json);
}

std::string rest(const HttpRequest& request, std::string_view prefix) {
  return request.path.substr(prefix.size());
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
        metrics_text(parts_.team, parts_.hub.counts(), counts_ ? counts_() : HttpServer::Counts{}),
        "text/plain; version=0.0.4"));
  });
  get("/api/status", [this](auto&, auto& respond) { status(respond); });
  get("/api/team", [this](auto&, auto& respond) { respond(json_response(to_json(parts_.team))); });
  get("/api/strategies", [this](auto&, auto& respond) {
    respond(json_response({{"strategies", strategies_json(parts_.team)}}));
  });
  get("/api/programs", [this](auto&, auto& respond) { programs(respond); });
  get("/api/programs/",
      [this](auto& request, auto& respond) { program(rest(request, "/api/programs/"), respond); });
  get("/api/pushes", [this](auto&, auto& respond) { pushes(respond); });
  get("/api/pushes/", [this](auto& request, auto& respond) {
    parts_.desk.describe(rest(request, "/api/pushes/"),
                         [respond](const Outcome& outcome) { respond(response_of(outcome)); });
  });
  get("/api/pushed/", [this](auto& request, auto& respond) {
    pushed_program(rest(request, "/api/pushed/"), respond);
  });
  get("/api/map.png", [this](auto&, auto& respond) { map_file("png", respond); });
  get("/api/map.yaml", [this](auto&, auto& respond) { map_file("yaml", respond); });
  post("/api/check", Right::kRead, operation(&Operations::check));
  post("/api/push", Right::kOperate, operation(&Operations::push));
  post("/api/pushes/", Right::kOperate,
       [this](auto& request, auto& respond) { cancel_push(request, respond); });
  post("/api/command", Right::kOperate, operation(&Operations::command));
}

void Api::post(std::string path, Right needs, Handler handler) {
  routes_.push_back({"POST", std::move(path), needs, std::move(handler)});
}

void Api::answer(const HttpRequest& request, const Respond& respond) {
  if (request.method == "OPTIONS")  // a page that the operator allowed asks before it posts
    return respond({204,
                    {},
                    nullptr,
                    {{"Access-Control-Allow-Methods", "GET, POST"},
                     {"Access-Control-Allow-Headers", "content-type, authorization"}}});
  bool path_known = false;
  if (const Route* route = find(request, path_known)) {
    if (request.right >= route->needs) return route->handler(request, respond);
    return respond(problem(request.right == Right::kNone ? 401 : 403, missing_right(route->needs)));
  }
  const bool reads = request.method == "GET" || request.method == "HEAD";
  if (path_known || !reads)
    return respond(problem(405, request.path + " does not take " + request.method + "."));
  respond(parts_.page.get(request));
}

const Api::Route* Api::find(const HttpRequest& request, bool& path_known) const {
  for (const auto& route : routes_) {
    const bool takes_rest = route.path.back() == '/';
    if (takes_rest ? !request.path.starts_with(route.path) : request.path != route.path) continue;
    path_known = true;
    if (route.method == request.method || (route.method == "GET" && request.method == "HEAD"))
      return &route;
  }
  return nullptr;
}

Api::Handler Api::operation(void (Operations::*operate)(const nlohmann::json&, Finish)) {
  return [this, operate](const HttpRequest& request, const Respond& respond) {
    const auto body = nlohmann::json::parse(request.body, nullptr, false);
    if (!body.is_object()) return respond(problem(400, "The body must be a JSON object."));
    try {
      (parts_.operations.*operate)(
          body, [respond](const Outcome& outcome) { respond(response_of(outcome)); });
    } catch (const BadRequest& wrong) {
      respond(problem(400, wrong.what()));
    }
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
                    [respond](const std::vector<PushRecord>& records) {
                      auto list = nlohmann::json::array();
                      for (const auto& record : records) list.push_back(to_json(record));
                      respond(json_response({{"pushes", std::move(list)}}));
                    });
}

/// POST /api/pushes/ID/cancel; the body may name an author.
void Api::cancel_push(const HttpRequest& request, const Respond& respond) {
  constexpr std::string_view kVerb = "/cancel";
  auto id = rest(request, "/api/pushes/");
  if (!id.ends_with(kVerb)) return respond(problem(404, "There is no " + request.path + "."));
  id.resize(id.size() - kVerb.size());
  auto body = nlohmann::json::parse(request.body.empty() ? "{}" : request.body, nullptr, false);
  if (!body.is_object()) return respond(problem(400, "The body must be a JSON object."));
  body["id"] = id;
  try {
    parts_.operations.cancel_push(
        body, [respond](const Outcome& outcome) { respond(response_of(outcome)); });
  } catch (const BadRequest& wrong) {
    respond(problem(400, wrong.what()));
  }
}

void Api::pushed_program(const std::string& hash, const Respond& respond) {
  parts_.worker.run([this, hash] { return parts_.history.program(hash); },
                    [respond, hash](const auto& files) {
                      if (!files)
                        return respond(problem(404, "No program '" + hash + "' was ever pushed."));
                      respond(json_response({{"hash", hash}, {"files", to_json(*files)}}));
                    });
}

void Api::status(const Respond& respond) const {
  auto robots = nlohmann::json::array();
  for (const auto& robot : parts_.team.statuses()) robots.push_back(to_json(robot));
  const auto& score = parts_.team.score();
  respond(json_response({{"name", "galilean-monitor"},
                         {"version", GALILEAN_VERSION},
                         {"scenario", score ? score->scenario : ""},
                         {"program_hash", parts_.team.program_hash()},
                         {"robots", std::move(robots)},
                         {"score", score_json(parts_.team)}}));
}

void Api::map_file(const std::string& kind, const Respond& respond) const {
  parts_.worker.run([this] { return parts_.map.files(); },
                    [respond, kind](const std::optional<MapFiles>& files) {
                      if (!files)
                        return respond(problem(404,
                                               "There is no map yet: no robot has told where "
                                               "it is."));
                      respond(kind == "png" ? text_response(files->png, "image/png")
                                            : text_response(files->yaml, "application/yaml"));
                    });
}

}  // namespace galilean::monitor
