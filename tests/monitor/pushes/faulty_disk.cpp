// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/pushes/faulty_disk.h"

#include <unistd.h>

#include <csignal>
#include <utility>

namespace galilean::monitor {

FaultyDisk* FaultyDisk::now_ = nullptr;

FaultyDisk::FaultyDisk(Decide decide)
    : real_(sqlite3_vfs_find(nullptr)), ours_(*real_), decide_(std::move(decide)) {
  now_ = this;
  ours_.zName = "faulty";
  ours_.pNext = nullptr;
  ours_.xOpen = &FaultyDisk::open;
  sqlite3_vfs_register(&ours_, 1);
}

FaultyDisk::~FaultyDisk() {
  sqlite3_vfs_unregister(&ours_);
  sqlite3_vfs_register(real_, 1);
  now_ = nullptr;
}

int FaultyDisk::open(sqlite3_vfs* /*vfs*/, const char* name, sqlite3_file* file, int flags,
                     int* out) {
  const int result = now_->real_->xOpen(now_->real_, name, file, flags, out);
  if (result == SQLITE_OK && file->pMethods) file->pMethods = now_->methods_for(file->pMethods);
  return result;
}

const sqlite3_io_methods* FaultyDisk::methods_for(const sqlite3_io_methods* real) {
  auto& found = methods_[real];
  if (!found) {
    found = std::make_unique<Methods>(Methods{*real, real});
    found->ours.xWrite = &FaultyDisk::write;
    found->ours.xSync = &FaultyDisk::sync;
  }
  return &found->ours;
}

int FaultyDisk::write(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 at) {
  const auto* real = reinterpret_cast<const Methods*>(file->pMethods)->real;
  const auto fate = now_->decide_(++now_->writes_);
  if (fate == Fate::kFull) return SQLITE_FULL;
  if (fate == Fate::kDieHalfway) real->xWrite(file, bytes, count / 2, at);
  if (fate == Fate::kDieHalfway || fate == Fate::kDieBefore) kill(getpid(), SIGKILL);
  return real->xWrite(file, bytes, count, at);
}

int FaultyDisk::sync(sqlite3_file* /*file*/, int /*flags*/) {
  return SQLITE_OK;
}

}  // namespace galilean::monitor
