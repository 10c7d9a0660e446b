// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "core/result.h"
#include "core/wire/schemas.h"

namespace galilean::monitor {

/// A message as a tree of named fields, in the order of its definition.
using MessageTree = nlohmann::ordered_json;

/// Decodes the messages of one type by the type's definition.
class MessageDecoder {
 public:
  /// Errors: throws std::runtime_error if the definition cannot be read.
  explicit MessageDecoder(const wire::Schema& schema);
  ~MessageDecoder();
  MessageDecoder(MessageDecoder&&) noexcept;

  /// Errors: the bytes are not a whole message of the type.
  [[nodiscard]] Result<MessageTree> decode(std::span<const std::uint8_t> cdr) const;

 private:
  struct Definitions;
  std::unique_ptr<Definitions> definitions_;
};

}  // namespace galilean::monitor
