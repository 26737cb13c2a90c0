// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "memory/allocation_counter.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define DOT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define DOT_SANITIZED
#endif
#if defined(__GLIBC__) && !defined(DOT_SANITIZED)
#define DOT_COUNTS_MALLOC
#endif

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

std::atomic<bool> short_of_memory{false}, shortage_lasts{false};
std::atomic<long> left{0};  // allocations that still succeed

/// Notes an allocation. @return whether it succeeds.
bool granted() {
  if (counting.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
  if (!short_of_memory.load(std::memory_order_relaxed)) return true;
  const long before = left.fetch_sub(1, std::memory_order_relaxed);
  return before > 0 || (before < 0 && !shortage_lasts.load(std::memory_order_relaxed));
}

}  // namespace

namespace dot::test {

AllocationCounter::AllocationCounter() {
  allocations = 0;
  counting = true;
}
AllocationCounter::~AllocationCounter() { counting = false; }
long AllocationCounter::count() const { return allocations; }

#ifdef DOT_COUNTS_MALLOC
bool AllocationCounter::sees_malloc() { return true; }
#else
bool AllocationCounter::sees_malloc() { return false; }
#endif

MemoryShortage::MemoryShortage(long first, Duration duration) {
  left = first;
  shortage_lasts = duration == Lasting;
  short_of_memory = true;
}
bool MemoryShortage::reached() const { return left < 0; }
void MemoryShortage::end() { short_of_memory = false; }

}  // namespace dot::test

#ifdef DOT_COUNTS_MALLOC

// Operator new of the C++ library calls these.
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

static void* none() {
  errno = ENOMEM;
  return nullptr;
}

void* malloc(std::size_t size) { return granted() ? __libc_malloc(size) : none(); }
void* calloc(std::size_t count, std::size_t size) { return granted() ? __libc_calloc(count, size) : none(); }
void* realloc(void* memory, std::size_t size) { return granted() ? __libc_realloc(memory, size) : none(); }
void* memalign(std::size_t alignment, std::size_t size) {
  return granted() ? __libc_memalign(alignment, size) : none();
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return granted() ? __libc_memalign(alignment, size) : none();
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  void* const out = granted() ? __libc_memalign(alignment, size) : nullptr;
  if (out == nullptr) return ENOMEM;
  *memory = out;
  return 0;
}

}  // extern "C"

#else

// The other forms of new call these, but not a sanitizer's own.
void* operator new(std::size_t size) {
  if (granted())
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return granted() ? std::malloc(size > 0 ? size : 1) : nullptr;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

#endif
