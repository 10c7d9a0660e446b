#pragma once

#include <filesystem>
#include <string>
#include <thread>

#include "bhdl/check/vocabulary.h"
#include "core/catalog/catalog.h"
#include "core/wake.h"
#include "robot/executive/executive.h"
#include "robot/watch/file_watch.h"

namespace galilean::robot {

/// Swaps the program whenever its file, or one that it includes, is saved: as a push does, with the
/// same probation. A save with errors changes nothing; what is wrong is logged. All of it happens
/// in a thread of its own.
class ProgramWatch {
 public:
  /// Throws std::system_error if the system grants no watch. `executive` must outlive this.
  ProgramWatch(std::filesystem::path file, const Catalog& catalog, Executive& executive);

 private:
  void run(const std::stop_token& stop);
  void wait() const;
  /// The swap waits neither for warnings nor for watches. Then the text is read again: what was
  /// saved before it was watched takes over as well.
  void reload();
  /// Each time, for what was a file may have become a link.
  void watch(const std::vector<bhdl::SourceFile>& sources);
  void swap(bhdl::Program program);
  [[nodiscard]] bool runs(const std::string& hash) const;

  std::filesystem::path file_;
  bhdl::Vocabulary vocabulary_;
  Executive& executive_;
  FileWatch files_;
  Wake wake_;
  std::jthread thread_;
};

}  // namespace galilean::robot
