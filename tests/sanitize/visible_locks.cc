// Makes the locks of gRPC visible to the thread sanitizer. They are absl's, made of futexes in a
// library that is not instrumented: without this, whatever gRPC hands from thread to thread looks
// like a race. To be preloaded; in a process without the sanitizer, or without absl, it does
// nothing. Each function does what the one it stands before does, and says so.

#include <dlfcn.h>

#include "absl/synchronization/mutex.h"
#include "absl/time/time.h"

extern "C" {
// Of the sanitizer's runtime.
[[gnu::weak]] void __tsan_acquire(void* address);  // NOLINT(bugprone-reserved-identifier)
[[gnu::weak]] void __tsan_release(void* address);  // NOLINT(bugprone-reserved-identifier)
}

namespace {

void Acquired(void* lock) {
  if (__tsan_acquire != nullptr) __tsan_acquire(lock);
}

void Releases(void* lock) {
  if (__tsan_release != nullptr) __tsan_release(lock);
}

/// The function that stands behind: by its mangled name, within absl's namespace.
template <class Function>
Function* Behind(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// Debian's inline namespace of absl.
#define CELT_ABSL(name) "_ZN4absl7debian3" name

namespace absl {
ABSL_NAMESPACE_BEGIN

void Mutex::Lock() {
  static auto* const lock = Behind<void(Mutex*)>(CELT_ABSL("5Mutex4LockEv"));
  lock(this);
  Acquired(this);
}

bool Mutex::TryLock() {
  static auto* const try_lock = Behind<bool(Mutex*)>(CELT_ABSL("5Mutex7TryLockEv"));
  const bool locked = try_lock(this);
  if (locked) Acquired(this);
  return locked;
}

void Mutex::Unlock() {
  static auto* const unlock = Behind<void(Mutex*)>(CELT_ABSL("5Mutex6UnlockEv"));
  Releases(this);
  unlock(this);
}

void CondVar::Wait(Mutex* mutex) {
  static auto* const wait = Behind<void(CondVar*, Mutex*)>(CELT_ABSL("7CondVar4WaitEPNS0_5MutexE"));
  Releases(mutex);
  wait(this, mutex);
  Acquired(mutex);
}

bool CondVar::WaitWithDeadline(Mutex* mutex, Time deadline) {
  static auto* const wait = Behind<bool(CondVar*, Mutex*, Time)>(
      CELT_ABSL("7CondVar16WaitWithDeadlineEPNS0_5MutexENS0_4TimeE"));
  Releases(mutex);
  const bool expired = wait(this, mutex, deadline);
  Acquired(mutex);
  return expired;
}

bool CondVar::WaitWithTimeout(Mutex* mutex, Duration timeout) {
  static auto* const wait = Behind<bool(CondVar*, Mutex*, Duration)>(
      CELT_ABSL("7CondVar15WaitWithTimeoutEPNS0_5MutexENS0_8DurationE"));
  Releases(mutex);
  const bool expired = wait(this, mutex, timeout);
  Acquired(mutex);
  return expired;
}

ABSL_NAMESPACE_END
}  // namespace absl
