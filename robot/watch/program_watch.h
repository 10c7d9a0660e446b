#pragma once

#include <filesystem>
#include <thread>

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
  /// Throws std::system_error if the system grants no watch. `executive` and `catalog` must outlive
  /// this.
  ProgramWatch(std::filesystem::path file, const Catalog& catalog, Executive& executive);

 private:
  void run(const std::stop_token& stop);
  void wait() const;
  void reload();
  void swap(bhdl::Program program);
  [[nodiscard]] bool runs(const std::string& hash) const;

  std::filesystem::path file_;
  const Catalog& catalog_;
  Executive& executive_;
  FileWatch files_;
  Wake wake_;
  std::jthread thread_;
};

}  // namespace galilean::robot
