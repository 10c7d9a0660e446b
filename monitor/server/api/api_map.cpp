// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/export/map_files.h"
#include "monitor/map/export/map_scene.h"
#include "monitor/server/api/api.h"

namespace galilean::monitor {

void Api::add_map_routes() {
  using Newest = MapService::Newest;
  const auto serve = [this](std::string path, std::string type, auto render) {
    routes_.push_back(
        {"GET", std::move(path), Right::kRead,
         [this, type = std::move(type), render](auto&, auto& respond) {
           const bool is_taken = parts_.checks.offer(
               [this, render] {
                 const auto newest = parts_.map.newest();
                 return newest ? render(*newest) : std::string();
               },
               [respond, type](std::string file) {
                 if (!file.empty()) return respond(text_response(std::move(file), type));
                 respond(problem(404, "There is no map yet, because no robot has sent its pose."));
               },
               failed(finish_of(respond)));
           if (is_taken) return;
           parts_.limit_counts.reached(Limit::kChecks);
           finish_of(respond)(busy());
         }});
  };
  serve("/api/map.png", "image/png", [](const Newest& map) { return map_png(map.grid); });
  serve("/api/map.yaml", "application/yaml", [](const Newest& map) { return map_yaml(map.grid); });
  serve("/api/map.3Dscene", "application/x-mrpt-3dscene",
        [](const Newest& map) { return map_scene(map.grid, map.objects); });
}

}  // namespace galilean::monitor
