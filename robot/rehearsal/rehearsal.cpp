// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rehearsal/rehearsal.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bhdl/source/text.h"
#include "robot/components.h"
#include "robot/executive/executive.h"
#include "robot/rehearsal/given_program.h"
#include "robot/rehearsal/given_schemas.h"
#include "robot/rehearsal/still_devices.h"
#include "robot/rehearsal/timeline.h"

namespace galilean::robot {
namespace {

using bhdl::Claim;
using bhdl::in_quotes;
using bhdl::number_text;

constexpr Duration kTick = std::chrono::milliseconds(50);
constexpr std::size_t kMostTransitions = 6;

std::string seconds(double time_s) {
  return number_text(time_s) + " s";
}

/// Returns the end of a claim's time, which is cut where the rehearsal ends.
double end_of(const Claim& claim, double lasts_s) {
  return std::min(claim.until_s, lasts_s);
}

class ClaimCheck {
 public:
  ClaimCheck(const Timeline& timeline, double lasts_s) : timeline_(timeline), lasts_s_(lasts_s) {}

  /// Returns why the claim did not come true, or an empty text if it did.
  [[nodiscard]] std::string failure(const Claim& claim) const {
    switch (claim.kind) {
      case Claim::Kind::kReaches:
        return reaches(claim);
      case Claim::Kind::kStays:
        return stays(claim);
      case Claim::Kind::kNever:
        return never(claim);
    }
    return {};
  }

 private:
  [[nodiscard]] std::string reaches(const Claim& claim) const {
    if (first_in(claim) != nullptr) return {};
    return "the state " + in_quotes(claim.state) + " is not reached by " + seconds(claim.until_s) +
           "; " + state_at(claim.until_s);
  }

  [[nodiscard]] std::string stays(const Claim& claim) const {
    const auto& at_first = timeline_.at(claim.from_s);
    const std::string expected = "the state is not " + in_quotes(claim.state) + " from " +
                                 seconds(claim.from_s) + " to " + seconds(claim.until_s) + "; ";
    if (timeline_.state_name(at_first) != claim.state) return expected + state_at(claim.from_s);
    for (const auto& stay : timeline_.stays())
      if (stay.from_s > claim.from_s && stay.from_s <= claim.until_s &&
          timeline_.state_name(stay) != claim.state)
        return expected + state_at(stay.from_s);
    return {};
  }

  [[nodiscard]] std::string never(const Claim& claim) const {
    const Timeline::Stay* stay = first_in(claim);
    if (stay == nullptr) return {};
    return "the state " + in_quotes(claim.state) + " is current at " +
           seconds(std::max(stay->from_s, claim.from_s));
  }

  /// Returns the first stay in the claim's state within the claim's time, or nullptr.
  [[nodiscard]] const Timeline::Stay* first_in(const Claim& claim) const {
    const auto& stays = timeline_.stays();
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const bool ends_before = i + 1 < stays.size() && stays[i + 1].from_s <= claim.from_s;
      if (ends_before || stays[i].from_s > end_of(claim, lasts_s_)) continue;
      if (timeline_.state_name(stays[i]) == claim.state) return &stays[i];
    }
    return nullptr;
  }

  [[nodiscard]] std::string state_at(double time_s) const {
    const auto& stay = timeline_.at(time_s);
    return "at " + seconds(time_s) + " it is " + in_quotes(timeline_.state_name(stay)) +
           ", since " + seconds(stay.from_s);
  }

  const Timeline& timeline_;
  double lasts_s_;
};

std::vector<std::string> last_transitions(const Timeline& timeline) {
  const std::size_t count = timeline.stays().size();
  std::vector<std::string> words;
  for (std::size_t i = count > kMostTransitions ? count - kMostTransitions : 0; i < count; ++i)
    words.push_back(timeline.in_words(i));
  return words;
}

/// Runs the program. Returns why it could not run, or which schema failed; else an empty text.
std::string run(const bhdl::Program& program, double lasts_s, Timeline& timeline) {
  StillPort port;
  StillDrive drive;
  StillCamera camera;
  SteppedClock clock;
  const SteppedClock stopwatch;
  Executive executive({.components = rehearsal_components(),
                       .devices = {port, drive, camera},
                       .clock = clock,
                       .stopwatch = stopwatch,
                       .tick_period = kTick,
                       .observers = {&timeline}});
  const auto loaded = executive.load(program);
  if (!loaded) return loaded.error().message;
  for (; clock.now() <= Time{from_seconds(lasts_s)}; clock.advance(kTick)) executive.tick();
  return timeline.failure();
}

}  // namespace

const Registry& rehearsal_components() {
  static const Registry registry = [] {
    Registry made;
    add_components(made);
    add_given_schemas(made);
    return made;
  }();
  return registry;
}

ExpectationOutcome rehearse(const bhdl::Program& program, const bhdl::Expectation& expectation) {
  const auto given = with_givens(program, expectation, rehearsal_components().catalog());
  Timeline timeline(given);
  ExpectationOutcome verdict{.name = expectation.name, .location = expectation.location};
  const std::string problem = run(given, expectation.lasts_s, timeline);
  if (!problem.empty()) verdict.failures.push_back({expectation.location, problem});
  const ClaimCheck check(timeline, expectation.lasts_s);
  for (const auto& claim : expectation.claims)
    if (auto message = check.failure(claim); !message.empty())
      verdict.failures.push_back({claim.location, std::move(message)});
  verdict.transitions = last_transitions(timeline);
  return verdict;
}

std::string in_words(const ExpectationOutcome& verdict) {
  const auto place = [](const bhdl::Location& at) {
    return at.file + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) + ": ";
  };
  if (verdict.passed()) return place(verdict.location) + "passed: " + verdict.name + '\n';
  std::string text;
  for (const auto& failure : verdict.failures)
    text += place(failure.location) + "failed: " + verdict.name + ": " + failure.message + '\n';
  for (const auto& each : verdict.transitions) text += "  " + each + '\n';
  return text;
}

void to_json(nlohmann::json& json, const ExpectationOutcome& verdict) {
  json = {{"name", verdict.name},
          {"file", verdict.location.file},
          {"line", verdict.location.line},
          {"passed", verdict.passed()},
          {"failures", nlohmann::json::array()},
          {"transitions", verdict.transitions}};
  for (const auto& failure : verdict.failures)
    json["failures"].push_back({{"file", failure.location.file},
                                {"line", failure.location.line},
                                {"column", failure.location.column},
                                {"message", failure.message}});
}

}  // namespace galilean::robot
