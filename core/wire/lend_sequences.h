// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/wire/lending.h"

namespace galilean::msg {

/// Lends numbers and strings where the C++ message has them, because Cyclone only reads them.
template <class T, class Sequence>
void lend_numbers(const std::vector<T>& from, Sequence& to) {
  using Element = std::remove_pointer_t<decltype(to._buffer)>;
  static_assert(sizeof(Element) == sizeof(T));
  to._buffer = reinterpret_cast<Element*>(const_cast<T*>(from.data()));
  to._length = to._maximum = static_cast<std::uint32_t>(from.size());
  to._release = false;
}

template <class Sequence>
void lend_strings(const std::vector<std::string>& from, Sequence& to, Arena& arena) {
  to._buffer = static_cast<char**>(arena.allocate(from.size() * sizeof(char*) + 1, alignof(char*)));
  for (std::size_t i = 0; i < from.size(); ++i) to._buffer[i] = const_cast<char*>(from[i].c_str());
  to._length = to._maximum = static_cast<std::uint32_t>(from.size());
  to._release = false;
}

template <class T, class Sequence>
void lend_structs(const std::vector<T>& from, Sequence& to, Arena& arena) {
  using Element = typename Lent<T>::type;
  to._buffer =
      static_cast<Element*>(arena.allocate(from.size() * sizeof(Element) + 1, alignof(Element)));
  for (std::size_t i = 0; i < from.size(); ++i) lend(from[i], to._buffer[i], arena);
  to._length = to._maximum = static_cast<std::uint32_t>(from.size());
  to._release = false;
}

}  // namespace galilean::msg
