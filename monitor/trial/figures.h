// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::monitor {

/// The mean of one measure over several runs, and its sample standard deviation.
struct Figure {
  double mean = 0;
  double spread = 0;
};
/// Returns zeros if there are no values.
[[nodiscard]] Figure figure_of(const std::vector<double>& values);

/// The results of several simulated contests with one program, for the whole team.
struct TrialSide {
  std::size_t runs = 0;
  Figure score, deposited, collisions;
  std::map<std::string, Figure> seconds_in_state;  ///< by state; the average of the robots
};
/// Summarizes the reports that `galilean sim --headless --json` printed.
/// Errors: a report lacks a member.
[[nodiscard]] Result<TrialSide> side_of(const std::vector<nlohmann::json>& reports);

/// The results of the new program (`next`) and of the program that runs now (`now`). `now.runs` is
/// 0 if none runs.
struct TrialFigures {
  TrialSide now, next;
  double duration_s = 0;  ///< simulated time of each run
};

/// Returns whether the new program's mean score is lower by more than twice the standard error of
/// the difference. Returns false if one of the programs has no runs.
[[nodiscard]] bool clearly_worse(const TrialFigures& figures);
/// Returns the score in one line, such as
/// "scores 31 ± 6; the program that runs now scores 28 ± 5 (8 runs of 120 s)".
[[nodiscard]] std::string in_words(const TrialFigures& figures);
/// Returns {runs, duration_s, now, next}. `now` and `next` have score, deposited, collisions and
/// seconds_in_state, and each figure is {mean, spread}. `now` is null if no program runs.
[[nodiscard]] nlohmann::json to_json(const TrialFigures& figures);

}  // namespace galilean::monitor
