// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "monitor/mcap/mcap_records.h"
#include "monitor/record/command/recording_options.h"

namespace galilean::monitor {

/// Returns this machine's name, as the network knows it.
[[nodiscard]] std::string host_name();

/// Returns whether each file tells this word of itself, so that --about cannot.
[[nodiscard]] bool is_told_anyway(std::string_view word) noexcept;

/// Returns what each file of a recording tells of who recorded it, where and with what: the
/// versions of Galilean, the compiler and the system, the host, the user, the DDS `domain` that was
/// joined, and what --about adds. The recording's name is that by which commands call the recorder.
[[nodiscard]] mcap::Text about(const RecordingOptions& options, std::uint32_t domain);

}  // namespace galilean::monitor
