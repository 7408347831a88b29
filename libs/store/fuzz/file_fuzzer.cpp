// SPDX-License-Identifier: Apache-2.0
// Any bytes as the state file of a node that comes back: it remembers, or begins anew with the old
// file set aside and a reason; and what `skein state` says of the file. Likewise as the file of its
// number.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "skein/store/incarnation.hpp"
#include "skein/store/sqlite_input_log.hpp"
#include "skein/store/state_file.hpp"
#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace skein::store;  // NOLINT(google-build-using-namespace): what is fuzzed

void require(bool condition) {
  if (!condition) std::abort();
}

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

void remember(const fs::path& folder, const std::string& bytes) {
  write(folder / "marvin.state", bytes);
  write(folder / "marvin.complete", "");
  const auto seen = examine(folder / "marvin.state");
  require(seen.has_value() || !seen.error().why.empty());
  const auto opened = SqliteInputLog::open(folder, {"marvin", "mission"});
  if (!opened) return require(!opened.error().why.empty());
  const auto take = [](const skein::node::LogEntry&) {
    return skein::Result<void, skein::Failure>();
  };
  const auto recalled = opened->log->recall(take);
  require(recalled.has_value() || !recalled.error().why.empty());
  (void)opened->log->recall_lives(take);
  require(
      opened->log->append({skein::MissionTime::seconds(1e6), skein::node::Wakeup{}}).has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const skein::testing::TemporaryFolder folder;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with("SQLite")) {
    remember(folder.path(), bytes);
  } else {
    write(folder.path() / "marvin.incarnation", bytes);
    const auto next = next_incarnation(folder.path(), "marvin", 1'000);
    require(next ? next->number >= 1'000 : !next.error().why.empty());
  }
  return 0;
}
