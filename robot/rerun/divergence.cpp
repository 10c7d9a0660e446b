// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/divergence.h"

#include <algorithm>
#include <bit>
#include <set>

#include "core/state_change.h"
#include "core/visible_text.h"
#include "robot/rerun/variable_text.h"

namespace galilean::robot {
namespace {

/// What one of the two ticks shows in words.
struct Side {
  std::string state;
  std::string way;                ///< "wander -> grab", if a condition fired
  std::string change;             ///< the same with the condition
  std::set<std::string> touched;  ///< variables that the condition updated or reset
  std::string motion;
  std::string gripper;
};

std::string gripper_text(int order) {
  if (order == 0) return "nothing";
  return order == 1 ? "to open" : "to close";
}

int gripper_number(const TickOutcome& outcome) {
  if (!outcome.gripper) return 0;
  return *outcome.gripper == GripperCommand::kOpen ? 1 : 2;
}

std::string quoted(const std::string& text) {
  return '\'' + visible(text) + '\'';
}

/// Returns null if no condition fired, or one that the program does not have.
const bhdl::Condition* fired_condition(const RunningProgram& program, std::uint32_t left,
                                       std::uint32_t fired) {
  const auto& states = program.text().states;
  const bool there = left < states.size() && fired < states[left].conditions.size();
  return there ? &states[left].conditions[fired] : nullptr;
}

/// Sets `way`, `touched` and `change`: "wander -> grab by office.bhdl:12: trash_seen[0] is 1".
void describe_change(const RunningProgram* program, std::uint32_t left, std::uint32_t fired,
                     Side& side) {
  side.change = fired == Event::kNone ? "no condition fires"
                                      : "condition " + std::to_string(fired) + " fires";
  const auto* condition = program ? fired_condition(*program, left, fired) : nullptr;
  if (!condition) return;
  side.way = visible(change_words(program->text().states[left].name, condition->new_state));
  side.change = side.way + " by " + visible(condition->location.file) + ':' +
                std::to_string(condition->location.line) + ": " +
                visible(condition->bits_variable) + '[' + std::to_string(condition->bit_index) +
                "] is " + (condition->bit_value ? '1' : '0');
  side.touched = {condition->reset_variables.begin(), condition->reset_variables.end()};
  if (condition->bit_update != bhdl::BitUpdate::kSame)
    side.touched.insert(condition->bits_variable);
}

/// Returns the indices of the variables that a schema writes.
std::set<std::size_t> outputs_of(const RunningProgram& program, std::uint32_t schema) {
  std::set<std::size_t> outputs;
  std::size_t at = 0;
  program.variables.for_each([&](const auto& variable) {
    for (const VariableRef& output : program.schemas[schema].outputs())
      if (std::visit([&](auto* each) { return static_cast<const void*>(each) == &variable; },
                     output))
        outputs.insert(at);
    ++at;
  });
  return outputs;
}

/// Finds what in a tick comes first of all that differs. Variables are those of one program.
class Cause {
 public:
  Cause(const RunningProgram& program, const std::set<std::size_t>& different)
      : program_(program), different_(different) {}

  [[nodiscard]] std::string dead_reckoning() const {
    if (different_.empty() || *different_.begin() >= program_.variables.all<Shaft>().size())
      return "";
    return "dead reckoning: the shaft " +
           quoted(program_.description->variables[*different_.begin()].name);
  }
  [[nodiscard]] std::string schema(const std::vector<std::uint32_t>& listed, const char* kind,
                                   const std::vector<bhdl::Component>& texts) const {
    for (const std::uint32_t schema : listed)
      for (const std::size_t output : outputs_of(program_, schema))
        if (different_.contains(output)) return schema_text(schema, kind, texts, output);
    return "";
  }

 private:
  [[nodiscard]] std::string schema_text(std::uint32_t schema, const char* kind,
                                        const std::vector<bhdl::Component>& texts,
                                        std::size_t output) const {
    const auto& description = *program_.description;
    const std::string& name = description.schemas[schema];
    std::string text = std::string(kind) + " schema " + quoted(name);
    const auto found = std::ranges::find(texts, name, &bhdl::Component::name);
    if (found != texts.end())
      text += " (" + found->type + ", " + visible(found->location.file) + ':' +
              std::to_string(found->location.line) + ')';
    return text + ", which writes " + quoted(description.variables[output].name);
  }

