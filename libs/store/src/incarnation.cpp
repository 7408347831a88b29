// SPDX-License-Identifier: Apache-2.0
#include "skein/store/incarnation.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

namespace skein::store {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();

/// 0: there was none yet.
Result<std::uint64_t, Failure> last_incarnation(const fs::path& file) {
  std::error_code none;
  if (!fs::exists(file, none) && !none) return 0;
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  const bool whole = error == std::errc() && stopped + 1 == end && *stopped == '\n';
  if (!in || !whole || number == kLast)
    return failure(file.string() + ": no number of an incarnation");
  return number;
}

/// On disk with its name, or not at all.
class NewFile {
 public:
  explicit NewFile(const fs::path& path)
      : number_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {}
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile() {
    if (number_ >= 0) close(number_);
  }
  bool put(const std::string& text) const {
    const auto size = static_cast<ssize_t>(text.size());
    return number_ >= 0 && write(number_, text.data(), text.size()) == size && fsync(number_) == 0;
  }

 private:
  int number_;
};

bool sync_folder(const fs::path& folder) {
  const int number = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (number < 0) return false;
  const bool done = fsync(number) == 0;
  close(number);
  return done;
}

Result<void, Failure> keep(const fs::path& file, std::uint64_t incarnation) {
  fs::path fresh = file;
  fresh += ".new";
  const bool done = NewFile(fresh).put(std::to_string(incarnation) + "\n") &&
                    std::rename(fresh.c_str(), file.c_str()) == 0 &&
                    sync_folder(file.parent_path());
  if (done) return {};
  return failure(file.string() + ": " + std::strerror(errno));
}

}  // namespace

Result<Incarnation, Failure> next_incarnation(const fs::path& folder, const std::string& node,
                                              std::uint64_t clock) {
  std::error_code refused;
  fs::create_directories(folder, refused);  // what is refused is said when it is written
  const fs::path file = folder / (node + ".incarnation");
  const auto last = last_incarnation(file);
  if (!last) return tl::unexpected(last.error());
  const std::uint64_t next = std::max(*last + 1, std::min(clock, kLast - 1));
  if (auto kept = keep(file, next); !kept) return tl::unexpected(kept.error());
  return Incarnation{next, *last == 0};
}

}  // namespace skein::store
