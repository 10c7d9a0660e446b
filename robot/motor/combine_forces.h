// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Adds up what the other motor schemas suggest.
///
///   reads   inputs (force, several), one of `gains` for each
///   writes  result (force); nothing if no input acts
///   law     sum:      F = clip(Σ gain · force, max_length)
///           average:  F = clip(Σ gain · force / Σ gain, max_length)
///           over the forces that act: valid, and written in this tick or constant. Certainty is
///           the mean of theirs, weighted by gain · |force|, or plain where all of these are 0.
///   source  the paper; its text says sum, its list of schemas says weighted average
class CombineForces final : public MotorSchema {
 public:
  static void describe(Declaration<CombineForces>& is);
  void run(const Tick& tick) override;

 private:
  enum class Mode { kSum, kAverage };

  std::vector<const Variable<Force>*> inputs_;
  std::vector<double> gains_;
  Mode mode_ = Mode::kSum;
  double max_length_ = 1;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
