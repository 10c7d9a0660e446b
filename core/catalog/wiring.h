#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/catalog/value.h"
#include "core/device/devices.h"
#include "core/random.h"
#include "core/variable/store.h"

namespace galilean {

/// What a component under construction is connected to. References are checked before: every name
/// that a program gives exists and has the right type.
struct Wiring {
  VariableStore& variables;
  const Devices& devices;
  Random random;  ///< the component's own stream
};

/// One component's attributes as the loader leaves them: SI, defaults filled in.
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
  /// Of one that is not there yet.
  void add(std::string name, Value value) {
    values_.emplace_back(std::move(name), std::move(value));
  }
  void reserve(std::size_t count) { values_.reserve(count); }
  /// nullptr if it was neither given nor has a default.
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

/// The word that BHDL calls a variable's type by.
template <class T>
[[nodiscard]] constexpr const char* variable_type_name() noexcept;
template <>
constexpr const char* variable_type_name<Shaft>() noexcept {
  return "shaft";
}
template <>
constexpr const char* variable_type_name<Image>() noexcept {
  return "image";
}
template <>
constexpr const char* variable_type_name<Locate>() noexcept {
  return "locate";
}
template <>
constexpr const char* variable_type_name<Bits>() noexcept {
  return "bits";
}
template <>
constexpr const char* variable_type_name<Force>() noexcept {
  return "force";
}

}  // namespace galilean
