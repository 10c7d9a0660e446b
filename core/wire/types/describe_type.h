// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/result.h"
#include "core/wire/types/type_description.h"

struct DDS_XTypes_TypeIdentifier;
struct DDS_XTypes_TypeObject;

namespace galilean::wire {

/// Returns the object that defines the type of a hash. It must live until describe_type returns.
/// Errors: there is none; the error is a clause, such as "was not told in time".
using FindTypeObject = std::function<Result<const DDS_XTypes_TypeObject*>(const std::string& hash)>;

/// Returns what a type holds. `find` is asked for the types that it is made of, too. Cyclone 0.10
/// publishes an int8 as a character: it is a number in types that are named as those of ROS 2,
/// which have no characters.
/// Errors: an object is not there, or the type holds what cannot be decoded. The error is a clause
/// that the type's name can stand before, such as "holds a map".
[[nodiscard]] Result<Type> describe_type(const DDS_XTypes_TypeIdentifier& id,
                                         const FindTypeObject& find);

}  // namespace galilean::wire
