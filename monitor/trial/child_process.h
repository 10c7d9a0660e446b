// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::monitor {

/// A child process, whose end is awaited on an io_context without a thread. The kernel kills it
/// when the thread that started it ends, even by a crash. The destructor kills it, too. Others have
/// the processor first, and its files have at most 8 MB each.
class ChildProcess {
 public:
  /// Called on the io_context's thread with the exit code, which is 128 + N if signal N ended the
  /// child. It may destroy the ChildProcess.
  using Ended = std::function<void(int exit_code)>;

  /// Starts a program. `command` is its path and arguments; `out` and `err` are the files that get
  /// its standard output and standard error. If the program cannot be executed, `ended` gets 127.
  /// Errors: the process cannot be made or awaited.
  [[nodiscard]] static Result<std::unique_ptr<ChildProcess>> start(
      boost::asio::io_context& io, const std::vector<std::string>& command,
      const std::filesystem::path& out, const std::filesystem::path& err, Ended ended);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

 private:
  ChildProcess(boost::asio::io_context& io, pid_t pid, int descriptor, Ended ended);
  void wait();
  [[nodiscard]] int reap();

  pid_t pid_;  ///< 0 after the child was reaped
  boost::asio::posix::stream_descriptor readable_when_over_;
  Ended ended_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< a late handler finds it false
};

}  // namespace galilean::monitor
