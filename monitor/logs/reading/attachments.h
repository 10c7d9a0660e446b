// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::logs {

/// Returns whether an attachment can be read and matches its checksum, if it has one. It is read
/// piece by piece.
[[nodiscard]] bool is_whole(const mcap::ByteSource& source, const mcap::Attachment& attachment);

}  // namespace galilean::logs
