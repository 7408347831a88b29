// SPDX-License-Identifier: Apache-2.0
// The memory of a node on disk.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "skein/node/input_log.hpp"

namespace skein::store {

/// Whose memory it is, and of which mission. A memory of anything else is not read.
struct Identity {
  std::string node;
  std::string mission;  ///< differs when the scenario, or what the daemon was told besides, does
  bool operator==(const Identity&) const = default;
};

class SqliteInputLog;

/// What was found and made of it.
struct Opened {
  std::unique_ptr<SqliteInputLog> log;  ///< never null
  std::string set_aside;  ///< empty, or what was found, why it is not read, where it is now
};

/// One SQLite file in WAL mode: NODE.state in a folder, beside it NODE.complete as long as nothing
/// that was handled is missing. An append is a transaction; it is there when the process is killed
/// right after (after a power cut the last ones may be missing, and the file is sound).
///
/// When the disk takes nothing, or the file would be larger than it may, what comes is held in
/// memory and tried again with the next; until then the file counts as incomplete and is not
/// resumed from. Of more than kHeld inputs it gives up for this life. Of all but the last inputs
/// many are kept as one, made in the append that fills it; where that fails, for want of room, they
/// stay as they are until as many have come again, and take_news() says so, and that it worked
/// again. So it does once three quarters of what the file may have are used. Thread rule: one
/// thread. Cost: docs/performance.md.
class SqliteInputLog final : public node::InputLog {
 public:
  static constexpr std::size_t kHeld = 200'000;
  static constexpr std::uint64_t kLargest = 256U << 20;  ///< [bytes]
  static constexpr std::size_t kSetAside = 5;  ///< files of a node that are kept, the last ones

  /// Opens the memory of this node, or begins one of at most `largest` [bytes]. What is there but
  /// damaged, of another node or mission, of a newer version, incomplete, or of a mission that is
  /// over, is set aside under another name; of kSetAside before it the eldest is deleted. The
  /// failure says why nothing can be kept there: folder not writable, in use by another process.
  static Result<Opened, Failure> open(const std::filesystem::path& folder, const Identity& identity,
                                      std::uint64_t largest = kLargest);
  ~SqliteInputLog() override;

  Result<void, Failure> append(const node::LogEntry& entry) override;
  std::string take_news() override;
  void told(std::uint64_t lines) override;
  Result<void, Failure> recall(const Take& take) const override;
  Result<void, Failure> recall_lives(const Take& take) const override;
  std::uint64_t lines_told() const override;

  /// The mission is over: there is nothing to come back to.
  void conclude();
  /// It cannot be the memory of this node after all: it is set aside, and another begun. Gives
  /// where it is now, in words.
  Result<std::string, Failure> start_anew();

 private:
  class Impl;
  explicit SqliteInputLog(std::unique_ptr<Impl> impl);
  template <class ForEach>
  Result<void, Failure> read(const ForEach& for_each, const Take& take) const;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::store
