// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include "monitor/mcap/byte_sink.h"

namespace galilean::logs {

/// A file whose process ends within a write, as by SIGKILL or a loss of power: no destructor runs,
/// and a part of the bytes may be there.
class DyingSink final : public mcap::ByteSink {
 public:
  static constexpr int kDied = 9;

  /// Ends the process at the write of this number, from 0, when so many thousandths of its bytes
  /// are written.
  DyingSink(mcap::FileSink file, std::size_t at, std::size_t per_mille)
      : file_(std::move(file)), at_(at), per_mille_(per_mille) {}

  Result<void> write(std::span<const std::uint8_t> bytes) override {
    if (writes_++ < at_) return file_.write(bytes);
    (void)file_.write(bytes.first(bytes.size() * per_mille_ / 1000));
    _exit(kDied);
  }

 private:
  mcap::FileSink file_;
  std::size_t at_, per_mille_, writes_ = 0;
};

/// Counts what is written, and forgets it.
class CountingSink final : public mcap::ByteSink {
 public:
  Result<void> write(std::span<const std::uint8_t>) override { return ++writes_, Result<void>(); }
  [[nodiscard]] std::size_t writes() const noexcept { return writes_; }

 private:
  std::size_t writes_ = 0;
};

}  // namespace galilean::logs
