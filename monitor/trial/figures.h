// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::monitor {

/// The mean of one figure over several runs, and its standard deviation.
struct Figure {
  double mean = 0;
  double spread = 0;
};
[[nodiscard]] Figure figure_of(const std::vector<double>& values);

/// What several simulated contests with one program came to, for the team as a whole.
struct TrialSide {
  std::size_t runs = 0;
  Figure score, deposited, collisions;
  std::map<std::string, Figure> seconds_in_state;  ///< per robot, on average
};
/// `reports`: what `galilean sim --headless --json` printed.
[[nodiscard]] Result<TrialSide> side_of(const std::vector<nlohmann::json>& reports);

/// The new program's side beside that of the one that runs.
struct TrialFigures {
  TrialSide now, next;
  double duration_s = 0;
};

/// Returns whether the new program's score is lower by more than twice the standard error of the
/// difference.
[[nodiscard]] bool clearly_worse(const TrialFigures& figures);
/// Returns the score in one line, such as
/// "scores 31 ± 6; the program that runs now scores 28 ± 5 (8 runs of 120 s)".
[[nodiscard]] std::string in_words(const TrialFigures& figures);
/// {runs, duration_s, now, next}; each side has score, deposited, collisions and seconds_in_state,
/// each figure {mean, spread}.
[[nodiscard]] nlohmann::json to_json(const TrialFigures& figures);

}  // namespace galilean::monitor
