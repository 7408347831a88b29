// SPDX-License-Identifier: Apache-2.0
// The memory of a node on disk.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "skein/node/input_log.hpp"

namespace skein::store {

/// The node and the mission that a state file belongs to. A file with another identity is not read.
struct Identity {
  std::string node;
  std::string mission;  ///< differs if the scenario or other settings of the daemon differ
  bool operator==(const Identity&) const = default;
};

class SqliteInputLog;

/// The result of SqliteInputLog::open().
struct Opened {
  std::unique_ptr<SqliteInputLog> log;  ///< never null
  std::string set_aside;  ///< if an old file was not used: what it is, why, where it is now
};

/// Why no memory can be kept.
struct NotOpened {
  std::string why;
  bool in_use = false;  ///< another process has it open: the node runs already
};

/// The memory of a node in one SQLite file in WAL mode: NODE.state in a folder, with the marker
/// NODE.complete beside it as long as no handled input is missing. Each append is a transaction,
/// which survives a kill of the process right after it (after a power cut the last ones may be
/// missing, but the file is sound).
///
/// When the disk is full, or the file has reached its largest size, inputs are held in RAM and
/// written with a later append; until then the file counts as incomplete, and no life resumes from
/// it. With more than kHeld of them the log gives up for this life. All but the last inputs are
/// folded: many rows are compressed into one, in the append that completes their number. If folding
/// fails for lack of room, it is tried again when as many inputs have come again. take_news()
/// reports that failure, its end, and when three quarters of the largest size are used. Thread
/// rule: one thread. Cost: docs/performance.md.
class SqliteInputLog final : public node::InputLog {
 public:
  static constexpr std::size_t kHeld = 200'000;
  static constexpr std::uint64_t kLargest = 256U << 20;  ///< [bytes]
  static constexpr std::size_t kSetAside = 5;  ///< number of files set aside that are kept per node

  /// Opens the memory of this node, or begins one of at most `largest` [bytes]. A file that is
  /// damaged, of another node or mission, of a newer version, incomplete, or of a mission that is
  /// over, is set aside under another name; beyond kSetAside such files the oldest is deleted. The
  /// failure says why no memory can be kept: folder not writable, in use by another process.
  static Result<Opened, NotOpened> open(const std::filesystem::path& folder,
                                        const Identity& identity, std::uint64_t largest = kLargest);
  ~SqliteInputLog() override;

  Result<void, Failure> append(const node::LogEntry& entry) override;
  std::string take_news() override;
  void told(std::uint64_t lines) override;
  Result<void, Failure> recall(const Take& take) const override;
  Result<void, Failure> recall_lives(const Take& take) const override;
  std::uint64_t lines_told() const override;

  /// Marks the mission as over: no later life resumes from this file.
  void conclude();
  /// Sets the file aside, because it turned out not to be the memory of this node, and begins
  /// another. Returns a sentence that says where the old file is.
  Result<std::string, Failure> start_anew();
  /// Puts the memory of another scenario that open() set aside back in its place, as it was: this
  /// process did not begin to live. False: there was none, or it was incomplete. Nothing else may
  /// be called afterwards.
  bool take_back();

 private:
  class Impl;
  explicit SqliteInputLog(std::unique_ptr<Impl> impl);
  template <class ForEach>
  Result<void, Failure> read(const ForEach& for_each, const Take& take) const;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::store
