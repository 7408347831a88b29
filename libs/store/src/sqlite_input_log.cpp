// SPDX-License-Identifier: Apache-2.0
#include "skein/store/sqlite_input_log.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <deque>
#include <fstream>
#include <optional>
#include <system_error>

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

/// Gives the name under which it is now.
std::string set_aside(const Files& files) {
  fs::path name;
  for (int n = 1; name.empty() || fs::exists(name); ++n)
    name = files.state.string() + ".aside-" + std::to_string(n);
  std::error_code ignored;
  fs::rename(files.state, name, ignored);
  for (const char* companion : {"-wal", "-shm"})
    fs::rename(files.state.string() + companion, name.string() + companion, ignored);
  fs::remove(files.complete, ignored);
  return name;
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
  if (database.about(kMission) != identity.mission) return "of another scenario";
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
  Impl(Files files, Identity identity, std::unique_ptr<Lock> lock)
      : files_(std::move(files)), identity_(std::move(identity)), lock_(std::move(lock)) {}

  /// Gives what it set aside, as a sentence.
  std::string open() {
    std::string told;
    if (fs::exists(files_.state)) {
      std::string why;
      try {
        Database there(files_.state.string(), Database::Mode::kRead);
        why = objection(there, files_, identity_);
      } catch (const std::exception& error) {
        why = std::string("damaged: ") + error.what();
      }
      if (!why.empty()) {
        const std::string now = set_aside(files_);
        told = files_.state.string() + " is " + why + "; it is " + now + " now";
      }
    }
    begin();
    return told;
  }

  void begin() {
    database_.emplace(files_.state.string(), Database::Mode::kWrite);
    const bool fresh = database_->inputs() == 0;
    SQLite::Transaction transaction(database_->raw());
    database_->set_about(kNode, identity_.node);
    database_->set_about(kMission, identity_.mission);
    if (fresh) database_->set_about(kMessages, wire::layout_mark());
    transaction.commit();
    told_ = static_cast<std::uint64_t>(database_->lines_told());
    mark_complete();
  }

  std::string anew() {
    database_.reset();
    held_.clear();
    packing_ = Packing();
    std::string now = set_aside(files_);
    begin();
    return now;
  }

  Result<void, Failure> append(const node::LogEntry& entry) {
    if (given_up_) return failure("it was given up");
    held_.push_back(row_of(entry));
    packing_.pack(held_.back());
    try {
      write_held();
    } catch (const std::exception& error) {
      unmark_complete();
      if (held_.size() > kHeld) give_up();
      return tl::unexpected(failure_of(files_.state, error));
    }
    if (!complete_) mark_complete();
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

  std::uint64_t told() const { return told_; }
  Database& database() { return *database_; }
  const Files& files() const { return files_; }

 private:
  // One insertion is a transaction of its own.
  void write_held() {
    if (held_.size() == 1) {
      database_->insert(held_.front());
      held_.clear();
      return;
    }
    SQLite::Transaction transaction(database_->raw());
    for (const Row& row : held_) database_->insert(row);
    transaction.commit();
    held_.clear();
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
  std::uint64_t told_ = 0;
  bool complete_ = true, given_up_ = false;
};

SqliteInputLog::SqliteInputLog(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SqliteInputLog::~SqliteInputLog() = default;

Result<Opened, Failure> SqliteInputLog::open(const fs::path& folder, const Identity& identity) {
  std::error_code error;
  fs::create_directories(folder, error);
  const Files files = files_of(folder, identity.node);
  auto lock = std::make_unique<Lock>(files.lock);
  if (!lock->opened())
    return failure(files.lock.string() + ": " + std::generic_category().message(errno));
  if (!lock->held()) return failure(files.state.string() + ": another process uses it");
  auto impl = std::make_unique<Impl>(files, identity, std::move(lock));
  try {
    std::string aside = impl->open();
    return Opened{std::unique_ptr<SqliteInputLog>(new SqliteInputLog(std::move(impl))),
                  std::move(aside)};
  } catch (const std::exception& thrown) {
    return tl::unexpected(failure_of(files.state, thrown));
  }
}

Result<void, Failure> SqliteInputLog::append(const node::LogEntry& entry) {
  return impl_->append(entry);
}

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

Result<std::string, Failure> SqliteInputLog::start_anew() {
  try {
    return impl_->anew();
  } catch (const std::exception& error) {
    return tl::unexpected(failure_of(impl_->files().state, error));
  }
}

}  // namespace skein::store
