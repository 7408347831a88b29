// SPDX-License-Identifier: Apache-2.0
// Any bytes as a network, of one agent or of several: no crash, no broken contract; what is read is
// well formed, can be written in every format that holds it, and is then read back.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/temporal/stnu_fault.hpp"
#include "skein/temporal_files/drawing.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace {

using skein::temporal::Format;
using skein::temporal::ReadNetwork;
using skein::temporal::Stnu;

constexpr std::size_t kMostDrawn = 40;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_written(const Stnu& network) {
  for (const Format format : {Format::kJson, Format::kHeatlab, Format::kGraphml, Format::kPlain}) {
    const auto text = skein::temporal::write_network(network, format);
    if (!text) continue;
    const auto again = skein::temporal::read_network(*text);
    require(again.has_value() && again->format == format);
    require(format != Format::kJson || again->network == network);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = skein::temporal::read_network(text);
  require(read || !read.error().empty());
  if (read) {
    require(!skein::temporal::find_fault(read->network));
    check_written(read->network);
    static_cast<void>(skein::temporal::draw_dot(read->network, {}));
    if (read->network.nodes.size() <= kMostDrawn) {
      static_cast<void>(skein::temporal::draw_svg(read->network, {}));
    }
  }
  if (const auto mastn = skein::temporal::read_mastn(text)) {
    const auto again = skein::temporal::read_mastn(skein::temporal::write_mastn(*mastn));
    require(again && *again == *mastn);
  }
  return 0;
}
