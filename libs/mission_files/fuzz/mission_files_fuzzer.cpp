// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the reading of other programs' missions; and what is accepted
// is on Earth and finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/mission_files/read.hpp"

namespace {

using skein::mission_files::Contents;
using skein::mission_files::Height;
using skein::mission_files::LatLon;

void require(bool condition) {
  if (!condition) std::abort();
}

void look_at(const LatLon& at) {
  require(std::abs(at.latitude) <= 90 && std::abs(at.longitude) <= 180);
}
void look_at(const std::optional<Height>& height) {
  require(!height || std::isfinite(height->metres));
}

void look_at(const Contents& contents) {
  using namespace skein::mission_files;  // NOLINT(google-build-using-namespace): its types
  require(contents.items.size() <= kMostParts);
  for (const Item& item : contents.items) {
    if (const auto* fly = std::get_if<FlyTo>(&item.step)) {
      look_at(fly->to.at);
      look_at(fly->to.height);
      require(fly->hold >= 0);
    }
  }
  for (const Fence& fence : contents.fences)
    if (const auto* ring = std::get_if<std::vector<LatLon>>(&fence.shape))
      require(ring->size() >= 3);
  for (const Area& area : contents.areas) require(area.ring.size() >= 3);
  for (const Way& way : contents.ways) require(way.points.size() >= 2);
  for (const Place& place : contents.places) look_at(place.position.at);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = skein::mission_files::read_text(text, "fuzzed");
  if (read)
    look_at(*read);
  else
    require(!read.error().empty());
  return 0;
}
