// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::monitor {

/// The metadata of a recorded channel that names its writer: the GUID, and the process.
inline constexpr const char* kChannelWriter = "writer";
inline constexpr const char* kChannelProcess = "process";

/// The metadata of a channel that goes on behind a pause: which part of the file's time it is, from
/// 2. Nothing is missing between the parts.
inline constexpr const char* kChannelPart = "part";

/// The metadata of a channel in which numbers of messages skip though no message is missing, or are
/// of several writers. It says why. Gaps in the numbers of other channels are missing messages.
inline constexpr const char* kSequenceGaps = "sequence_gaps";

}  // namespace galilean::monitor
