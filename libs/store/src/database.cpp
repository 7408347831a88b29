// SPDX-License-Identifier: Apache-2.0
#include "database.hpp"

#include "packing.hpp"

namespace skein::store {

namespace {

constexpr const char* kTables = R"(
  CREATE TABLE IF NOT EXISTS about (what TEXT PRIMARY KEY, value) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS inputs (
    number INTEGER PRIMARY KEY, at INTEGER NOT NULL, kind TEXT NOT NULL, peer INTEGER NOT NULL,
    slot TEXT NOT NULL, value INTEGER NOT NULL, extra INTEGER NOT NULL, flags INTEGER NOT NULL,
    body BLOB NOT NULL);
)";
constexpr const char* kInsert =
    "INSERT INTO inputs (at, kind, peer, slot, value, extra, flags, body) "
    "VALUES (?, ?, ?, ?, ?, ?, ?, ?)";
constexpr const char* kSelect =
    "SELECT number, at, kind, peer, slot, value, extra, flags, body FROM inputs";
constexpr int kPatience = 1000;  ///< for somebody who reads [ms]

int flags_of(Database::Mode mode) {
  // One thread has it: no lock for each value that is read.
  return SQLite::OPEN_NOMUTEX |
         (mode == Database::Mode::kRead ? SQLite::OPEN_READONLY
                                        : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
}

std::uint64_t number_of(SQLite::Statement& query) {
  return static_cast<std::uint64_t>(query.getColumn(0).getInt64());
}

Row row_of(SQLite::Statement& query) {
  Row row{query.getColumn(1).getInt64(), query.getColumn(2).getString(),
          query.getColumn(3).getInt64(), query.getColumn(4).getString(),
          query.getColumn(5).getInt64(), query.getColumn(6).getInt64(),
          query.getColumn(7).getInt64(), {}};
  const SQLite::Column body = query.getColumn(8);
  const auto* bytes = static_cast<const std::uint8_t*>(body.getBlob());
  if (bytes != nullptr) row.body.assign(bytes, bytes + body.getBytes());
  return row;
}

}  // namespace

Database::Database(const std::string& file, Mode mode)
    : database_(file, flags_of(mode), kPatience) {
  if (mode == Mode::kRead) return;
  database_.exec(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;"
      "PRAGMA wal_autocheckpoint = 4000;");
  if (version() < kVersion) bring_up();
}

/// All of it or nothing: a file is never between two versions.
void Database::bring_up() {
  SQLite::Transaction transaction(database_);
  if (version() < 1) database_.exec(kTables);
  if (version() == 1) database_.exec("INSERT OR IGNORE INTO about VALUES ('messages', '')");
  database_.exec("PRAGMA user_version = " + std::to_string(kVersion));
  transaction.commit();
}

int Database::version() { return database_.execAndGet("PRAGMA user_version").getInt(); }

std::string Database::about(const std::string& what) {
  SQLite::Statement query(database_, "SELECT value FROM about WHERE what = ?");
  query.bind(1, what);
  return query.executeStep() ? query.getColumn(0).getString() : std::string();
}

void Database::set_about(const std::string& what, const std::string& value) {
  SQLite::Statement change(database_, "INSERT OR REPLACE INTO about VALUES (?, ?)");
  change.bind(1, what);
  change.bind(2, value);
  change.exec();
}

std::int64_t Database::lines_told() {
  SQLite::Statement query(database_, "SELECT value FROM about WHERE what = 'lines'");
  return query.executeStep() ? query.getColumn(0).getInt64() : 0;
}

void Database::set_lines_told(std::int64_t lines) {
  if (!told_) told_.emplace(database_, "INSERT OR REPLACE INTO about VALUES ('lines', ?)");
  told_->reset();
  told_->bind(1, lines);
  told_->exec();
}

void Database::insert(const Row& row) {
  if (!insert_) insert_.emplace(database_, kInsert);
  SQLite::Statement& insert = *insert_;
  insert.reset();
  insert.bind(1, row.at);
  insert.bindNoCopy(2, row.kind);
  insert.bind(3, row.peer);
  insert.bindNoCopy(4, row.slot);
  insert.bind(5, row.value);
  insert.bind(6, row.extra);
  insert.bind(7, row.flags);
  const void* bytes = row.body.empty() ? "" : static_cast<const void*>(row.body.data());
  insert.bindNoCopy(8, bytes, static_cast<int>(row.body.size()));  // a null pointer were NULL
  insert.exec();
}

void Database::for_each(const std::function<bool(std::uint64_t, const Row&)>& take) {
  SQLite::Statement query(database_, std::string(kSelect) + " ORDER BY number");
  Packing packing;
  while (query.executeStep()) {
    const std::uint64_t number = number_of(query);
    Row row = row_of(query);
    try {
      packing.unpack(row);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("input " + std::to_string(number) + ": " + error.what());
    }
    if (!take(number, row)) return;
  }
}

void Database::for_each_of(const std::vector<std::string>& kinds,
                           const std::function<bool(std::uint64_t, const Row&)>& take) {
  std::string marks;
  for (std::size_t i = 0; i < kinds.size(); ++i) marks += i == 0 ? "?" : ", ?";
  SQLite::Statement query(
      database_, std::string(kSelect) +
                     " WHERE number = (SELECT min(number) FROM inputs) OR kind IN (" + marks +
                     ") ORDER BY number");
  for (std::size_t i = 0; i < kinds.size(); ++i) query.bind(static_cast<int>(i) + 1, kinds[i]);
  while (query.executeStep() && take(number_of(query), row_of(query))) {
  }
}

std::uint64_t Database::inputs() {
  return static_cast<std::uint64_t>(database_.execAndGet("SELECT count(*) FROM inputs").getInt64());
}

std::string Database::soundness() {
  return database_.execAndGet("PRAGMA quick_check(1)").getString();
}

}  // namespace skein::store
