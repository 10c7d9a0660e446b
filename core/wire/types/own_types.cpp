// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/own_types.h"

#include <map>
#include <memory>
#include <span>

#include "core/wire/lending.h"
#include "core/wire/schemas.h"
#include "core/wire/type_hash.h"
#include "core/wire/types/describe_type.h"
#include "core/wire/unwrapped.h"

namespace galilean::wire {
namespace {

struct FreeTypeInfo {
  void operator()(ddsi_typeinfo_t* info) const { dds_free_typeinfo(info); }
};
struct FreeTypeMap {
  void operator()(ddsi_typemap_t* map) const {
    ddsi_typemap_fini(map);
    dds_free(map);
  }
};

/// Cyclone only reads it.
ddsi_sertype_cdr_data encoded(const dds_type_meta_ser& data) {
  return {data.sz, data.data};
}

std::map<std::string_view, OwnType> own_types() {
  std::map<std::string_view, OwnType> types;
  for (const auto& schema : schemas())
    if (const auto* descriptor = msg::descriptor_of(schema.ros_type))
      if (auto type = describe_descriptor(*descriptor))
        types.emplace(schema.dds_type, std::move(type).value());
  return types;
}

}  // namespace

Result<OwnType> describe_descriptor(const dds_topic_descriptor& descriptor) {
  const auto info_bytes = encoded(descriptor.type_information);
  const auto map_bytes = encoded(descriptor.type_mapping);
  const std::unique_ptr<ddsi_typeinfo_t, FreeTypeInfo> info(ddsi_typeinfo_deser(&info_bytes));
  const std::unique_ptr<ddsi_typemap_t, FreeTypeMap> map(ddsi_typemap_deser(&map_bytes));
  if (!info || !map) return Error{"has no type information"};
  const auto& pairs = unwrapped(*map).identifier_object_pair_complete;
  const auto find_object = [&](const std::string& hash) -> Result<const DDS_XTypes_TypeObject*> {
    for (const auto& pair : std::span(pairs._buffer, pairs._length))
      if (type_hash(pair.type_identifier) == hash) return &pair.type_object;
    return Error{"lacks a part"};
  };
  const auto& id = unwrapped(*ddsi_typeinfo_complete_typeid(info.get()));
  auto description = describe_type(id, find_object);
  if (!description) return description.error();
  return OwnType{type_hash(id), std::move(description).value()};
}

const OwnType* find_own_type(std::string_view dds_type) {
  static const std::map<std::string_view, OwnType> kOwnTypes = own_types();
  const auto found = kOwnTypes.find(dds_type);
  return found == kOwnTypes.end() ? nullptr : &found->second;
}

}  // namespace galilean::wire
