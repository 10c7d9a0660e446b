// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/times.h"
#include "monitor/server/api/api.h"
#include "monitor/server/api/recording_file.h"
#include "monitor/server/api/recording_upload.h"

namespace galilean::monitor {
namespace {

constexpr std::string_view kList = "/api/recordings";
constexpr std::string_view kEach = "/api/recordings/";
constexpr std::string_view kCoverage = "/coverage";

nlohmann::json to_json(const ListedRecording& recording) {
  nlohmann::json json{{"name", recording.name},
                      {"bytes", recording.bytes},
                      {"modified", iso_time(recording.modified_ns)},
                      {"start", recording.start_ns},
                      {"end", recording.end_ns},
                      {"messages", recording.messages},
                      {"robots", recording.robots},
                      {"complete", recording.complete}};
  if (!recording.why.empty()) json["why"] = recording.why;
  return json;
}

}  // namespace

void Api::add_recording_routes() {
  routes_.push_back({"GET", std::string(kList), Right::kRead,
                     [this](auto&, auto& respond) { list_recordings(respond); }});
  routes_.push_back({"GET", std::string(Guard::kSharedPath), Right::kRead,
                     [this](auto& request, auto& respond) { send_recording(request, respond); }});
  routes_.push_back({"GET", std::string(kEach), Right::kRead,
                     [this](auto& request, auto& respond) { send_coverage(request, respond); }});
  routes_.push_back(
      {"PUT", std::string(kEach), Right::kOperate, [this](auto& request, auto& respond) {
         receive_recording(parts_.recordings.folder, parts_.recordings.worker,
                           request.path.substr(kEach.size()), request, respond);
       }});
}

void Api::list_recordings(const Respond& respond) {
  const bool is_taken = parts_.recordings.worker.offer(
      [this] { return parts_.recordings.list.list(); },
      [this, respond](const Result<std::vector<ListedRecording>>& listed) {
        if (!listed) return respond(problem(503, listed.error().message));
        auto list = nlohmann::json::array();
        for (const auto& recording : listed.value()) list.push_back(to_json(recording));
        respond(json_response({{"folder", parts_.recordings.folder.path().string()},
                               {"recordings", std::move(list)}}));
      },
      failed(finish_of(respond)));
  if (!is_taken) refuse_recording(respond);
}

void Api::send_recording(const HttpRequest& request, const Respond& respond) {
  const bool is_taken = parts_.recordings.worker.offer(
      [this, name = request.path.substr(Guard::kSharedPath.size())] {
        return parts_.recordings.folder.open(name);
      },
      [request, respond](const Result<OpenedRecording, NotOpened>& opened) {
        respond(opened ? recording_response(opened.value(), request)
                       : recording_problem(opened.error()));
      },
      failed(finish_of(respond)));
  if (!is_taken) refuse_recording(respond);
}

void Api::refuse_recording(const Respond& respond) const {
  parts_.limit_counts.reached(Limit::kRecordings);
  finish_of(respond)(busy());
}

// The request is GET /api/recordings/NAME/coverage.
void Api::send_coverage(const HttpRequest& request, const Respond& respond) {
  auto name = request.path.substr(kEach.size());
  if (!name.ends_with(kCoverage)) return respond(problem(404, "There is no " + request.path + "."));
  name.resize(name.size() - kCoverage.size());
  parts_.recordings.coverage.ask(name, respond);
}

}  // namespace galilean::monitor
