// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/type_hash.h"

#include <charconv>

#include "core/wire/announced.h"
#include "core/wire/unwrapped.h"

namespace galilean::wire {

std::string type_hash(const DDS_XTypes_TypeIdentifier& id) {
  return id._d == DDS_XTypes_EK_COMPLETE ? hexadecimal(id._u.equivalence_hash) : std::string();
}

DDS_XTypes_TypeIdentifier type_identifier(std::string_view hash) {
  DDS_XTypes_TypeIdentifier id{};
  id._d = DDS_XTypes_EK_COMPLETE;
  const char* digits = hash.data();
  for (auto& byte : id._u.equivalence_hash)
    std::from_chars(digits, digits + 2, byte, 16), digits += 2;
  return id;
}

}  // namespace galilean::wire
