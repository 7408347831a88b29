// SPDX-License-Identifier: Apache-2.0
// The tables of a state file. What SQLite has to complain about comes as an exception of
// SQLiteCpp's (SQLite::Exception) out of here, and goes no further than the library.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Of the format below; files of a newer one are not read, of an older one brought up to it when
/// they are opened to be written. 1: inputs. 2: the layout of the messages in them as well, in
/// `about` under "messages"; empty in a file that was brought up. 3: bodies may be packed, which
/// each row says of itself. 4: rows have checksums (none in rows of before), and the older ones are
/// folded.
inline constexpr int kVersion = 4;

/// So much is folded at once: rows, or bytes of their bodies, whichever comes first.
inline constexpr std::uint64_t kFoldedRows = 4096, kFoldedBytes = 4U << 20;

/// The write-ahead log beside the file has no more than this and one transaction [bytes]; while
/// somebody reads it grows, and is cut to this when he has read.
inline constexpr std::uint64_t kLargestAhead = 2U << 20;

/// The tables: `about` (what: value), `folds` (folding.hpp), and `inputs` after them.
class Database {
 public:
  enum class Mode { kWrite, kRead };
  /// Begins the tables in an empty file, which never gets larger than `largest` [bytes]; a file
  /// that is stays as it is. Precondition of kRead: the file exists.
  Database(const std::string& file, Mode mode, std::uint64_t largest = 0);

  int version();
  /// Empty if it was never said.
  std::string about(const std::string& what);
  void set_about(const std::string& what, const std::string& value);
  std::int64_t lines_told();
  void set_lines_told(std::int64_t lines);

  /// As they are, all or none: who inserts rows packs them, in their order.
  void insert(const std::deque<Row>& rows);
  /// All rows of `inputs`, as one transaction. What is inserted after is packed anew.
  void fold();
  /// In the order of insertion, unpacked, until `take` says no. Throws std::runtime_error where one
  /// is missing or is not what was inserted.
  void for_each(const std::function<bool(std::uint64_t number, const Row&)>& take);
  /// The first, and those of these kinds; bodies that are packed stay so.
  void for_each_of(const std::vector<std::string>& kinds,
                   const std::function<bool(std::uint64_t number, const Row&)>& take);
  std::uint64_t inputs();
  std::uint64_t not_folded();
  std::uint64_t bytes_used();  ///< of the file, without what is free in it
  /// What SQLite says of the file: "ok" if it is sound.
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
  std::uint64_t next_ = 1;  ///< number of the next row; where rows are written
};

}  // namespace skein::store
