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

/// A program that runs beside this one and is waited for without a thread. It is killed when this
/// object goes, and when this process does, however that happens.
class ChildProcess {
 public:
  /// The exit code; 128 and more: a signal ended it.
  using Ended = std::function<void(int exit_code)>;

  /// `command`: the program's path and its arguments. What it prints goes to the two files.
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

  pid_t pid_;  ///< 0 once it was waited for
  boost::asio::posix::stream_descriptor readable_when_over_;
  Ended ended_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< for a word that comes late
};

}  // namespace galilean::monitor
