// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/logs/reading/selection.h"
#include "monitor/logs/writing/copier.h"

namespace galilean::logs {

/// What `galilean log slice`, `merge`, `convert` and `recover` are asked for.
struct CopyOptions {
  std::vector<std::string> files;
  Selection selection;
  bool with_states = false;  ///< begin with what a late joiner would be told at the time `from_s`
  OutputOptions output;
  /// Read what was written again, and fail unless all of it is there; and fail if nothing could be
  /// read of a recording that is not whole.
  bool read_again = false;
};

/// Copies the wanted messages of recordings, in the order of their log times, to a new recording.
/// `verb` stands in messages, such as "slice". Returns the exit code.
[[nodiscard]] int copy_recordings(const std::string& verb, const CopyOptions& options);

}  // namespace galilean::logs
