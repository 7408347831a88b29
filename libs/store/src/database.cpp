// SPDX-License-Identifier: Apache-2.0
#include "database.hpp"

#include <zlib.h>

#include <set>
#include <stdexcept>

#include "folding.hpp"
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
constexpr const char* kTablesSince4 = R"(
  CREATE TABLE folds (
    first INTEGER PRIMARY KEY, inputs INTEGER NOT NULL, kinds TEXT NOT NULL, rows BLOB NOT NULL);
  ALTER TABLE inputs ADD COLUMN sum INTEGER;
)";
constexpr const char* kInsert =
    "INSERT INTO inputs (number, at, kind, peer, slot, value, extra, flags, body, sum) "
    "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";
/// Followed by what of them.
std::string select_inputs(int version) {
  return std::string("SELECT number, at, kind, peer, slot, value, extra, flags, body, ") +
         (version < 4 ? "NULL" : "sum") + " FROM inputs";
}
constexpr int kPatience = 1000;  ///< for somebody who reads [ms]
/// Of the write-ahead log: then it goes into the file, at the next end of a transaction.
constexpr std::uint64_t kPagesAhead = kLargestAhead / 4096;

int flags_of(Database::Mode mode) {
  // One thread has it: no lock for each value that is read.
  return SQLite::OPEN_NOMUTEX |
         (mode == Database::Mode::kRead ? SQLite::OPEN_READONLY
                                        : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
}

std::uint64_t number_of(SQLite::Statement& query) {
  return static_cast<std::uint64_t>(query.getColumn(0).getInt64());
}

std::vector<std::uint8_t> bytes_of(const SQLite::Column& column) {
  const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
  if (bytes == nullptr) return {};
  return {bytes, bytes + column.getBytes()};
}

/// CRC-32 of all that is in it, as it is in the file.
std::int64_t sum_of(std::uint64_t number, const Row& row) {
  uLong sum = crc32(0, nullptr, 0);
  const auto add = [&](const void* bytes, std::size_t size) {
    if (size == 0) return;  // of an empty vector, null: zlib would begin anew
    sum = crc32_z(sum, static_cast<const Bytef*>(bytes), size);
  };
  const auto as_signed = static_cast<std::int64_t>(number);
  for (const std::int64_t* one :
       {&as_signed, &row.at, &row.peer, &row.value, &row.extra, &row.flags})
    add(one, sizeof *one);
  add(row.kind.c_str(), row.kind.size() + 1);
  add(row.slot.c_str(), row.slot.size() + 1);
  add(row.body.data(), row.body.size());
  return static_cast<std::int64_t>(sum);
}

std::runtime_error damage(std::uint64_t number, const std::string& what) {
  return std::runtime_error("input " + std::to_string(number) + ": " + what);
}

/// As it is in the file. Rows of versions before the fourth have no checksum.
Row row_of(SQLite::Statement& query) {
  Row row{query.getColumn(1).getInt64(), query.getColumn(2).getString(),
          query.getColumn(3).getInt64(), query.getColumn(4).getString(),
          query.getColumn(5).getInt64(), query.getColumn(6).getInt64(),
          query.getColumn(7).getInt64(), bytes_of(query.getColumn(8))};
  const SQLite::Column sum = query.getColumn(9);
  if (!sum.isNull() && sum.getInt64() != sum_of(number_of(query), row))
    throw damage(number_of(query), "not what was written");
  return row;
}

void unpack(Packing& packing, std::uint64_t number, Row& row) {
  try {
    packing.unpack(row);
  } catch (const std::runtime_error& error) {
    throw damage(number, error.what());
  }
}

std::vector<Row> unfolded(std::uint64_t first, const std::vector<std::uint8_t>& folded) {
  try {
    return unfold(folded);
  } catch (const std::runtime_error& error) {
    throw damage(first, error.what());
  }
}

/// " received wakeup ": of which kinds there are some.
std::string kinds_of(const std::vector<Row>& rows) {
  std::set<std::string> kinds;
  for (const Row& row : rows) kinds.insert(row.kind);
  std::string text = " ";
  for (const std::string& kind : kinds) text += kind + " ";
  return text;
}

std::string marks_of(std::size_t values) {
  std::string marks;
  for (std::size_t i = 0; i < values; ++i) marks += i == 0 ? "?" : ", ?";
  return marks;
}

}  // namespace

Database::Database(const std::string& file, Mode mode, std::uint64_t largest)
    : database_(file, flags_of(mode), kPatience) {
  if (mode == Mode::kRead) return;
  if (largest > 0) {
    const auto page =
        static_cast<std::uint64_t>(database_.execAndGet("PRAGMA page_size").getInt64());
    database_.exec("PRAGMA max_page_count = " + std::to_string(largest / page + 1));
  }
  database_.exec(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = " +
      std::to_string(kPagesAhead) +
      "; PRAGMA journal_size_limit = " + std::to_string(kLargestAhead));
  if (version() < kVersion) bring_up();
  next_ = inputs() + 1;
}

