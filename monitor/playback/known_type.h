// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/schemas.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::monitor {

/// Returns this release's schema of a recorded type. Returns nullptr if the release does not know
/// the type, or defines it otherwise.
[[nodiscard]] const wire::Schema* known_type(const mcap::Schema& schema);

}  // namespace galilean::monitor
