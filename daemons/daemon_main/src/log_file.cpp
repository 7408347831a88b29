// SPDX-License-Identifier: Apache-2.0
#include "log_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace skein::daemon_main {

namespace {

std::string error_text() { return std::generic_category().message(errno); }

/// A process that was killed, or a full disk, may have left part of a line.
bool ends_within_line(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  char last = '\n';
  return size > 0 && pread(file, &last, 1, size - 1) == 1 && last != '\n';
}

}  // namespace

Result<LogFile, Failure> LogFile::open(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return failure(path + ": " + error_text());
  return LogFile(path, file, ends_within_line(file));
}

LogFile::LogFile(LogFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      torn_(other.torn_),
      lost_(other.lost_) {}

LogFile& LogFile::operator=(LogFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  std::swap(torn_, other.torn_);
  std::swap(lost_, other.lost_);
  return *this;
}

LogFile::~LogFile() {
  if (file_ >= 0) close(file_);
}

bool LogFile::put(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    torn_ = true;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string LogFile::append(std::string_view line) {
  const std::string text = (torn_ ? "\n" : "") + std::string(line) + "\n";
  if (!put(text)) {
    return lost_++ == 0 ? path_ + " takes no more lines: " + error_text() : std::string();
  }
  torn_ = false;
  if (lost_ == 0) return {};
  return path_ + " takes lines again; " + std::to_string(std::exchange(lost_, 0)) + " are lost";
}

}  // namespace skein::daemon_main
