// SPDX-License-Identifier: Apache-2.0
// The tables of a state file. What SQLite has to complain about comes as an exception of
// SQLiteCpp's (SQLite::Exception) out of here, and goes no further than the library.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Of the format below; files of a newer one are not read, of an older one brought up to it when
/// they are opened to be written. 1: inputs. 2: the layout of the messages in them as well, in
/// `about` under "messages"; empty in a file that was brought up. 3: bodies may be packed, which
/// each row says of itself.
inline constexpr int kVersion = 3;

/// The tables: `about` (what: value) and `inputs`.
class Database {
 public:
  enum class Mode { kWrite, kRead };
  /// Begins the tables in an empty file. Precondition of kRead: the file exists.
  Database(const std::string& file, Mode mode);

  int version();
  /// Empty if it was never said.
  std::string about(const std::string& what);
  void set_about(const std::string& what, const std::string& value);
  std::int64_t lines_told();
  void set_lines_told(std::int64_t lines);

  /// As it is: who inserts rows packs them, in their order.
  void insert(const Row& row);
  /// In the order of insertion, unpacked, until `take` says no.
  void for_each(const std::function<bool(std::uint64_t number, const Row&)>& take);
  /// The first, and those of these kinds; as they are, nothing is unpacked.
  void for_each_of(const std::vector<std::string>& kinds,
                   const std::function<bool(std::uint64_t number, const Row&)>& take);
  std::uint64_t inputs();
  /// What SQLite says of the file: "ok" if it is sound.
  std::string soundness();
  SQLite::Database& raw() { return database_; }

 private:
  void bring_up();

  SQLite::Database database_;
  std::optional<SQLite::Statement> insert_, told_;
};

}  // namespace skein::store
