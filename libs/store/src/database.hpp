// SPDX-License-Identifier: Apache-2.0
// The tables of a state file. Errors of SQLite are thrown as SQLite::Exception (SQLiteCpp), which
// the library catches.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Version of the file format. Files of newer versions are not read; files of older ones are
/// migrated when they are opened for writing. 1: inputs. 2: also the wire layout of their samples,
/// in `about` under "messages" (empty in a migrated file). 3: bodies may be packed; a flag of each
/// row says so. 4: rows have checksums (rows of older versions none), and older rows are folded.
inline constexpr int kVersion = 4;

/// Rows are folded when this number of rows, or of bytes in their bodies, is reached.
inline constexpr std::uint64_t kFoldedRows = 4096, kFoldedBytes = 4U << 20;

/// The write-ahead log beside the file has no more than this and one transaction [bytes]; while
/// somebody reads it grows, and is cut to this when he has read.
inline constexpr std::uint64_t kLargestAhead = 2U << 20;

/// The tables: `about` (what: value), `folds` (folding.hpp), and `inputs` after them.
class Database {
 public:
  enum class Mode { kWrite, kRead };
  /// Opens the file, and makes the tables if it is empty. kWrite: the file never gets larger than
  /// `largest` [bytes]. Precondition of kRead: the file exists.
  Database(const std::string& file, Mode mode, std::uint64_t largest = 0);

  int version();
  /// The value under this key; empty if there is none.
  std::string about(const std::string& what);
  void set_about(const std::string& what, const std::string& value);
  std::int64_t lines_told();
  void set_lines_told(std::int64_t lines);

  /// Inserts the rows unchanged, all or none. The caller packs them before, in their order.
  void insert(const std::deque<Row>& rows);
  /// Folds all rows of `inputs`, in one transaction. Rows inserted later must be packed by a new
  /// Packing.
  void fold();
  /// Calls `take` with each row, unpacked, in the order of insertion, until it returns false.
  /// Throws std::runtime_error at a row that is missing or damaged.
  void for_each(const std::function<bool(std::uint64_t number, const Row&)>& take);
  /// Calls `take` with the first row and the rows of these kinds; packed bodies stay packed.
  void for_each_of(const std::vector<std::string>& kinds,
                   const std::function<bool(std::uint64_t number, const Row&)>& take);
  std::uint64_t inputs();
  std::uint64_t not_folded();
  std::uint64_t bytes_used();  ///< size of the file without its free pages
  /// The result of SQLite's integrity check: "ok" if the file is sound.
  std::string soundness();
  SQLite::Database& raw() { return database_; }

 private:
  void bring_up();
  void insert(const Row& row);
  void replace_by_fold(std::uint64_t first, const std::vector<Row>& rows);
  bool for_each_folded(const std::string& where, const std::vector<std::string>& kinds,
                       const std::function<bool(std::uint64_t, Row&)>& take);

  SQLite::Database database_;
  std::optional<SQLite::Statement> insert_, told_;
  std::uint64_t next_ = 1;  ///< number of the next row; used by kWrite only
};

}  // namespace skein::store
