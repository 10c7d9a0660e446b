// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/combine_forces.h"

#include "robot/variables/relative.h"

namespace galilean::robot {
namespace {

/// Sums over the forces that were added so far.
struct Total {
  Vec2 force = Vec2::Zero();
  double gain = 0;
  int count = 0;
  double certainty = 0;
  double weight = 0;
  double weighted_certainty = 0;

  void add(const Vec2& input, double input_gain, double input_certainty) noexcept {
    const double length = input_gain * input.norm();
    force += input_gain * input;
    gain += input_gain;
    ++count;
    certainty += input_certainty;
    weight += length;
    weighted_certainty += length * input_certainty;
  }
  [[nodiscard]] double mean_certainty() const noexcept {
    return weight > 0 ? weighted_certainty / weight : certainty / count;
  }
};

}  // namespace

void CombineForces::describe(Declaration<CombineForces>& is) {
  is.help("Adds up the forces of other motor schemas, each times its gain.");
  is.reads_all(&CombineForces::inputs_, "inputs", "the forces");
  is.numbers(&CombineForces::gains_, "gains", unit::kNone, {},
             "a gain for each force, in the same order; without gains all are 1")
      .range(0, 1e6)
      .one_for_each("inputs")
      .role(Role::kGain, "inputs");
  is.choice(&CombineForces::mode_, "mode", {"sum", "average"}, "sum",
            "whether the sum is divided by the sum of the gains");
  is.number(&CombineForces::max_length_, "max_length", unit::kNone, 1,
            "length to which the result is clipped")
      .range(0, 1e6);
  is.writes(&CombineForces::result_, "result", "the combined force");
}

void CombineForces::run(const Tick& tick) {
  Total total;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (!acts(*inputs_[i], tick)) continue;
    const double gain = gains_.empty() ? 1 : gains_.at(i);
    total.add(inputs_[i]->value.value, gain, inputs_[i]->certainty_at(tick.now));
  }
  if (total.count == 0) return;
  const bool divide = mode_ == Mode::kAverage && total.gain > 0;
  const Vec2 force = divide ? Vec2(total.force / total.gain) : total.force;
  result_->write({clipped(force, max_length_)}, total.mean_certainty(), tick.now, tick.number);
}

}  // namespace galilean::robot
