// SPDX-License-Identifier: Apache-2.0
#include "skein/store/sqlite_input_log.hpp"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <charconv>
#include <deque>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "database.hpp"
#include "packing.hpp"
#include "skein/blackboard/wire_layout.hpp"

namespace skein::store {

namespace {

namespace fs = std::filesystem;

constexpr const char* kNode = "node";
constexpr const char* kMission = "mission";
constexpr const char* kOver = "over";
constexpr const char* kMessages = "messages";

struct Files {
  fs::path state, complete, lock;
};

Files files_of(const fs::path& folder, const std::string& node) {
  return {folder / (node + ".state"), folder / (node + ".complete"), folder / (node + ".lock")};
}

/// Holds a file for this process; the kernel lets go of it when the process ends, however.
class Lock {
 public:
  explicit Lock(const fs::path& file)
      : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {}
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  bool opened() const { return descriptor_ >= 0; }
  bool held() const { return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

 private:
  int descriptor_;
};

constexpr const char* kAside = ".aside-";
constexpr const char* kOfAnother = "of another scenario";

/// Numbers of the files that were set aside, in their order.
std::set<int> numbers_aside(const Files& files) {
  std::set<int> numbers;
  const std::string begin = files.state.filename().string() + kAside;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(files.state.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(begin, 0) != 0) continue;
    int number = 0;
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + begin.size(), end, number);
    if (read.ec == std::errc() && read.ptr == end) numbers.insert(number);
  }
  return numbers;
}

/// The file of a database with those that belong to it.
void rename_all(const fs::path& from, const fs::path& to) {
  std::error_code ignored;
  for (const char* part : {"", "-wal", "-shm"})
    fs::rename(from.string() + part, to.string() + part, ignored);
}

/// Sets the file aside, and removes the eldest of those that are too many. Gives under which name
/// it is now, and what was removed, in words.
std::string set_aside(const Files& files) {
  std::set<int> numbers = numbers_aside(files);
  const std::string begin = files.state.string() + kAside;
  const fs::path name = begin + std::to_string(numbers.empty() ? 1 : *numbers.rbegin() + 1);
  std::error_code ignored;
  rename_all(files.state, name);
  fs::remove(files.complete, ignored);
  std::string told = "it is " + name.string() + " now";
  for (; numbers.size() >= SqliteInputLog::kSetAside; numbers.erase(numbers.begin())) {
    const std::string eldest = begin + std::to_string(*numbers.begin());
    for (const char* part : {"", "-wal", "-shm"}) fs::remove(eldest + part, ignored);
    told += ", and " + eldest + " is removed, since the last " +
            std::to_string(SqliteInputLog::kSetAside) + " are kept";
  }
  return told;
}

/// Why what is there is not to be gone on from; empty if it is.
std::string objection(Database& database, const Files& files, const Identity& identity) {
  const int version = database.version();
  if (version > kVersion)
    return "of version " + std::to_string(version) + ", this program reads up to " +
           std::to_string(kVersion);
  if (const std::string sound = database.soundness(); sound != "ok") return "damaged: " + sound;
  const std::string node = database.about(kNode);
  if (node != identity.node) return "of node '" + node + "'";
  if (database.about(kMission) != identity.mission) return kOfAnother;
  if (!database.about(kOver).empty()) return "of a mission that is over";
  const std::string messages = database.about(kMessages);
  if (!messages.empty() && messages != wire::layout_mark())
    return "of a program with other messages (" + messages + ", this one has " +
           wire::layout_mark() + ")";
  if (!fs::exists(files.complete)) return "incomplete: not all that was handled could be kept";
  return {};
}

Failure failure_of(const fs::path& file, const std::exception& error) {
  return {file.string() + ": " + error.what()};
}

}  // namespace

class SqliteInputLog::Impl {
 public:
  Impl(Files files, Identity identity, std::unique_ptr<Lock> lock, std::uint64_t largest)
      : files_(std::move(files)),
        identity_(std::move(identity)),
        lock_(std::move(lock)),
        largest_(largest) {}

  /// Gives what it set aside, as a sentence.
  std::string open() {
    std::string told;
    if (fs::exists(files_.state)) told = without_objection();
    try {
      begin();
    } catch (const SQLite::Exception& error) {
      if (!is_of_the_file(error)) throw;
      told = aside(std::string("damaged: ") + error.what());
      begin();
    }
    return told;
  }

