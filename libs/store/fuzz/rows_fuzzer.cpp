// SPDX-License-Identifier: Apache-2.0
// Any bytes as what a state file holds of a node's inputs, as folded rows or as one row: unfolded
// and read, or refused. What is read is written and read the same again.
#include <zstd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>

#include "folding.hpp"
#include "packing.hpp"

namespace {

using namespace skein::store;  // NOLINT(google-build-using-namespace): what is fuzzed

void require(bool condition) {
  if (!condition) std::abort();
}

void look_at(const Row& row) {
  const auto entry = entry_of(row);
  require(entry.has_value() || !entry.error().why.empty());
  if (!entry) return;
  const Row again = row_of(*entry);
  require(again.kind == row.kind && again.at == row.at);
  require(entry_of(again).has_value());
}

std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> plain) {
  std::vector<std::uint8_t> packed(ZSTD_compressBound(plain.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), 1));
  return packed;
}

/// Numbers first, then kind and slot by their first byte, then the body.
Row row_in(std::span<const std::uint8_t> bytes) {
  constexpr const char* kKinds[] = {"started",   "received", "reachability", "undelivered",
                                    "delivered", "wakeup",   "job",          "resumed",
                                    "unsent",    "skipped",  "acknowledged", "nothing"};
  constexpr std::size_t kNumbers = 5 * sizeof(std::int64_t);
  Row row;
  if (bytes.size() < kNumbers + 2) return row;
  for (std::int64_t* const one : {&row.at, &row.peer, &row.value, &row.extra, &row.flags}) {
    std::memcpy(one, bytes.data(), sizeof(*one));
    bytes = bytes.subspan(sizeof(*one));
  }
  row.kind = kKinds[bytes[0] % std::size(kKinds)];
  row.slot = std::string(
      skein::wire::slot_name(static_cast<skein::wire::Slot>(bytes[1] % skein::wire::kSlotCount)));
  row.body.assign(bytes.begin() + 2, bytes.end());
  return row;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    if (data[0] == 'F') {
      for (const Row& row : unfold(compressed({data + 1, size - 1}))) look_at(row);
    } else {
      Packing packing;
      Row row = row_in({data + 1, size - 1});
      packing.unpack(row);
      look_at(row);
    }
  } catch (const std::runtime_error& refused) {
    require(*refused.what() != '\0');
  }
  return 0;
}
