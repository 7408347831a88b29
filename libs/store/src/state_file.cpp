// SPDX-License-Identifier: Apache-2.0
#include "skein/store/state_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "database.hpp"
#include "skein/blackboard/wire_layout.hpp"

namespace skein::store {

namespace {

namespace fs = std::filesystem;

/// What `read` makes of the file; what it throws, and what SQLite finds wrong, is a failure.
template <class Read>
auto reading(const fs::path& file, Read read) -> decltype(read(std::declval<Database&>())) {
  if (const std::string why = unreadable(file); !why.empty())
    return failure(file.string() + ": " + why);
  try {
    Database database(file.string(), Database::Mode::kRead);
    if (database.version() == 0) return failure(file.string() + ": not a state file");
    if (database.version() > kVersion)
      return failure(file.string() + ": of version " + std::to_string(database.version()) +
                     ", this program reads up to " + std::to_string(kVersion) +
                     ": only a newer one goes on from it");
    return read(database);
  } catch (const std::exception& error) {
    return failure(file.string() + ": damaged: " + error.what());
  }
}

Result<void, Failure> for_each(
    Database& database, const fs::path& file,
    const std::function<void(std::uint64_t, const Row&, const node::LogEntry&)>& take) {
  Result<void, Failure> result;
  database.for_each([&](std::uint64_t number, const Row& row) {
    const auto entry = entry_of(row);
    if (entry) {
      take(number, row, *entry);
    } else {
      result =
          failure(file.string() + ": input " + std::to_string(number) + ": " + entry.error().why);
    }
    return entry.has_value();
  });
  return result;
}

void count(StateFile& found, const Row& row, const node::LogEntry& entry) {
  if (found.inputs++ == 0) found.from = entry.at;
  found.until = entry.at;
  ++found.by_kind[row.slot.empty() ? row.kind : row.kind + " " + row.slot];
  if (row.kind == "started" || row.kind == "resumed") ++found.lives;
}

std::uint64_t size_of(const fs::path& file) {
  std::uint64_t bytes = 0;
  for (const char* part : {"", "-wal"}) {
    std::error_code missing;
    const auto size = fs::file_size(file.string() + part, missing);
    if (!missing) bytes += size;
  }
  return bytes;
}

}  // namespace

std::string unreadable(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return "no such file";
  if (error) return error.message();
  if (fs::is_directory(status)) return "a folder; the state of a node is its file NODE.state";
  if (!fs::is_regular_file(status)) return "no regular file";
  if (::access(file.c_str(), R_OK) != 0) return std::generic_category().message(errno);
  return {};
}

Result<StateFile, Failure> examine(const fs::path& file) {
  return reading(file, [&](Database& database) -> Result<StateFile, Failure> {
    StateFile found;
    found.version = database.version();
    found.identity = {database.about("node"), database.about("mission")};
    found.over = !database.about("over").empty();
    found.complete = fs::exists(fs::path(file).replace_extension(".complete"));
    const std::string messages = database.about("messages");
    found.of_this_wire = messages.empty() || messages == wire::layout_mark();
    found.lines = static_cast<std::uint64_t>(database.lines_told());
    found.bytes = size_of(file);
    if (const std::string sound = database.soundness(); sound != "ok")
      return failure(file.string() + ": damaged: " + sound);
    const auto read =
        for_each(database, file, [&](std::uint64_t, const Row& row, const node::LogEntry& entry) {
          count(found, row, entry);
        });
    if (!read) return tl::unexpected(read.error());
    return found;
  });
}

Result<void, Failure> for_each_input(
    const fs::path& file, const std::function<void(std::uint64_t, const node::LogEntry&)>& take) {
  return reading(file, [&](Database& database) {
    return for_each(database, file,
                    [&](std::uint64_t number, const Row&, const node::LogEntry& entry) {
                      take(number, entry);
                    });
  });
}

}  // namespace skein::store
