// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/wiring_check.h"

#include <algorithm>

#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

Position listed_at(const StateNode& state, const std::string& motor_schema) {
  for (const auto& list : state.attributes) {
    if (section_kind(list.name.text) != ComponentKind::kMotorSchema) continue;
    const auto entry = std::ranges::find(list.values, motor_schema, &ValueNode::text);
    if (entry != list.values.end()) return entry->at;
  }
  return state.keyword.at;
}

std::string schema_in_words(const SchemaUse& use) {
  return use.component->type + " " + in_quotes(use.component->name);
}

/// Checks one state after the other. Its notes on variables are cleared between them.
class StateWiring {
 public:
  StateWiring(const Program& program, const SchemaUses& uses, Diagnostics& diagnostics)
      : program_(program),
        uses_(uses),
        diagnostics_(diagnostics),
        writer_(program.variables.size(), kNobody),
        last_reader_(program.variables.size(), kNobody) {}

  void check(std::size_t state, const StateNode& node) {
    state_ = &program_.states[state];
    node_ = &node;
    listed_ = &uses_.listed(state);
    note_readers();
    unread_.clear();
    for (std::size_t i = 0; i < listed_->motor.size(); ++i) {
      check_writer(i);
      check_result(i);
      check_driver(i);
    }
    if (!unread_.empty()) warn_of_unread();
    wipe();
  }

 private:
  struct Result {
    std::size_t schema = 0;
    std::size_t variable = 0;
  };

  // Perceptual schemas and conditions read what the tick before left. Every motor schema writes in
  // time for them.
  void note_readers() {
    const std::size_t behind_all = listed_->motor.size();
    for (std::size_t i = 0; i < listed_->motor.size(); ++i)
      for (const std::size_t variable : listed_->motor[i]->reads) last_reader_[variable] = i;
    for (const auto* use : listed_->perceptual)
      for (const std::size_t variable : use->reads) last_reader_[variable] = behind_all;
    for (const auto& condition : state_->conditions)
      last_reader_[uses_.variable(condition.bits_variable)] = behind_all;
  }

  void wipe() {
    for (const auto* schemas : {&listed_->perceptual, &listed_->motor})
      for (const auto* use : *schemas)
        for (const auto* variables : {&use->reads, &use->writes})
          for (const std::size_t variable : *variables)
            writer_[variable] = last_reader_[variable] = kNobody;
    for (const auto& condition : state_->conditions)
      last_reader_[uses_.variable(condition.bits_variable)] = kNobody;
  }

  void check_writer(std::size_t schema) {
    for (const std::size_t variable : listed_->motor[schema]->writes) {
      const std::size_t first = writer_[variable];
      writer_[variable] = schema;
      if (first == kNobody) continue;
      warn(schema, "state/two-writers",
           schema_in_words(*listed_->motor[schema]) + " overwrites " + name(variable) + ", which " +
               schema_in_words(*listed_->motor[first]) + " wrote in the same tick",
           "give each its own result and add them with a schema that combines forces");
    }
  }

  void check_result(std::size_t schema) {
    for (const std::size_t variable : listed_->motor[schema]->writes) {
      const std::size_t reader = last_reader_[variable];
      if (reader == kNobody)
        unread_.push_back({schema, variable});
      else if (reader < schema)
        warn(schema, "state/late-result",
             schema_in_words(*listed_->motor[schema]) + " writes " + name(variable) + " after " +
                 schema_in_words(*listed_->motor[reader]) + " has read it: schemas run as listed",
             "list it before");
    }
  }

  // All results that nothing reads share one warning, because mostly one schema that would read
  // them is missing.
  void warn_of_unread() {
    constexpr std::size_t kMostNamed = 3;
    std::string results;
    for (std::size_t i = 0; i < std::min(unread_.size(), kMostNamed); ++i)
      results += (i == 0 ? "" : ", nor ") + name(unread_[i].variable) + ", the result of " +
                 schema_in_words(*listed_->motor[unread_[i].schema]);
    if (unread_.size() > kMostNamed)
      results += ", nor " + std::to_string(unread_.size() - kMostNamed) + " more";
    warn(unread_.front().schema, "state/unread-result", "nothing reads " + results,
         "list a schema that reads it, or take away what writes it");
  }

  void check_driver(std::size_t schema) {
    const std::string& device = listed_->motor[schema]->spec->drives;
    if (device.empty()) return;
    for (std::size_t i = 0; i < schema; ++i) {
      if (listed_->motor[i]->spec->drives != device) continue;
      return warn(schema, "state/two-drivers",
                  schema_in_words(*listed_->motor[schema]) + " drives the " + device + ", as " +
                      schema_in_words(*listed_->motor[i]) +
                      " does: the last command of a tick counts",
                  "leave one of them in this state");
    }
  }

  void warn(std::size_t schema, std::string_view code, std::string message, std::string hint) {
    diagnostics_.warning(listed_at(*node_, listed_->motor[schema]->component->name), code,
                         "in the state " + in_quotes(state_->name) + ", " + message,
                         std::move(hint));
  }

  [[nodiscard]] std::string name(std::size_t variable) const {
    return in_quotes(program_.variables[variable].name);
  }

  const Program& program_;
  const SchemaUses& uses_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> writer_;       ///< for each variable, which of the state's motor schemas
                                          ///< writes it
  std::vector<std::size_t> last_reader_;  ///< the count of motor schemas stands for a perceptual
                                          ///< schema or a condition
  std::vector<Result> unread_;            ///< of this state
  const State* state_ = nullptr;
  const StateNode* node_ = nullptr;
  const SchemaUses::Listed* listed_ = nullptr;
};

}  // namespace

void warn_of_wiring(const Program& program, const SchemaUses& uses, const SyntaxTree& tree,
                    Diagnostics& diagnostics) {
  StateWiring wiring(program, uses, diagnostics);
  std::size_t state = 0;
  for (const auto& node : tree)
    if (const auto* found = std::get_if<StateNode>(&node)) wiring.check(state++, *found);
}

}  // namespace galilean::bhdl
