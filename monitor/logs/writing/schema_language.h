// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::logs {

/// Returns a schema in another of MCAP's encodings, "ros2msg" or "ros2idl". In the latter come
/// types of Galilean alone; others come in "omgidl", which is the IDL of all. Comments and
/// constants are no part of a type, and are kept only where the encoding stays. Errors: the schema
/// cannot be read, or not be said in that language; the error is a clause that the type's name can
/// stand before.
[[nodiscard]] Result<mcap::Schema> in_language(const mcap::Schema& schema,
                                               const std::string& encoding);

}  // namespace galilean::logs
