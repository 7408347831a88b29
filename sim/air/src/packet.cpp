// SPDX-License-Identifier: Apache-2.0
#include "skein/air/packet.hpp"

namespace skein::air {
namespace {

constexpr std::uint32_t kNetwork = 0x0a630000;  ///< 10.99.0.0/16
constexpr std::uint32_t kMask = 0xffff0000;
constexpr std::size_t kHeader = 20;
constexpr std::size_t kTotalLengthAt = 2, kFragmentAt = 6, kDestinationAt = 16;
constexpr std::uint32_t kMoreFragments = 0x2000, kFragmentOffset = 0x1fff;

}  // namespace

std::optional<Route> route_of(std::span<const std::uint8_t> packet) {
  if (packet.size() < kHeader || packet[0] >> 4U != 4) return std::nullopt;
  const std::size_t length = packet[kTotalLengthAt] * 256U + packet[kTotalLengthAt + 1];
  if (length < kHeader || length > packet.size()) return std::nullopt;
  Route route;
  for (std::size_t i = 0; i < 4; ++i) route.to = route.to << 8U | packet[kDestinationAt + i];
  const bool multicast = route.to >> 28U == 0xe;
  const bool broadcast = route.to == 0xffffffff || route.to == (kNetwork | ~kMask);
  route.everybody = multicast || broadcast;
  const std::uint32_t fragment = packet[kFragmentAt] * 256U + packet[kFragmentAt + 1];
  route.piece = (fragment & (kMoreFragments | kFragmentOffset)) != 0;
  return route;
}

std::uint32_t address_of(std::size_t node) {
  return kNetwork + static_cast<std::uint32_t>(node) + 1;
}

std::optional<std::size_t> node_of(std::uint32_t address) {
  if ((address & kMask) != kNetwork || address == kNetwork || address == (kNetwork | ~kMask))
    return std::nullopt;
  return (address & ~kMask) - 1;
}

std::string to_text(std::uint32_t address) {
  std::string text;
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    text += (text.empty() ? "" : ".") + std::to_string(address >> shift & 255U);
  return text;
}

}  // namespace skein::air
