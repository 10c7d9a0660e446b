// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/trial/figures.h"

#include <cmath>
#include <cstdio>
#include <set>

#include "core/plural.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;

Figure over(const std::vector<json>& reports, const char* name) {
  std::vector<double> values;
  for (const auto& report : reports) values.push_back(report.at(name).get<double>());
  return figure_of(values);
}

double seconds_in(const json& report, const std::string& state) {
  double sum_s = 0;
  const auto& robots = report.at("robots");
  for (const auto& robot : robots) sum_s += robot.at("seconds_in_state").value(state, 0.0);
  return robots.empty() ? 0 : sum_s / static_cast<double>(robots.size());
}

std::set<std::string> states_of(const std::vector<json>& reports) {
  std::set<std::string> names;
  for (const auto& report : reports)
    for (const auto& robot : report.at("robots"))
      for (const auto& [state, seconds] : robot.at("seconds_in_state").items()) names.insert(state);
  return names;
}

std::string text_of(const Figure& figure) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3g ± %.2g", figure.mean, figure.spread);
  return text;
}

json to_json(const Figure& figure) {
  return {{"mean", figure.mean}, {"spread", figure.spread}};
}

json to_json(const TrialSide& side) {
  auto states = json::object();
  for (const auto& [state, seconds] : side.seconds_in_state) states[state] = to_json(seconds);
  return {{"score", to_json(side.score)},
          {"deposited", to_json(side.deposited)},
          {"collisions", to_json(side.collisions)},
          {"seconds_in_state", std::move(states)}};
}

}  // namespace

Figure figure_of(const std::vector<double>& values) {
  Figure figure;
  if (values.empty()) return figure;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) figure.mean += value / count;
  double squares = 0;
  for (const double value : values) squares += (value - figure.mean) * (value - figure.mean);
  if (values.size() > 1) figure.spread = std::sqrt(squares / (count - 1));
  return figure;
}

Result<TrialSide> side_of(const std::vector<json>& reports) try {
  TrialSide side{.runs = reports.size(),
                 .score = over(reports, "score"),
                 .deposited = over(reports, "deposited"),
                 .collisions = over(reports, "collisions"),
                 .seconds_in_state = {}};
  for (const auto& state : states_of(reports)) {
    std::vector<double> seconds;
    for (const auto& report : reports) seconds.push_back(seconds_in(report, state));
    side.seconds_in_state[state] = figure_of(seconds);
  }
  return side;
} catch (const json::exception& error) {
  return Error{std::string("the simulator's report cannot be read: ") + error.what()};
}

bool clearly_worse(const TrialFigures& figures) {
  if (figures.now.runs == 0 || figures.next.runs == 0) return false;
  const auto squared_error = [](const TrialSide& side) {
    return side.score.spread * side.score.spread / static_cast<double>(side.runs);
  };
  const double error = std::sqrt(squared_error(figures.now) + squared_error(figures.next));
  return figures.next.score.mean < figures.now.score.mean - 2 * error;
}

std::string in_words(const TrialFigures& figures) {
  char runs[64];
  std::snprintf(runs, sizeof runs, " (%s of %g s)", plural(figures.next.runs, "run").c_str(),
                figures.duration_s);
  std::string text = "scores " + text_of(figures.next.score);
  if (figures.now.runs > 0)
    text += "; the program that runs now scores " + text_of(figures.now.score);
  return text + runs;
}

json to_json(const TrialFigures& figures) {
  json result{{"runs", figures.next.runs},
              {"duration_s", figures.duration_s},
              {"next", to_json(figures.next)},
              {"now", nullptr}};
  if (figures.now.runs > 0) result["now"] = to_json(figures.now);
  return result;
}

}  // namespace galilean::monitor