  void begin() {
    database_.emplace(files_.state.string(), Database::Mode::kWrite, largest_);
    const bool fresh = database_->inputs() == 0;
    SQLite::Transaction transaction(database_->raw());
    database_->set_about(kNode, identity_.node);
    database_->set_about(kMission, identity_.mission);
    if (fresh) database_->set_about(kMessages, wire::layout_mark());
    transaction.commit();
    told_ = static_cast<std::uint64_t>(database_->lines_told());
    mark_complete();
    rows_ = database_->not_folded();
    bytes_ = 0;
    fold_if_due();
  }

  std::string anew() {
    database_.reset();
    held_.clear();
    packing_ = Packing();
    std::string now = set_aside(files_);
    begin();
    return now;
  }

  bool take_back() {
    const std::set<int> numbers = numbers_aside(files_);
    if (!was_complete_ || numbers.empty()) return false;
    database_.reset();
    std::error_code ignored;
    for (const char* part : {"", "-wal", "-shm"}) fs::remove(files_.state.string() + part, ignored);
    rename_all(files_.state.string() + kAside + std::to_string(*numbers.rbegin()), files_.state);
    mark_complete();
    return true;
  }

  Result<void, Failure> append(const node::LogEntry& entry) {
    if (given_up_) return failure("it was given up");
    held_.push_back(row_of(entry));
    ++rows_;
    bytes_ += held_.back().body.size();
    packing_.pack(held_.back());
    try {
      database_->insert(held_);
      held_.clear();
    } catch (const std::exception& error) {
      unmark_complete();
      if (held_.size() > kHeld) give_up();
      return tl::unexpected(failure_of(files_.state, error));
    }
    if (!complete_) mark_complete();
    fold_if_due();
    return {};
  }

  void told(std::uint64_t lines) {
    told_ = lines;
    if (given_up_ || !held_.empty()) return;
    try {
      database_->set_lines_told(static_cast<std::int64_t>(lines));
    } catch (const std::exception&) {
      // the next append says so
    }
  }

  std::string take_news() { return std::exchange(news_, {}); }
  std::uint64_t told() const { return told_; }
  Database& database() { return *database_; }
  const Files& files() const { return files_; }

 private:
  /// Sets aside what is there unless it can be gone on from; gives what it did.
  std::string without_objection() {
    std::string why;
    try {
      Database there(files_.state.string(), Database::Mode::kRead);
      why = objection(there, files_, identity_);
    } catch (const std::exception& error) {
      why = std::string("damaged: ") + error.what();
    }
    if (why.empty()) return why;
    was_complete_ = why == kOfAnother && fs::exists(files_.complete);
    return aside(why);
  }

  std::string aside(const std::string& why) {
    database_.reset();
    return files_.state.string() + " is " + why + "; " + set_aside(files_);
  }

  /// Not of the disk or its rights: bytes of the file say that it must not be written, or nonsense.
  bool is_of_the_file(const SQLite::Exception& error) const {
    const int code = error.getErrorCode();
    return code == SQLITE_CORRUPT || code == SQLITE_NOTADB ||
           (code == SQLITE_READONLY && ::access(files_.state.c_str(), W_OK) == 0);
  }

  /// What cannot be folded, for want of room, stays as it is until as much has come again.
  void fold_if_due() {
    if (rows_ < kFoldedRows && bytes_ < kFoldedBytes) return;
    rows_ = bytes_ = 0;
    std::string why;
    try {
      database_->fold();
      packing_ = Packing();
      tell_if_nearly_full();
    } catch (const std::exception& error) {
      why = error.what();  // nothing is lost: it is there unfolded
    }
    if (why.empty() == folds_) return;
    folds_ = why.empty();
    tell(folds_ ? "older inputs are folded again"
                : "older inputs are not folded, it grows faster: " + why);
  }

  /// While there is time to end the mission.
  void tell_if_nearly_full() {
    const std::uint64_t used = database_->bytes_used();
    if (nearly_full_ || used < largest_ / 4 * 3) return;
    nearly_full_ = true;
    tell("it has " + std::to_string(used * 100 / largest_) + " % of the " +
         std::to_string(largest_ >> 20) + " MB that it may have, beyond which nothing is kept");
  }

