// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/attribute_values.h"

namespace galilean::bhdl {

/// Returns an attribute's content. A value that was refused gives an empty T; its program is not
/// used.
template <class T>
[[nodiscard]] T value_or_nothing(const AttributeValues& values, std::string_view name) {
  const Value* value = values.find(name);
  const T* content = value == nullptr ? nullptr : std::get_if<T>(value);
  return content == nullptr ? T{} : *content;
}

}  // namespace galilean::bhdl
