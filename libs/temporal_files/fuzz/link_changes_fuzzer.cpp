// SPDX-License-Identifier: Apache-2.0
// Any bytes as a script of changes of a network: no crash; what is read is between nodes of the
// network and can be carried out one after the other.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/temporal/stnu_fault.hpp"
#include "skein/temporal_files/link_changes.hpp"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace skein::temporal;  // NOLINT(google-build-using-namespace): its readers
  static const Stnu kNetwork{{"v0", "a", "b", "c"}, 0, {}, {}};
  const auto changes = read_changes({reinterpret_cast<const char*>(data), size}, kNetwork, "fuzz");
  require(changes.has_value() || !changes.error().empty());
  if (!changes) return 0;
  for (const Arc& one : *changes) {
    Stnu changed = kNetwork;
    changed.arcs.push_back(one);
    require(!find_fault(changed));
  }
  return 0;
}
