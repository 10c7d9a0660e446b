// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/count_allocations.h"

#include <cerrno>
#include <cstddef>

// All allocations end in malloc and its relatives: operator new, aligned or not, and Eigen. Only
// these are counted.

namespace {
thread_local bool counting = false;
thread_local long count = 0;

void note() noexcept {
  if (counting) ++count;
}
}  // namespace

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GALILEAN_SANITIZER_ALLOCATES
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GALILEAN_SANITIZER_ALLOCATES
#endif

#ifdef GALILEAN_SANITIZER_ALLOCATES

// A sanitizer has its own allocator, and reports each call.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*,
                                                                           std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {
const int hooks =
    __sanitizer_install_malloc_and_free_hooks([](const volatile void*, std::size_t) { note(); },
                                              [](const volatile void* room) {
                                                if (room) note();
                                              });
}  // namespace

#else

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* room, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* room);

void* malloc(std::size_t size) noexcept {
  note();
  return __libc_malloc(size);
}
void* calloc(std::size_t each, std::size_t size) noexcept {
  note();
  return __libc_calloc(each, size);
}
void* realloc(void* room, std::size_t size) noexcept {
  note();
  return __libc_realloc(room, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  note();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  note();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** room, std::size_t alignment, std::size_t size) noexcept {
  note();
  *room = __libc_memalign(alignment, size);
  return *room ? 0 : ENOMEM;
}
void free(void* room) noexcept {
  if (room) note();
  __libc_free(room);
}
}

#endif

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
