// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/describe_type.h"

#include "core/wire/types/type_describer.h"

namespace galilean::wire {

Result<Type> describe_type(const DDS_XTypes_TypeIdentifier& id, const FindTypeObject& find) try {
  return TypeDescriber(find).describe(id, {});
} catch (const Indescribable& reason) {
  return Error{reason.what()};
}

}  // namespace galilean::wire
