// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/type_finder.h"

#include <memory>

#include "core/wire/type_hash.h"
#include "core/wire/types/describe_type.h"
#include "core/wire/unwrapped.h"

namespace galilean::wire {
namespace {

struct FreeTypeObject {
  void operator()(dds_typeobj_t* object) const { dds_free_typeobj(object); }
};
using TypeObject = std::unique_ptr<dds_typeobj_t, FreeTypeObject>;

/// Returns nothing if it did not come, or if Cyclone cannot read it.
TypeObject ask_for_type(dds_entity_t participant, const std::string& hash,
                        const std::function<bool()>& give_up) {
  constexpr dds_duration_t kAtOnce = DDS_MSECS(50);
  const auto id = type_identifier(hash);
  dds_typeobj_t* object = nullptr;
  while (dds_get_typeobj(participant, &wrapped(id), kAtOnce, &object) == DDS_RETCODE_TIMEOUT)
    if (give_up()) return {};
  return TypeObject(object);
}

}  // namespace

TypeFinder::TypeFinder(const Participant& participant) : participant_(participant.handle()) {}

Result<Type> TypeFinder::find(const std::string& hash, const std::function<bool()>& give_up) {
  if (const auto known = known_.find(hash); known != known_.end()) return known->second;
  std::map<std::string, TypeObject> objects;
  const auto find_object = [&](const std::string& part) -> Result<const DDS_XTypes_TypeObject*> {
    auto& object = objects[part];
    if (!object) object = ask_for_type(participant_, part, give_up);
    if (!object) return Error{"was not told in time"};
    return &unwrapped(*object);
  };
  auto type = describe_type(type_identifier(hash), find_object);
  if (type) known_[hash] = type.value();
  return type;
}

}  // namespace galilean::wire
