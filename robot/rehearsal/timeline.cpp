// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rehearsal/timeline.h"

#include <algorithm>

#include "bhdl/program/machine.h"
#include "bhdl/source/text.h"

namespace galilean::robot {
namespace {

/// Returns the name of a schema that an event names by its index.
const std::string& schema_name(const bhdl::Program& program, std::size_t schema) {
  const auto& perceptual = program.perceptual_schemas;
  return schema < perceptual.size() ? perceptual[schema].name
                                    : program.motor_schemas[schema - perceptual.size()].name;
}

}  // namespace

Timeline::Timeline(const bhdl::Program& program) : program_(program) {
  const auto start = std::ranges::find(program.states, program.start_state, &bhdl::State::name);
  stays_.push_back({static_cast<std::uint32_t>(start - program.states.begin())});
}

// A rehearsal is no control loop, so that this observer may allocate.
void Timeline::on_event(const Event& event) noexcept {
  const double time_s = to_seconds(event.time.time_since_epoch());
  if (event.kind == Event::Kind::kTransition)
    stays_.push_back({event.to_state, time_s, event.condition});
  if (event.kind == Event::Kind::kSchemaFailed && failure_.empty())
    failure_ = "schema " + bhdl::in_quotes(schema_name(program_, event.schema)) + " threw at " +
               bhdl::number_text(time_s) + " s: " + std::string(event.text.view());
}

const Timeline::Stay& Timeline::at(double time_s) const {
  const auto next =
      std::ranges::find_if(stays_, [time_s](const Stay& each) { return each.from_s > time_s; });
  return next == stays_.begin() ? stays_.front() : *(next - 1);
}

std::string Timeline::in_words(std::size_t stay) const {
  const Stay& here = stays_[stay];
  const std::string time = bhdl::number_text(here.from_s) + " s: ";
  if (stay == 0) return time + "starts in " + state_name(here);
  const auto& before = program_.states[stays_[stay - 1].state];
  std::string text = time + before.name + " → " + state_name(here);
  if (here.condition < before.conditions.size())
    text += ", since " + bhdl::cause(before.conditions[here.condition]);
  return text;
}

}  // namespace galilean::robot
