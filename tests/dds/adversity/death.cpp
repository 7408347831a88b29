// SPDX-License-Identifier: Apache-2.0
// A process that dies as it writes: preloaded (LD_PRELOAD), it counts what is written to the
// write-ahead log of SQLite, and kills itself after the write of that number (ADVERSITY_DEATH),
// before what it wrote has any consequence, or, of a negative number, instead of that write.
// Without the variable nothing is changed.
#include <dlfcn.h>
#include <limits.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

constexpr std::string_view kLog = ".state-wal";

bool is_log(int descriptor) {
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  std::array<char, PATH_MAX> path{};
  const ssize_t size = readlink(link.c_str(), path.data(), path.size());
  return size > 0 && std::string_view(path.data(), static_cast<std::size_t>(size)).ends_with(kLog);
}

long last_write() {
  static const char* const given = std::getenv("ADVERSITY_DEATH");
  static const long number = given == nullptr ? 0 : std::strtol(given, nullptr, 10);
  return number;
}

/// Dies before the write if that is to be its end; true if it is to be after it.
bool is_last(int descriptor) {
  static std::atomic<long> writes{0};
  if (last_write() == 0 || !is_log(descriptor)) return false;
  const long number = ++writes;
  if (number == -last_write()) raise(SIGKILL);
  return number == last_write();
}

}  // namespace

extern "C" ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t at) {
  using Function = ssize_t (*)(int, const void*, size_t, off64_t);
  static const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "pwrite64"));  // NOLINT
  const bool last = is_last(descriptor);
  const ssize_t written = real(descriptor, bytes, size, at);
  if (last) raise(SIGKILL);
  return written;
}
