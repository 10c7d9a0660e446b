// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/mcap/mcap_reader.h"

namespace galilean::mcap {

/// Takes away the damage at the end of a file that is being written: the record there is not
/// damaged, but on its way.
void forgive_unfinished(const Survey& found, Summary& summary);

/// Compares the data section with its checksum, and adds a damage if they differ and no other
/// damage explains it.
void check_data_section(const ByteSource& source, const Survey& found, Summary& summary);

/// Adds a damage for each channel that has messages and that no record describes.
void name_nameless(Summary& summary);

/// Sets how many messages of each channel are lost. What the file's own statistics count beyond
/// what was read is lost; without them, the damages tell as much as they know.
void count_losses(const std::optional<Statistics>& stated, Summary& summary);

}  // namespace galilean::mcap
