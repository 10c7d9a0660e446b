// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/types/type_description.h"

namespace galilean::wire {

/// Returns the definition of a type in IDL, after those of the types that it is made of. A sequence
/// of arrays is written as sequence<long[3]>, for which IDL would need one more name. Names from
/// the network become visible.
[[nodiscard]] std::string type_text(const Type& type);

}  // namespace galilean::wire
