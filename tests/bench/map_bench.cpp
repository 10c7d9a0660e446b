// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <string>

#include "core/command_line/command_line.h"
#include "tests/monitor/map/truth/figures.h"
#include "tests/monitor/map/truth/occupancy_figures.h"

namespace {

using namespace galilean::monitor;

void print(const char* name, const Figures& f) {
  std::printf(
      "%-5s robots %5.1f cm (dead reckoning %5.1f) nees %5.1f | trash %5.1f cm nees %5.1f "
      "precision %.2f recall %.2f | shown %4.1f of %4.1f | baskets %5.1f cm nees %5.1f shown %.1f, "
      "%.1f there\n",
      name, 100 * f.robot_m2.rms(), 100 * f.dead_reckoning_m2.rms(), f.robot_nees.mean(),
      100 * f.trash_m2.rms(), f.trash_nees.mean(), f.precision(), f.recall(),
      double(f.all_published) / double(f.looks), double(f.all_real) / double(f.looks),
      100 * f.basket_m2.rms(), f.basket_nees.mean(), double(f.baskets_published) / double(f.looks),
      double(f.baskets_right) / double(f.looks));
}

void print(const char* name, const OccupancyFigures& f) {
  std::printf("%-5s floor free precision %.2f recall %.2f | occupied precision %.2f recall %.2f\n",
              name, f.free_precision.value(), f.free_recall.value(), f.occupied_precision.value(),
              f.occupied_recall.value());
}

}  // namespace

/// Measures how right the map is after three minutes of a contest; see map_bench --help.
int main(int count, char** arguments) try {
  int seeds = 10;
  double to_s = 190;
  bool rough = false;
  MappedContest::Options options;
  galilean::CommandLine app(
      "How right the map is after three minutes of a contest, against the world's truth.",
      "map_bench");
  app.option("seeds", seeds, "from 1 on").show_default();
  app.option("--scenario", options.scenario, "one that ships, or a file").show_default();
  app.option("--robots", options.robots, "how many").show_default();
  app.option("--group-size,--squad", options.group_size, "robots estimated together")
      .show_default();
  app.option("--seconds", to_s, "of each contest; its last 20 count").show_default();
  app.flag("--rough", rough, "starts as the scenario says, before the jitter");
  if (const auto code = app.parse(count, arguments)) return *code;
  options.starts = rough ? MappedContest::Starts::kRough : MappedContest::Starts::kMeasured;
  options.duration_s = to_s;
  Figures all;
  OccupancyFigures all_floor;
  for (int seed = 1; seed <= seeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    MappedContest contest(options);
    TruthWatch watch(contest, to_s - 20, to_s);
    const OccupancyWatch floor(contest);
    contest.run([&](const auto& now, const auto& map) { watch.look(now, map); });
    print(std::to_string(seed).c_str(), watch.figures());
    all.add(watch.figures());
    const OccupancyFigures of_floor = floor.figures();
    print(std::to_string(seed).c_str(), of_floor);
    all_floor.add(of_floor);
  }
  print("all", all);
  print("all", all_floor);
} catch (const std::exception& error) {
  std::fprintf(stderr, "map_bench: %s\n", error.what());
  return 1;
}