  void tell(const std::string& what) {
    if (!news_.empty()) news_ += "; ";
    news_ += files_.state.string() + ": " + what;
  }

  void give_up() {
    given_up_ = true;
    held_.clear();
  }

  void mark_complete() {
    std::ofstream(files_.complete).put('\n');
    complete_ = fs::exists(files_.complete);
  }
  // On a full disk a file can still be removed.
  void unmark_complete() {
    std::error_code ignored;
    fs::remove(files_.complete, ignored);
    complete_ = false;
  }

  Files files_;
  Identity identity_;
  std::unique_ptr<Lock> lock_;
  std::optional<Database> database_;
  Packing packing_;
  std::deque<Row> held_;
  std::uint64_t rows_ = 0, bytes_ = 0;  ///< not folded
  std::uint64_t told_ = 0;
  std::uint64_t largest_;
  bool complete_ = true, given_up_ = false, folds_ = true, nearly_full_ = false;
  bool was_complete_ = false;  ///< what was set aside, of another scenario
  std::string news_;
};

SqliteInputLog::SqliteInputLog(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SqliteInputLog::~SqliteInputLog() = default;

Result<Opened, NotOpened> SqliteInputLog::open(const fs::path& folder, const Identity& identity,
                                               std::uint64_t largest) {
  const auto not_opened = [](std::string why, bool in_use = false) {
    return tl::unexpected(NotOpened{std::move(why), in_use});
  };
  std::error_code error;
  fs::create_directories(folder, error);
  const Files files = files_of(folder, identity.node);
  auto lock = std::make_unique<Lock>(files.lock);
  if (!lock->opened())
    return not_opened(files.lock.string() + ": " + std::generic_category().message(errno));
  if (!lock->held()) return not_opened(files.state.string() + ": another process uses it", true);
  auto impl = std::make_unique<Impl>(files, identity, std::move(lock), largest);
  try {
    std::string aside = impl->open();
    return Opened{std::unique_ptr<SqliteInputLog>(new SqliteInputLog(std::move(impl))),
                  std::move(aside)};
  } catch (const std::exception& thrown) {
    return not_opened(failure_of(files.state, thrown).why);
  }
}

Result<void, Failure> SqliteInputLog::append(const node::LogEntry& entry) {
  return impl_->append(entry);
}

std::string SqliteInputLog::take_news() { return impl_->take_news(); }

void SqliteInputLog::told(std::uint64_t lines) { impl_->told(lines); }
std::uint64_t SqliteInputLog::lines_told() const { return impl_->told(); }

Result<void, Failure> SqliteInputLog::recall(const Take& take) const {
  return read([](Database& database, const auto& row) { database.for_each(row); }, take);
}

Result<void, Failure> SqliteInputLog::recall_lives(const Take& take) const {
  return read(
      [](Database& database, const auto& row) { database.for_each_of(kinds_of_lives(), row); },
      take);
}

template <class ForEach>
Result<void, Failure> SqliteInputLog::read(const ForEach& for_each, const Take& take) const {
  Result<void, Failure> result;
  try {
    for_each(impl_->database(), [&](std::uint64_t number, const Row& row) {
      const auto entry = entry_of(row);
      result = entry ? take(*entry) : Result<void, Failure>(tl::unexpected(entry.error()));
      if (!result)
        result = failure(impl_->files().state.string() + ", input " + std::to_string(number) +
                         ": " + result.error().why);
      return result.has_value();
    });
  } catch (const std::exception& error) {
    return tl::unexpected(failure_of(impl_->files().state, error));
  }
  return result;
}

void SqliteInputLog::conclude() {
  try {
    impl_->database().set_about(kOver, "yes");
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove(impl_->files().complete, ignored);  // not to be resumed from, all the same
  }
}

bool SqliteInputLog::take_back() { return impl_->take_back(); }

Result<std::string, Failure> SqliteInputLog::start_anew() {
  try {
    return impl_->anew();
  } catch (const std::exception& error) {
    return tl::unexpected(failure_of(impl_->files().state, error));
  }
}

}  // namespace skein::store
