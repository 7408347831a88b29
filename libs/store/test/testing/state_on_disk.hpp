// SPDX-License-Identifier: Apache-2.0
// A state file in a folder of its own, and what is in it as texts.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "skein/store/sqlite_input_log.hpp"
#include "testing/entries.hpp"

namespace skein::store::testing {

inline std::vector<std::string> texts(const node::InputLog& log) {
  std::vector<std::string> found;
  const auto read = log.recall([&](const node::LogEntry& entry) -> Result<void, Failure> {
    found.push_back(to_text(entry));
    return {};
  });
  if (!read) found.push_back("FAILED " + read.error().why);
  return found;
}

inline std::vector<std::string> texts(const std::vector<node::LogEntry>& entries) {
  std::vector<std::string> found;
  for (const node::LogEntry& entry : entries) found.push_back(to_text(entry));
  return found;
}

inline std::vector<std::string> texts_of_lives(const node::InputLog& log) {
  std::vector<std::string> found;
  const auto read = log.recall_lives([&](const node::LogEntry& entry) -> Result<void, Failure> {
    found.push_back(to_text(entry));
    return {};
  });
  if (!read) found.push_back("FAILED " + read.error().why);
  return found;
}

/// What a program of version 1 to 3 left, by its own tables.
inline void leave_version(int version, const std::filesystem::path& state) {
  SQLite::Database old(state.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  old.exec(std::string(
               "CREATE TABLE about (what TEXT PRIMARY KEY, value) WITHOUT ROWID;"
               "CREATE TABLE inputs (number INTEGER PRIMARY KEY, at INTEGER NOT NULL, kind TEXT "
               "NOT NULL,"
               "  peer INTEGER NOT NULL, slot TEXT NOT NULL, value INTEGER NOT NULL, extra INTEGER "
               "NOT NULL,"
               "  flags INTEGER NOT NULL, body BLOB NOT NULL);"
               "INSERT INTO about VALUES ('node', 'marvin'), ('mission', 'comets 1'), ('lines', 7);"
               "INSERT INTO inputs (at, kind, peer, slot, value, extra, flags, body) VALUES"
               "  (0, 'started', 0, '', 5, 0, 0, x''), (1000, 'wakeup', 0, '', 0, 0, 0, x'');") +
           "PRAGMA user_version = " + std::to_string(version));
  std::ofstream(std::filesystem::path(state).replace_extension("complete")).put('\n');
}

class StateOnDisk : public ::testing::Test {
 protected:
  Opened open(const Identity& identity = {"marvin", "comets 1"}) {
    auto opened = SqliteInputLog::open(folder.path(), identity);
    if (!opened) throw std::runtime_error(opened.error().why);
    return std::move(*opened);
  }
  /// A life that is given one of each and dies.
  void live() {
    const Opened life = open();
    for (const node::LogEntry& entry : one_of_each()) {
      const auto kept = life.log->append(entry);
      ASSERT_TRUE(kept.has_value()) << kept.error().why;
    }
    life.log->told(12);
  }
  std::filesystem::path state() const { return folder.path() / "marvin.state"; }

  Folder folder;
};

}  // namespace skein::store::testing
