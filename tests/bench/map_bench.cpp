#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/monitor/truth/figures.h"

namespace {

using namespace galilean::monitor;

void print(const char* name, const Figures& f) {
  std::printf(
      "%-5s robots %5.1f cm (dead reckoning %5.1f) nees %5.1f | trash %5.1f cm nees %5.1f "
      "precision %.2f recall %.2f | shown %4.1f of %4.1f | baskets %5.1f cm nees %5.1f shown %.1f, "
      "%.1f there\n",
      name, 100 * f.robot_m2.rms(), 100 * f.dead_reckoning_m2.rms(), f.robot_nees.mean(),
      100 * f.thing_m2.rms(), f.thing_nees.mean(), f.precision(), f.recall(),
      double(f.all_told) / double(f.looks), double(f.all_real) / double(f.looks),
      100 * f.basket_m2.rms(), f.basket_nees.mean(), double(f.baskets_told) / double(f.looks),
      double(f.baskets_right) / double(f.looks));
}

}  // namespace

/// How right the map is after three minutes of an office contest:
///   map_bench [SEEDS=10] [measured|rough] [SQUAD=4] [SECONDS=190]
/// seeds 1 to SEEDS; "rough": robots' starts are given as the scenario says, before the jitter;
/// so many robots a squad.
int main(int count, char** arguments) {
  const int seeds = count > 1 ? std::atoi(arguments[1]) : 10;
  const bool rough = count > 2 && std::string(arguments[2]) == "rough";
  const std::size_t squad = count > 3 ? std::stoul(arguments[3]) : Squads::kMostRobots;
  const double to_s = count > 4 ? std::atof(arguments[4]) : 190;
  Figures all;
  for (int seed = 1; seed <= seeds; ++seed) {
    MappedContest contest(
        {.seed = static_cast<std::uint64_t>(seed),
         .duration_s = to_s,
         .starts = rough ? MappedContest::Starts::kRough : MappedContest::Starts::kMeasured,
         .squad = squad});
    TruthWatch watch(contest, to_s - 20, to_s);
    contest.run([&](const auto& now, const auto& map) { watch.look(now, map); });
    print(std::to_string(seed).c_str(), watch.figures());
    all.add(watch.figures());
  }
  print("all", all);
}
