// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/token_watch.h"

namespace galilean::monitor {

TokenWatch::Mark TokenWatch::mark() const {
  struct stat status {};
  if (stat(file_.c_str(), &status) != 0) return {};
  return {.number = status.st_ino,
          .bytes = status.st_size,
          .mode = status.st_mode,
          .written_s = status.st_mtim.tv_sec,
          .written_ns = status.st_mtim.tv_nsec};
}

std::optional<Result<std::vector<NamedToken>>> TokenWatch::look() {
  const Mark now = mark();  // before reading: what changes meanwhile is seen at the next look
  if (last_ && *last_ == now) return {};
  last_ = now;
  return read_named_tokens(file_);
}

}  // namespace galilean::monitor
