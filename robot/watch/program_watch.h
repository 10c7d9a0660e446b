// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "bhdl/check/vocabulary.h"
#include "core/catalog/catalog.h"
#include "core/wake.h"
#include "core/worker.h"
#include "robot/executive/executive.h"
#include "robot/watch/file_watch.h"

namespace galilean::robot {

/// Swaps the program whenever its file, or one that it includes, is saved: as a push does, with the
/// same probation. A save with errors changes nothing; what is wrong is logged. All of it happens
/// in a thread of its own.
class ProgramWatch {
 public:
  /// Gets one sentence on why saves are not noticed or not taken over, when that changes; the empty
  /// text when all is well again. Called in the watch's thread.
  using Tell = std::function<void(const std::string& problem)>;

  /// Throws std::system_error if the system grants no watch. `executive` must outlive this.
  ProgramWatch(std::filesystem::path file, const Catalog& catalog, Executive& executive, Tell tell);

 private:
  void look(const std::stop_token& stop);
  void wait() const;
  /// The swap waits neither for warnings nor for watches. Then the text is read again: what was
  /// saved before it was watched takes over as well.
  void reload();
  /// Each time, for what was a file may have become a link.
  void watch(const std::vector<bhdl::SourceFile>& sources);
  void swap(bhdl::Program program);
  [[nodiscard]] bool runs(const std::string& hash) const;

  void note_failure(const std::string& failure);
  void tell_problem();

  std::filesystem::path file_;
  bhdl::Vocabulary vocabulary_;
  Executive& executive_;
  FileWatch files_;
  bool saved_ = false;  ///< and not yet taken over
  Tell tell_;
  std::string failure_;
  std::string told_;
  Wake wake_;
  Worker worker_;
};

}  // namespace galilean::robot