  const RunningProgram& program_;
  const std::set<std::size_t>& different_;
};

/// Returns those that differed already when the conditions were tried, as far as that is known.
std::set<std::size_t> before_sequencing(const std::set<std::size_t>& different,
                                        const RunningProgram& program, const Side& recorded,
                                        const Side& now) {
  if (recorded.way == now.way) return different;
  std::set<std::size_t> before;
  for (const std::size_t index : different) {
    const std::string& name = program.description->variables[index].name;
    if (!recorded.touched.contains(name) && !now.touched.contains(name)) before.insert(index);
  }
  return before;
}

/// Goes through the tick in its order: dead reckoning, perceive, sequence, act.
std::string cause_of(const RecordedRobot& robot, const std::set<std::size_t>& different,
                     const Side& recorded, const Side& now) {
  const RunningProgram* program = robot.program();
  if (!program) return "the program: none runs";
  const auto perceived = before_sequencing(different, *program, recorded, now);
  const Cause earlier(*program, perceived), cause(*program, different);
  const auto& perceived_in = program->states[robot.perceived_in()];
  const auto& text = program->text();
  if (auto found = earlier.dead_reckoning(); !found.empty()) return found;
  if (auto found =
          earlier.schema(perceived_in.perceptual_schemas, "perceptual", text.perceptual_schemas);
      !found.empty())
    return found;
  if (recorded.state != now.state || recorded.way != now.way)
    return "condition: recorded " + recorded.change + ", now " + now.change;
  const auto& acts_in = program->states[program->state];
  if (auto found = cause.schema(acts_in.motor_schemas, "motor", text.motor_schemas); !found.empty())
    return found;
  if (!different.empty())
    return "variable " + quoted(program->description->variables[*different.begin()].name) +
           ", which no schema of the state writes";
  if (recorded.motion != now.motion) return "what the motors are ordered";
  if (recorded.gripper != now.gripper) return "what the gripper is ordered";
  return "pose, standstill, probation, overruns, failed schemas or the number of transitions";
}

void tell(const std::string& what, const std::string& recorded, const std::string& now,
          std::vector<std::string>& details) {
  if (recorded != now) details.push_back(what + ": recorded " + recorded + "; now " + now);
}

void tell_states(const Side& recorded, const Side& now, std::vector<std::string>& details) {
  tell("state", quoted(recorded.state), quoted(now.state), details);
  tell("condition", recorded.change, now.change, details);
  tell("motors", recorded.motion, now.motion, details);
  tell("gripper", recorded.gripper, now.gripper, details);
}

Side side_of(const RecordedRobot& robot) {
  const TickOutcome& outcome = robot.outcome();
  Side side{.state = std::string(robot.state_name()),
            .motion = motion_text(outcome.motion),
            .gripper = gripper_text(gripper_number(outcome))};
  describe_change(robot.program(), robot.perceived_in(), outcome.fired, side);
  return side;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_motion(const msg::TickOutcome& recorded, const MotionOrders& now) {
  return recorded.motion_orders == now.count && recorded.stops == now.stop &&
         same_bits(recorded.speed_mps, now.last.speed_mps) &&
         same_bits(recorded.turn_rate_radps, now.last.turn_rate_radps) &&
         same_bits(recorded.distance_limit_m, now.last.distance_limit_m) &&
         same_bits(recorded.angle_limit_rad, now.last.angle_limit_rad);
}

/// Which condition fired before is known by its number; the state that it left is known if this
/// run was in it, too.
Side side_of(const msg::TickOutcome& recorded, const RecordedRobot& again) {
  const MotionOrders motion{recorded.motion_orders,
                            recorded.stops,
                            {recorded.speed_mps, recorded.turn_rate_radps,
                             recorded.distance_limit_m, recorded.angle_limit_rad}};
  Side side{.state = recorded.state,
            .motion = motion_text(motion),
            .gripper = gripper_text(recorded.gripper)};
  const auto fired = recorded.fired < 0 ? Event::kNone : static_cast<std::uint32_t>(recorded.fired);
  describe_change(again.program(), again.perceived_in(), fired, side);
  return side;
}

std::int32_t number_of(std::uint32_t fired) {
  return fired == Event::kNone ? -1 : static_cast<std::int32_t>(fired);
}

std::set<std::size_t> different_variables(const msg::TickOutcome& recorded,
                                          const TickOutcome& now) {
  std::set<std::size_t> different;
  const std::size_t both = std::min(recorded.variables.size(), now.variables.size());
  for (std::size_t i = 0; i < both; ++i)
    if (recorded.variables[i] != now.variables[i]) different.insert(i);
  return different;
}

}  // namespace

std::optional<Divergence> compare(const msg::TickOutcome& recorded, const RecordedRobot& again) {
  const TickOutcome& now = again.outcome();
  const auto different = different_variables(recorded, now);
  const bool same_size = recorded.variables.size() == now.variables.size();
  const Side before = side_of(recorded, again), after = side_of(again);
  const bool same = different.empty() && same_size && recorded.program == now.program &&
                    recorded.state == after.state && recorded.transitions == now.transitions &&
                    recorded.fired == number_of(now.fired) && same_motion(recorded, now.motion) &&
                    recorded.gripper == gripper_number(now) && recorded.rest == now.rest;
  if (same) return std::nullopt;
  Divergence found{.cause = recorded.program != now.program || !same_size
                                ? "the program: another one runs than in the recording"
                                : cause_of(again, different, before, after)};
  for (const std::size_t index : different)
    found.details.push_back("now " + variable_text(*again.program(), index));
  tell_states(before, after, found.details);
  return found;
}

std::optional<Divergence> compare(const RecordedRobot& recorded, const RecordedRobot& other) {
  if (!recorded.program() || !other.program()) return std::nullopt;
  const Side before = side_of(recorded), after = side_of(other);
  const auto& old_labels = recorded.program()->description->variables;
  const auto& new_labels = other.program()->description->variables;
  std::set<std::size_t> different;  // variables of the other program
  std::vector<std::string> details;
  for (std::size_t n = 0; n < new_labels.size(); ++n)
    for (std::size_t o = 0; o < old_labels.size(); ++o) {
      if (old_labels[o].name != new_labels[n].name || old_labels[o].type != new_labels[n].type ||
          recorded.outcome().variables[o] == other.outcome().variables[n])
        continue;
      different.insert(n);
      details.push_back("recorded " + variable_text(*recorded.program(), o));
      details.push_back("now      " + variable_text(*other.program(), n));
    }
  const bool same = different.empty() && before.state == after.state && before.way == after.way &&
                    before.motion == after.motion && before.gripper == after.gripper;
  if (same) return std::nullopt;
  Divergence found{.cause = cause_of(other, different, before, after),
                   .details = std::move(details)};
  tell_states(before, after, found.details);
  return found;
}

}  // namespace galilean::robot
