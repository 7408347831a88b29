// SPDX-License-Identifier: Apache-2.0
#include "log_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

namespace skein::daemon_main {

namespace {

std::string error_text() { return std::generic_category().message(errno); }

int open_to_append(const std::string& path) {
  return ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
}

/// Whether the open file is the one of that name.
bool has_name(int file, const std::string& path) {
  struct stat of_file {};
  struct stat of_name {};
  return fstat(file, &of_file) == 0 && stat(path.c_str(), &of_name) == 0 &&
         of_file.st_dev == of_name.st_dev && of_file.st_ino == of_name.st_ino;
}

/// A process that was killed, or a full disk, may have left part of a line.
bool ends_within_line(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  char last = '\n';
  return size > 0 && pread(file, &last, 1, size - 1) == 1 && last != '\n';
}

/// The lines at the end of the first `size` bytes of the file; of more than 1 MB that is not all.
std::deque<std::string> last_lines(int file, off_t size) {
  constexpr off_t kMost = 1'000'000;  // [bytes]
  const off_t begin = std::max<off_t>(0, size - kMost);
  std::string text(static_cast<std::size_t>(std::max<off_t>(0, size - begin)), '\0');
  const ssize_t read = pread(file, text.data(), text.size(), begin);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read)));
  std::deque<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

Result<LogFile, Failure> LogFile::open(const std::string& path) {
  const int file = open_to_append(path);
  if (file < 0) return failure(path + ": " + error_text());
  return LogFile(path, file, ends_within_line(file));
}

LogFile::LogFile(std::string path, int file, bool torn)
    : path_(std::move(path)), file_(file), torn_(torn), size_before_(lseek(file, 0, SEEK_END)) {}

LogFile::LogFile(LogFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      torn_(other.torn_),
      lost_(other.lost_),
      size_before_(other.size_before_),
      before_(std::move(other.before_)) {}

LogFile& LogFile::operator=(LogFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  std::swap(torn_, other.torn_);
  std::swap(lost_, other.lost_);
  std::swap(size_before_, other.size_before_);
  std::swap(before_, other.before_);
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

void LogFile::follow_name() {
  if (has_name(file_, path_)) return;
  const int next = open_to_append(path_);
  if (next < 0) return;
  if (!before_) before_ = last_lines(file_, size_before_);
  close(std::exchange(file_, next));
  torn_ = ends_within_line(file_);
}

bool LogFile::had(std::string_view line) {
  if (!before_) before_ = last_lines(file_, size_before_);
  const auto found = std::ranges::find(*before_, line);
  if (found == before_->end()) return false;
  before_->erase(before_->begin(), std::next(found));
  return true;
}

std::string LogFile::append(std::string_view line) {
  follow_name();
  const std::string text = (torn_ ? "\n" : "") + std::string(line) + "\n";
  if (!put(text)) {
    return lost_++ == 0 ? path_ + " takes no more lines: " + error_text() : std::string();
  }
  torn_ = false;
  if (lost_ == 0) return {};
  return path_ + " takes lines again; " + std::to_string(std::exchange(lost_, 0)) + " are lost";
}

}  // namespace skein::daemon_main
