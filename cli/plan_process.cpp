// SPDX-License-Identifier: Apache-2.0
#include "plan_process.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>

#include "skein/plan_tool/plan.hpp"

namespace skein::cli {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

// The second Ctrl-C ends the process at once.
void watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_seen = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

/// The kernel's figure behind `name` in the first 4 kB of a file of /proc [kB]; absent: none is
/// there.
std::optional<double> kilobytes_in(const char* path, const char* name) {
  std::array<char, 4096> text{};
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  const ssize_t length = file < 0 ? 0 : read(file, text.data(), text.size() - 1);
  if (file >= 0) close(file);
  const char* figure = length > 0 ? std::strstr(text.data(), name) : nullptr;
  if (figure == nullptr) return std::nullopt;
  return std::strtod(figure + std::strlen(name), nullptr);
}

// getrusage would count what the process was before exec too, as the copy of a large parent.
double memory_mb() {
  if (const auto peak = kilobytes_in("/proc/self/status", "VmHWM:")) return *peak * 1024e-6;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;
}

bool colour_on(int stream) {
  const char* refused = std::getenv("NO_COLOR");  // no-color.org: set and not empty
  return isatty(stream) != 0 && (refused == nullptr || *refused == '\0');
}

plan_tool::Surroundings surroundings() {
  plan_tool::Surroundings out;
  out.cpu_seconds = cpu_seconds;
  out.interrupted = [] { return interrupt_seen != 0; };
  out.memory_mb = memory_mb;
  out.colour_out = colour_on(STDOUT_FILENO);
  out.colour_err = colour_on(STDERR_FILENO);
  out.progress = isatty(STDERR_FILENO) != 0;
  out.process_ends = true;
  return out;
}

// What is free, or would be without the files that are kept in memory; where the kernel does not
// say, all of the machine's [byte].
std::uint64_t available_memory() {
  if (const auto available = kilobytes_in("/proc/meminfo", "MemAvailable:"))
    return static_cast<std::uint64_t>(*available) * 1024;
  const auto pages = static_cast<std::uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 1L));
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// A search without end is to be cut before the machine swaps: three quarters of what is available,
// or of what the process may have (ulimit -v).
std::uint64_t default_memory_limit() {
  std::uint64_t bytes = available_memory();
  rlimit allowed{};
  if (getrlimit(RLIMIT_AS, &allowed) == 0 && allowed.rlim_cur != RLIM_INFINITY) {
    bytes = std::min<std::uint64_t>(bytes, allowed.rlim_cur);
  }
  return bytes / 4 * 3;
}

// What grows leaves memory behind that is soon wanted again: given back to the system it would have
// to be asked for, and cleared, each time.
void keep_freed_memory() {
  constexpr int kLarge = 8 << 20;
  constexpr int kStep = 512 << 10;
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, kLarge);
  mallopt(M_TOP_PAD, kStep);
}

}  // namespace

int plan_here(const plan_tool::PlanOptions& given) {
  plan_tool::PlanOptions options = given;
  auto& memory = options.search.limits.memory_bytes;
  if (!memory) memory = default_memory_limit();
  keep_freed_memory();
  watch_interrupts();
  return plan_tool::run_plan(options, surroundings(), std::cin, std::cout, std::cerr);
}

}  // namespace skein::cli
