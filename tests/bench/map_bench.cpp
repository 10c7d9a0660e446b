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

/// How right the map is after three minutes of an office contest, seeds 1 to `argv[1]`; with
/// "rough", robots' starts are given as the scenario says, before the jitter.
int main(int count, char** arguments) {
  const int seeds = count > 1 ? std::atoi(arguments[1]) : 10;
  const bool rough = count > 2;
  const double to_s = count > 3 ? std::atof(arguments[3]) : 190;
  Figures all;
  for (int seed = 1; seed <= seeds; ++seed) {
    MappedContest contest(
        {.seed = static_cast<std::uint64_t>(seed),
         .duration_s = to_s,
         .starts = rough ? MappedContest::Starts::kRough : MappedContest::Starts::kMeasured});
    TruthWatch watch(contest, to_s - 20, to_s);
    contest.run([&](const auto& now, const auto& map) { watch.look(now, map); });
    print(std::to_string(seed).c_str(), watch.figures());
    all.add(watch.figures());
  }
  print("all", all);
}
