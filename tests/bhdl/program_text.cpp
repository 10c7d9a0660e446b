// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bhdl/program_text.h"

#include <sstream>

namespace galilean::bhdl {
namespace {

struct Print {
  std::ostream& out;
  void operator()(const Vec2& pair) const { out << pair.x() << ' ' << pair.y(); }
  template <class Item>
  void operator()(const std::vector<Item>& items) const {
    for (const auto& item : items) out << item << ' ';
  }
  template <class Single>
  void operator()(const Single& value) const {
    out << value;
  }
};

void print(std::ostream& out, const std::vector<Component>& components) {
  for (const auto& component : components) {
    out << component.type << ' ' << component.name << '\n';
    for (const auto& [name, value] : component.attributes) {
      out << "  " << name << ": ";
      std::visit(Print{out}, value);
      out << '\n';
    }
  }
}

void print(std::ostream& out, const State& state) {
  out << "state " << state.name << "\n  ";
  Print{out}(state.perceptual_schemas);
  out << "\n  ";
  Print{out}(state.motor_schemas);
  for (const auto& each : state.conditions) {
    out << "\n  " << each.bits_variable << '[' << each.bit_index << "] " << each.bit_value << ' '
        << to_string(each.bit_update) << " -> " << each.new_state << ' ';
    Print{out}(each.reset_variables);
  }
  out << '\n';
}

}  // namespace

std::string meaning(const Program& program) {
  std::ostringstream out;
  out.precision(17);
  for (const auto* components :
       {&program.devices, &program.variables, &program.perceptual_schemas, &program.motor_schemas})
    print(out, *components);
  for (const auto& state : program.states) print(out, state);
  out << "start " << program.start_state << '\n';
  for (const auto& [old_state, new_state] : program.on_swap)
    out << old_state << " -> " << new_state << '\n';
  return out.str();
}

}  // namespace galilean::bhdl
