// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/check/vocabulary.h"
#include "bhdl/lint/schema_use.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Warns once of each device that a schema of a state needs and that the program does not name. The
/// robot then takes the device with the catalog's settings, which may be another robot's.
void warn_of_unnamed_devices(const Program& program, const SchemaUses& uses,
                             const Vocabulary& vocabulary, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
