// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <span>

#include "monitor/map/export/map_scene.h"
#include "monitor/map/export/markers.h"
#include "monitor/map/team_map.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;
using namespace std::chrono_literals;

constexpr double kSquareMetresALandmark = 1.6, kSight_m = 3, kView_rad = 73.5 * kPi / 180;
constexpr double kTurn_rad = 0.35;
constexpr int kFramesAnUpdate = 2;  ///< cameras run at 10 Hz, the map at 5 Hz
constexpr int kSlicesAnUpdate = 10;

constexpr int kPeriodsATurn = 10;

/// Robots that turn in place in a hall full of landmarks. Their cameras measure with an error of 3
/// cm.
class Hall {
 public:
  Hall(int robots, int landmarks) {
    const double half_m = std::sqrt(kSquareMetresALandmark * landmarks) / 2;
    std::uniform_real_distribution<double> anywhere(-half_m, half_m);
    for (int i = 0; i < landmarks; ++i)
      landmarks_.emplace_back(anywhere(random_), anywhere(random_));
    for (int i = 0; i < robots; ++i) {
      starts_.push_back({{anywhere(random_), anywhere(random_)}, anywhere(random_)});
      map_.start_at(name(i), starts_.back());
    }
    turned_rad_.resize(starts_.size());
  }

  struct Report {
    msg::RobotState state;
    msg::Sightings sightings;
    Time at;
  };
  /// Returns what robots report between two updates.
  [[nodiscard]] std::vector<Report> period() {
    std::vector<Report> reports;
    for (int frame = 0; frame < kFramesAnUpdate; ++frame, now_ += 100ms)
      for (std::size_t i = 0; i < starts_.size(); ++i) {
        turned_rad_[i] = wrap_angle(turned_rad_[i] + kTurn_rad);
        reports.push_back({state(i), sightings(i), now_});
      }
    return reports;
  }
  void add(std::span<const Report> some) {
    for (const auto& report : some) {
      map_.add(report.state, report.at);
      map_.add(report.sightings, report.at);
    }
  }
  [[nodiscard]] msg::ObjectMap update() {
    map_.update(now_);
    return map_.objects(now_, now_.time_since_epoch().count());
  }

 private:
  static std::string name(std::size_t robot) { return "r" + std::to_string(robot); }

  [[nodiscard]] msg::RobotState state(std::size_t robot) const {
    msg::RobotState state;
    state.robot = name(robot);
    state.heading_rad = turned_rad_[robot];
    return state;
  }
  [[nodiscard]] msg::Sightings sightings(std::size_t robot) {
    std::normal_distribution<double> error(0, 0.03);
    const Pose2& start = starts_[robot];
    msg::Sightings frame;
    frame.robot = name(robot);
    frame.heading_rad = turned_rad_[robot];
    frame.view_angle_rad = static_cast<float>(kView_rad);
    for (const Vec2& landmark : landmarks_) {
      const Vec2 in_odom = rotated(landmark - start.position_m, -start.heading_rad);
      const Vec2 towards = rotated(in_odom, -turned_rad_[robot]);
      const double azimuth_rad = std::atan2(towards.y(), towards.x());
      if (towards.norm() > kSight_m || std::abs(azimuth_rad) > kView_rad / 2) continue;
      auto& item = frame.items.emplace_back();
      item.object_class = "trash";
      item.x_m = in_odom.x() + error(random_);
      item.y_m = in_odom.y() + error(random_);
      item.variance_xx = item.variance_yy = 9e-4;
      item.range_m = static_cast<float>(towards.norm());
      item.azimuth_rad = static_cast<float>(azimuth_rad);
      item.left_px = item.top_px = item.right_px = item.bottom_px = 100;
    }
    return frame;
  }

  std::mt19937 random_{1};
  std::vector<Vec2> landmarks_;
  std::vector<Pose2> starts_;
  std::vector<double> turned_rad_;  ///< by odometry
  TeamMap map_{2s};
  Time now_{1s};
};

/// Measures the time from the moment of publishing to the published map. The service takes messages
/// in slices all the time; only the last slice and the update are timed. `messages_ms` is the time
/// for all messages of a period. The robots first make a whole turn.
void update(benchmark::State& state) {
  Hall hall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (int i = 0; i < kPeriodsATurn; ++i) {
    hall.add(hall.period());
    (void)hall.update();
  }
  std::size_t objects = 0;
  double adding_s = 0;
  for (auto _ : state) {
    const auto reports = hall.period();
    const auto last = reports.size() / kSlicesAnUpdate + 1;
    const auto began = std::chrono::steady_clock::now();
    hall.add(std::span(reports).first(reports.size() - last));
    const auto due = std::chrono::steady_clock::now();
    hall.add(std::span(reports).last(last));
    const auto added = std::chrono::steady_clock::now();
    objects = hall.update().objects.size();
    state.SetIterationTime(to_seconds(std::chrono::steady_clock::now() - due));
    adding_s += to_seconds(added - began);
  }
  state.counters["objects"] = static_cast<double>(objects);
  state.counters["messages_ms"] = 1e3 * adding_s / static_cast<double>(state.iterations());
}
BENCHMARK(update)
    ->Unit(benchmark::kMillisecond)
    ->Args({3, 20})
    ->Args({4, 40})
    ->Args({10, 100})
    ->Args({100, 1000})
    ->UseManualTime()
    ->Iterations(20);

msg::ObjectMap full_map(int robots, int landmarks) {
  msg::ObjectMap map;
  for (int i = 0; i < landmarks; ++i) {
    auto& item = map.objects.emplace_back();
    item.id = static_cast<std::uint32_t>(i);
    item.object_class = "trash";
    item.x_m = i * 0.1;
    item.variance_xx = item.variance_yy = 1e-3;
    item.certainty = 1;
    item.seen_by = {"io", "ganymede"};
  }
  for (int i = 0; i < robots; ++i) {
    auto& robot = map.robots.emplace_back();
    robot.name = "r" + std::to_string(i);
    robot.variance_xx = robot.variance_yy = 1e-3;
  }
  return map;
}

void make_markers(benchmark::State& state) {
  const auto map = full_map(100, 1000);
  for (auto _ : state) benchmark::DoNotOptimize(markers(map));
}
BENCHMARK(make_markers)->Unit(benchmark::kMillisecond);

void make_scene(benchmark::State& state) {
  const auto map = full_map(100, 1000);
  for (auto _ : state) benchmark::DoNotOptimize(map_scene({}, map));
}
BENCHMARK(make_scene)->Unit(benchmark::kMillisecond);

}  // namespace
