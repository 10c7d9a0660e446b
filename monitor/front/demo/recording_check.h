// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/termination.h"

namespace galilean::front {

/// Judges the recording of a run by files of expectations. `galilean log check` does the work, so
/// that the demo knows no expectation. JUnit's XML tells of every run, also of one that is killed.
class RecordingCheck {
 public:
  /// @param expectations  files, or names of those that ship
  /// @param junit         where to write JUnit's XML, too; empty: nowhere
  /// @param logs          the folder of the run's logs
  RecordingCheck(const std::vector<std::string>& expectations, std::string junit,
                 std::filesystem::path logs, Termination& termination);

  /// Writes that the run has not come to its end, until something else is known.
  /// Errors: the XML cannot be written.
  [[nodiscard]] Result<void> begin();
  /// Errors: an expectation cannot be read, or has mistakes; or termination was asked for.
  [[nodiscard]] Result<void> read_expectations();
  /// Prints what came of the expectations. Returns the exit code of `galilean log check`.
  /// Errors: it could not be run, or termination was asked for.
  /// @param problems   what went wrong in the run, which the reports tell, too
  /// @param shortages  why the recording is not whole, which they tell, too
  [[nodiscard]] Result<int> judge(const std::string& recording,
                                  const std::vector<std::string>& problems,
                                  const std::vector<std::string>& shortages);
  /// Writes why nothing was judged, unless the XML tells already. Errors: it cannot be written.
  [[nodiscard]] Result<void> give_up(const std::string& why);

 private:
  struct Said {
    int code = 0;
    std::string text;  ///< what it printed
  };
  Result<Said> run(const std::string& name, std::vector<std::string> arguments) const;
  Result<void> write_junit(const std::string& why) const;

  std::vector<std::string> expectations_;  ///< paths
  std::string junit_;
  bool has_told_ = false;  ///< the XML tells what came of the expectations
  std::filesystem::path logs_;
  Termination& termination_;
};

}  // namespace galilean::front
