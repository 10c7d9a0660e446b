// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/mcap_reader.h"

namespace galilean::mcap {

/// Counts the messages of `summary.blocks` by their message indexes, and takes their times from the
/// blocks' heads. Reads only blocks without indexes, and those with channels that no record outside
/// of blocks describes: each channel stands before its first message.
void count_by_indexes(const ByteSource& source, Summary& summary);

}  // namespace galilean::mcap
