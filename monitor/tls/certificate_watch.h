// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <utility>

#include "monitor/tls/certificate.h"

namespace galilean::monitor {

/// Notices that a certificate and its key were replaced, as whoever renews them does. A look costs
/// two system calls.
class CertificateWatch {
 public:
  /// What the files hold now is known.
  explicit CertificateWatch(CertificateFiles files);

  [[nodiscard]] const CertificateFiles& files() const noexcept { return files_; }
  /// Returns whether a file has changed since this returned true last, or since the beginning, and
  /// neither has since the last call. Certificate and key are replaced one after the other, and so
  /// both are new then.
  [[nodiscard]] bool is_renewed();

 private:
  /// All zeros where the file is not there.
  struct FileMark {
    ino_t number = 0;
    off_t bytes = 0;
    std::int64_t written_s = 0, written_ns = 0;
    bool operator==(const FileMark&) const = default;
  };
  using Marks = std::array<FileMark, 2>;
  [[nodiscard]] Marks look() const;

  CertificateFiles files_;
  Marks taken_, last_;
};

}  // namespace galilean::monitor
