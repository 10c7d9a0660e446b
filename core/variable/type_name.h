// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/variable/variable.h"

namespace galilean {

/// Returns the word that BHDL uses for the type of a Variable<T>.
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
