// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/count_allocations.h"

#include <cstdlib>
#include <new>

namespace {
thread_local bool counting = false;
thread_local long count = 0;
}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (counting) ++count;
  return std::malloc(size);
}
void* operator new(std::size_t size) {
  if (void* room = operator new(size, std::nothrow)) return room;
  throw std::bad_alloc();
}
void operator delete(void* room) noexcept {
  if (counting && room) ++count;
  std::free(room);
}
void operator delete(void* room, std::size_t) noexcept {
  operator delete(room);
}

namespace galilean::robot {

AllocationCount::AllocationCount() {
  count = 0;
  counting = true;
}

AllocationCount::~AllocationCount() {
  counting = false;
}

long AllocationCount::so_far() const {
  return count;
}

}  // namespace galilean::robot
