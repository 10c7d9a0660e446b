// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/scalar_tree.h"

#include <array>
#include <bit>
#include <charconv>
#include <string>

namespace galilean::monitor {
namespace {

using wire::TypeDescription;
using wire::TypeKind;

/// Returns the bits as a signed number of that size.
std::int64_t signed_of(std::uint64_t bits, int bytes) {
  const int unused = 64 - 8 * bytes;
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

/// Returns a float as the shortest decimal that names it: 0.1 instead of 0.10000000149011612.
double shortest(float value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  double decimal = value;
  std::from_chars(digits.data(), end, decimal);
  return decimal;
}

MessageTree enum_tree(const TypeDescription& type, std::uint64_t bits) {
  for (const auto& constant : type.constants)
    if (is_label(type, bits, constant.value)) return constant.name;
  return signed_of(bits, type.bytes);
}

MessageTree flags_tree(const TypeDescription& type, std::uint64_t bits) {
  auto names = MessageTree::array();
  for (int position = 0; position < 8 * type.bytes; ++position) {
    if (!(bits >> position & 1)) continue;
    std::string name = "bit " + std::to_string(position);
    for (const auto& flag : type.constants)
      if (flag.value == position) name = flag.name;
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

std::uint64_t read_bits(const TypeDescription& type, wire::CdrCursor& cursor) {
  switch (type.bytes) {
    case 1:
      return cursor.read<std::uint8_t>();
    case 2:
      return cursor.read<std::uint16_t>();
    case 4:
      return cursor.read<std::uint32_t>();
    default:
      return cursor.read<std::uint64_t>();
  }
}

bool is_label(const TypeDescription& type, std::uint64_t bits, std::int32_t label) {
  const auto label_bits = static_cast<std::uint64_t>(std::int64_t{label});
  return signed_of(label_bits, type.bytes) == signed_of(bits, type.bytes);
}

MessageTree tree_of_bits(const TypeDescription& type, std::uint64_t bits) {
  switch (type.kind) {
    case TypeKind::kBoolean:
      return bits != 0;
    case TypeKind::kInt8:
    case TypeKind::kInt16:
    case TypeKind::kInt32:
    case TypeKind::kInt64:
      return signed_of(bits, type.bytes);
    case TypeKind::kChar:
      return bits ? std::string(1, static_cast<char>(bits)) : std::string();
    case TypeKind::kEnum:
      return enum_tree(type, bits);
    case TypeKind::kBitmask:
      return flags_tree(type, bits);
    default:
      return bits;
  }
}

MessageTree read_scalar(const TypeDescription& type, wire::CdrCursor& cursor) {
  if (type.kind == TypeKind::kString) return std::string(cursor.read_text());
  const auto bits = read_bits(type, cursor);
  if (type.kind == TypeKind::kFloat)
    return shortest(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (type.kind == TypeKind::kDouble) return std::bit_cast<double>(bits);
  return tree_of_bits(type, bits);
}

}  // namespace galilean::monitor
