// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "monitor/background/worker.h"
#include "monitor/recordings/recording_folder.h"
#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Answers what the robots of recordings exercised. One recording is counted at a time. Who asks
/// for one that is being counted gets the same answer, and the newest answer is kept for as long as
/// its file stays as it was. For use on the io_context's thread.
class CoverageDesk {
 public:
  /// Requires: `folder` and `worker` outlive this, and the worker has no other jobs that others
  /// wait for.
  CoverageDesk(const RecordingFolder& folder, Worker& worker) : folder_(folder), worker_(worker) {}

  /// Answers later: 200, 403, 404, 422, 500 or 503; at once with 503 if too many others wait.
  void ask(const std::string& name, const Respond& respond);
  /// Ends what is being counted. Call it before the worker is finished.
  void stop() noexcept { stops_ = true; }

 private:
  /// An answer, and the file that it is of.
  struct Counted {
    std::string name;
    std::uint64_t bytes = 0, modified_ns = 0, inode = 0;
    HttpResponse response;
  };

  [[nodiscard]] HttpResponse count(const std::string& name);
  void tell(const std::string& name, const HttpResponse& response);

  const RecordingFolder& folder_;
  Worker& worker_;
  std::map<std::string, std::vector<Respond>> waiting_;  ///< by the recording's name
  Counted newest_;                                       ///< used on the worker only
  std::atomic<bool> stops_ = false;
};

}  // namespace galilean::monitor
