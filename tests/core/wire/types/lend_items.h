// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

namespace galilean::wire {

/// Lends `items` to a sequence of C.
template <class Sequence, class Item, std::size_t kCount>
void lend_items(Sequence& to, std::array<Item, kCount>& items) {
  using Element = std::remove_pointer_t<decltype(to._buffer)>;
  static_assert(sizeof(Element) == sizeof(Item));
  to._buffer = reinterpret_cast<Element*>(items.data());
  to._length = to._maximum = static_cast<std::uint32_t>(kCount);
  to._release = false;
}

[[nodiscard]] inline char* words(const char* literal) {
  return const_cast<char*>(literal);
}

}  // namespace galilean::wire
