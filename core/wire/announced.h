// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <string>

#include "core/hexadecimal.h"
#include "core/wire/address.h"

namespace galilean::wire {

using galilean::hexadecimal;

[[nodiscard]] inline std::string hexadecimal(const dds_guid_t& guid) {
  return galilean::hexadecimal(guid.v);
}

/// Returns the name that an entity announced, or an empty text if it announced none.
[[nodiscard]] inline std::string announced_name(const dds_qos_t* qos) {
  char* name = nullptr;
  if (!dds_qget_entity_name(qos, &name) || !name) return {};
  std::string copy = name;
  dds_free(name);
  return copy;
}

/// Returns the address that a participant announced, without a port, or an empty text if there is
/// none. Cyclone lists in that property where it hears the participant.
[[nodiscard]] inline std::string announced_address(const dds_qos_t* qos) {
  char* locators = nullptr;
  if (!dds_qget_prop(qos, "__NetworkAddresses", &locators) || !locators) return {};
  const std::string list = locators;
  dds_free(locators);
  return address_in(list);
}

}  // namespace galilean::wire
