// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/catalog/value.h"

namespace galilean {

/// The attributes of one component. The checker has converted the numbers to SI units, and has
/// filled in the defaults.
class AttributeValues {
 public:
  void set(std::string name, Value value) {
    for (auto& [known, current] : values_)
      if (known == name) {
        current = std::move(value);
        return;
      }
    values_.emplace_back(std::move(name), std::move(value));
  }
  /// Adds an attribute. Requires: no attribute of this name was added before.
  void add(std::string name, Value value) {
    values_.emplace_back(std::move(name), std::move(value));
  }
  void reserve(std::size_t count) { values_.reserve(count); }
  /// Returns the value, or nullptr if the attribute was neither given nor has a default.
  [[nodiscard]] const Value* find(std::string_view name) const noexcept {
    for (const auto& [known, value] : values_)
      if (known == name) return &value;
    return nullptr;
  }
  template <class T>
  [[nodiscard]] const T& get(std::string_view name) const {
    return std::get<T>(*find(name));
  }
  [[nodiscard]] auto begin() const noexcept { return values_.begin(); }
  [[nodiscard]] auto end() const noexcept { return values_.end(); }

 private:
  std::vector<std::pair<std::string, Value>> values_;
};

}  // namespace galilean
