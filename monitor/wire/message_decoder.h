// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "core/result.h"
#include "core/wire/types/type_description.h"

namespace galilean::monitor {

/// A message as a tree of named fields, in the order of its definition. An enum's value and a
/// bitmask's flags are their names, a list of letters is one text, and what is left out is null. A
/// union has its discriminator under that name, and beside it the field that it selects.
using MessageTree = nlohmann::ordered_json;

/// Decodes the messages of one type by the type's definition.
class MessageDecoder {
 public:
  explicit MessageDecoder(wire::Type type) : type_(std::move(type)) {}

  /// Any bytes may be given. Errors: they are not a whole message of the type.
  [[nodiscard]] Result<MessageTree> decode(std::span<const std::uint8_t> cdr) const;

 private:
  wire::Type type_;
};

}  // namespace galilean::monitor
