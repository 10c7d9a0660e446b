// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string_view>
#include <tuple>

#include "core/variable/variable.h"

namespace galilean {

/// All variables of one program. Their addresses do not change while the store lives, so that
/// schemas can hold plain pointers. It is filled when the program is built, never in a tick.
class VariableStore {
 public:
  VariableStore() = default;
  VariableStore(const VariableStore&) = delete;
  VariableStore& operator=(const VariableStore&) = delete;

  template <class T>
  Variable<T>& add(std::string name) {
    auto& variable = all<T>().emplace_back();
    variable.name = std::move(name);
    return variable;
  }

  /// Returns nullptr if there is no variable of that name and type.
  template <class T>
  [[nodiscard]] Variable<T>* find(std::string_view name) noexcept {
    for (auto& variable : all<T>())
      if (variable.name == name) return &variable;
    return nullptr;
  }

  template <class T>
  [[nodiscard]] std::deque<Variable<T>>& all() noexcept {
    return std::get<std::deque<Variable<T>>>(variables_);
  }
  template <class T>
  [[nodiscard]] const std::deque<Variable<T>>& all() const noexcept {
    return std::get<std::deque<Variable<T>>>(variables_);
  }

  /// Returns the reliability of the variable of that name, whatever its type, or nullptr if there
  /// is no such variable.
  [[nodiscard]] Reliability* find_reliability(std::string_view name) noexcept {
    Reliability* found = nullptr;
    for_each([&](auto& variable) {
      if (!found && variable.name == name) found = &variable.reliability;
    });
    return found;
  }

  /// Calls `visit(Variable<T>&)` for every variable, type by type, in the order of the program.
  template <class Visitor>
  void for_each(Visitor&& visit) {
    std::apply([&](auto&... list) { (visit_list(list, visit), ...); }, variables_);
  }
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    std::apply([&](const auto&... list) { (visit_list(list, visit), ...); }, variables_);
  }

 private:
  template <class List, class Visitor>
  static void visit_list(List& list, Visitor& visit) {
    for (auto& variable : list) visit(variable);
  }

  std::tuple<std::deque<Variable<Shaft>>, std::deque<Variable<Image>>, std::deque<Variable<Locate>>,
             std::deque<Variable<Bits>>, std::deque<Variable<Force>>>
      variables_;
};

}  // namespace galilean
