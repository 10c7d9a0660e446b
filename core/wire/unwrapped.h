// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/ddsi_xt_typeinfo.h>
#include <dds/ddsi/ddsi_xt_typemap.h>

namespace galilean::wire {

// Cyclone puts each of these structs of XTypes alone into a struct of its own, of which the public
// headers tell the name only. Both have the same address.

[[nodiscard]] inline const DDS_XTypes_TypeIdentifier& unwrapped(const ddsi_typeid_t& id) {
  return reinterpret_cast<const DDS_XTypes_TypeIdentifier&>(id);
}
[[nodiscard]] inline const DDS_XTypes_TypeObject& unwrapped(const ddsi_typeobj_t& object) {
  return reinterpret_cast<const DDS_XTypes_TypeObject&>(object);
}
[[nodiscard]] inline const DDS_XTypes_TypeMapping& unwrapped(const ddsi_typemap_t& map) {
  return reinterpret_cast<const DDS_XTypes_TypeMapping&>(map);
}
[[nodiscard]] inline const ddsi_typeid_t& wrapped(const DDS_XTypes_TypeIdentifier& id) {
  return reinterpret_cast<const ddsi_typeid_t&>(id);
}

}  // namespace galilean::wire