/// All of it or nothing: a file is never between two versions.
void Database::bring_up() {
  SQLite::Transaction transaction(database_);
  if (version() < 1) database_.exec(kTables);
  if (version() == 1) database_.exec("INSERT OR IGNORE INTO about VALUES ('messages', '')");
  if (version() < 4) database_.exec(kTablesSince4);
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

void Database::insert(const std::deque<Row>& rows) {
  const std::uint64_t next = next_;
  try {
    if (rows.size() == 1) return insert(rows.front());  // a transaction of its own
    SQLite::Transaction transaction(database_);
    for (const Row& row : rows) insert(row);
    transaction.commit();
  } catch (...) {
    next_ = next;
    throw;
  }
}

void Database::insert(const Row& row) {
  if (!insert_) insert_.emplace(database_, kInsert);
  SQLite::Statement& insert = *insert_;
  insert.reset();
  insert.bind(1, static_cast<std::int64_t>(next_));
  insert.bind(2, row.at);
  insert.bindNoCopy(3, row.kind);
  insert.bind(4, row.peer);
  insert.bindNoCopy(5, row.slot);
  insert.bind(6, row.value);
  insert.bind(7, row.extra);
  insert.bind(8, row.flags);
  const void* bytes = row.body.empty() ? "" : static_cast<const void*>(row.body.data());
  insert.bindNoCopy(9, bytes, static_cast<int>(row.body.size()));  // a null pointer were NULL
  insert.bind(10, sum_of(next_, row));
  insert.exec();
  ++next_;
}

void Database::replace_by_fold(std::uint64_t first, const std::vector<Row>& rows) {
  SQLite::Statement put(database_, "INSERT INTO folds VALUES (?, ?, ?, ?)");
  const std::vector<std::uint8_t> folded = store::fold(rows);
  put.bind(1, static_cast<std::int64_t>(first));
  put.bind(2, static_cast<std::int64_t>(rows.size()));
  put.bind(3, kinds_of(rows));
  put.bindNoCopy(4, folded.data(), static_cast<int>(folded.size()));
  put.exec();
}

void Database::fold() {
  SQLite::Transaction transaction(database_);
  SQLite::Statement query(database_, select_inputs(kVersion) + " ORDER BY number");
  Packing packing;
  std::vector<Row> rows;
  std::uint64_t first = next_ - not_folded(), bytes = 0;
  const auto close = [&] {
    replace_by_fold(first, rows);
    first += rows.size();
    rows.clear();
    bytes = 0;
  };
  while (query.executeStep()) {
    if (number_of(query) != first + rows.size()) throw damage(first + rows.size(), "missing");
    rows.push_back(row_of(query));
    unpack(packing, first + rows.size() - 1, rows.back());
    bytes += rows.back().body.size();
    if (rows.size() == kFoldedRows || bytes >= kFoldedBytes) close();
  }
  if (!rows.empty()) close();
  query.reset();
  database_.exec("DELETE FROM inputs");
  transaction.commit();
}

/// False once `take` said no.
bool Database::for_each_folded(const std::string& where, const std::vector<std::string>& kinds,
                               const std::function<bool(std::uint64_t, Row&)>& take) {
  SQLite::Statement query(database_,
                          "SELECT first, inputs, rows FROM folds" + where + " ORDER BY first");
  for (std::size_t i = 0; i < kinds.size(); ++i)
    query.bind(static_cast<int>(i) + 1, " " + kinds[i] + " ");
  while (query.executeStep()) {
    std::uint64_t number = number_of(query);
    std::vector<Row> rows = unfolded(number, bytes_of(query.getColumn(2)));
    if (static_cast<std::int64_t>(rows.size()) != query.getColumn(1).getInt64())
      throw damage(number, "not as many are folded as were");
    for (Row& row : rows)
      if (!take(number++, row)) return false;
  }
  return true;
}

void Database::for_each(const std::function<bool(std::uint64_t, const Row&)>& take) {
  SQLite::Transaction moment(database_);  // nothing is folded meanwhile
  Packing packing;
  std::uint64_t next = 1;
  const auto give = [&](std::uint64_t number, Row& row) {
    if (number != next++) throw damage(next - 1, "missing");
    unpack(packing, number, row);
    return take(number, row);
  };
  if (version() >= 4 && !for_each_folded("", {}, give)) return;
  SQLite::Statement query(database_, select_inputs(version()) + " ORDER BY number");
  while (query.executeStep()) {
    Row row = row_of(query);
    if (!give(number_of(query), row)) return;
  }
}

void Database::for_each_of(const std::vector<std::string>& kinds,
                           const std::function<bool(std::uint64_t, const Row&)>& take) {
  SQLite::Transaction moment(database_);
  const std::set<std::string> wanted(kinds.begin(), kinds.end());
  std::string some = " WHERE first = 1";
  for (std::size_t i = 0; i < kinds.size(); ++i) some += " OR instr(kinds, ?)";
  const bool more =
      version() < 4 || for_each_folded(some, kinds, [&](std::uint64_t number, Row& row) {
        return (number != 1 && wanted.count(row.kind) == 0) || take(number, row);
      });
  if (!more) return;
  SQLite::Statement query(database_, select_inputs(version()) + " WHERE number = 1 OR kind IN (" +
                                         marks_of(kinds.size()) + ") ORDER BY number");
  for (std::size_t i = 0; i < kinds.size(); ++i) query.bind(static_cast<int>(i) + 1, kinds[i]);
  while (query.executeStep() && take(number_of(query), row_of(query))) {
  }
}

std::uint64_t Database::not_folded() {
  return static_cast<std::uint64_t>(database_.execAndGet("SELECT count(*) FROM inputs").getInt64());
}

std::uint64_t Database::inputs() {
  std::int64_t folded = 0;
  if (version() >= 4)
    folded = database_.execAndGet("SELECT ifnull(sum(inputs), 0) FROM folds").getInt64();
  return static_cast<std::uint64_t>(folded) + not_folded();
}

std::uint64_t Database::bytes_used() {
  const auto of = [&](const char* pragma) {
    return static_cast<std::uint64_t>(database_.execAndGet(pragma).getInt64());
  };
  return (of("PRAGMA page_count") - of("PRAGMA freelist_count")) * of("PRAGMA page_size");
}

std::string Database::soundness() {
  return database_.execAndGet("PRAGMA quick_check(1)").getString();
}

}  // namespace skein::store
