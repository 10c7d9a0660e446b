// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/tls/certificate_watch.h"

#include <sys/stat.h>

namespace galilean::monitor {

CertificateWatch::CertificateWatch(CertificateFiles files)
    : files_(std::move(files)), taken_(look()), last_(taken_) {}

CertificateWatch::Marks CertificateWatch::look() const {
  const auto mark_of = [](const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return FileMark{};
    return FileMark{.number = status.st_ino,
                    .bytes = status.st_size,
                    .written_s = status.st_mtim.tv_sec,
                    .written_ns = status.st_mtim.tv_nsec};
  };
  return {mark_of(files_.certificate), mark_of(files_.key)};
}

bool CertificateWatch::is_renewed() {
  const Marks now = look();
  const bool rests = std::exchange(last_, now) == now;
  if (!rests || now == taken_) return false;
  taken_ = now;
  return true;
}

}  // namespace galilean::monitor
