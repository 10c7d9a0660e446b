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

/// Swaps the program whenever its file, or one that it includes, is saved. The swap is like a push,
/// with the same probation. A save with errors changes nothing, and the errors are logged. All of
/// this happens in a thread of its own.
class ProgramWatch {
 public:
  /// Is called in the watch's thread, when the problem changes, with one sentence on why saves are
  /// not noticed or not taken over, or with an empty text when all is well again.
  using Tell = std::function<void(const std::string& problem)>;

  /// Requires: `executive` outlives this. Errors: throws std::system_error if the system grants no
  /// watch.
  ProgramWatch(std::filesystem::path file, const Catalog& catalog, Executive& executive, Tell tell);

 private:
  void look(const std::stop_token& stop);
  void wait() const;
  /// Takes the saved program over before it looks for warnings and watches new includes. Then it
  /// reads the text again, so that what was saved before its watch began takes over, too. Returns
  /// whether a watch began even later, so that all must be read once more.
  [[nodiscard]] bool reload();
  /// Watches all sources after each save, because a file may have become a link. Returns what
  /// FileWatch::add does.
  [[nodiscard]] bool watch(const std::vector<bhdl::SourceFile>& sources);
  void swap(bhdl::Program program);
  [[nodiscard]] bool runs(const std::string& hash) const;

  void note_failure(const std::string& failure);
  void tell_problem();

  std::filesystem::path file_;
  bhdl::Vocabulary vocabulary_;
  Executive& executive_;
  FileWatch files_;
  bool saved_ = false;  ///< a save was noticed and not yet taken over
  Tell tell_;
  std::string failure_;
  std::string told_;
  Wake wake_;
  Worker worker_;
};

}  // namespace galilean::robot
