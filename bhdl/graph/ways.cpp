// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/graph/ways.h"

#include "bhdl/program/machine.h"

namespace galilean::bhdl {
namespace {

bool goes_on(const Condition& before, const Condition& next) {
  return before.bits_variable == next.bits_variable && before.bit_index + 1 == next.bit_index &&
         before.bit_value == next.bit_value && before.bit_update == next.bit_update &&
         before.new_state == next.new_state && before.reset_variables == next.reset_variables;
}

std::string cause_of(const Condition& first, const Condition& last) {
  if (first.bit_index == last.bit_index) return cause(first);
  return first.bits_variable + '[' + std::to_string(first.bit_index) + '-' +
         std::to_string(last.bit_index) + "] is " + (first.bit_value ? '1' : '0');
}

}  // namespace

std::vector<Way> ways_out(const State& state) {
  std::vector<Way> ways;
  const auto& conditions = state.conditions;
  for (std::size_t first = 0; first < conditions.size();) {
    std::size_t last = first;
    while (last + 1 < conditions.size() && goes_on(conditions[last], conditions[last + 1])) ++last;
    ways.push_back({cause_of(conditions[first], conditions[last]), conditions[first].new_state});
    first = last + 1;
  }
  return ways;
}

}  // namespace galilean::bhdl
