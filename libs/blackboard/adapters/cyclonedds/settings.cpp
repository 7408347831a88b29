// SPDX-License-Identifier: Apache-2.0
// The configuration of a Cyclone DDS domain. Source: Cyclone DDS 0.10, guide to configuration.
#include "settings.hpp"

#include <algorithm>

#include "adapters/rtps/datagram_size.hpp"
#include "adapters/rtps/ports.hpp"

namespace skein::blackboard::cyclonedds {
namespace {

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

std::string interfaces(const NetworkConfig& network) {
  std::string all;
  for (const std::string& address : network.interfaces) {
    all += "<NetworkInterface address=\"" + address + "\"/>";
  }
  return element("Interfaces", all);
}

/// What Cyclone DDS does by itself, but for datagrams that the network would cut up.
std::string sizes(const NetworkConfig& network) {
  constexpr std::uint32_t kUsual = 14'720, kUsualFragment = 1344, kAroundAFragment = 128;
  const std::uint32_t longest = std::min(kUsual, rtps::longest_datagram(network.interfaces));
  const std::uint32_t fragment = std::min(kUsualFragment, longest - kAroundAFragment);
  return element("MaxMessageSize", std::to_string(longest) + "B") +
         element("FragmentSize", std::to_string(fragment) + "B");
}

std::string peers(const DdsConfig& config) {
  std::string all;
  for (const NetworkAddress& place : rtps::places_to_look(config.network, config.domain)) {
    all += "<Peer address=\"" + place.address + ":" + std::to_string(place.port) + "\"/>";
  }
  return element("Peers", all);
}

}  // namespace

std::string settings(const DdsConfig& config, std::uint32_t number, const rtps::Pace& pace) {
  const auto ms = [](std::chrono::milliseconds period) {
    return std::to_string(period.count()) + "ms";
  };
  const std::string general =
      interfaces(config.network) +
      element("AllowMulticast", config.network.multicast ? "spdp" : "false") +
      sizes(config.network);
  // A domain within a process is created once; its number on the network is another thing.
  // Where no interface carries multicast, Cyclone DDS ignores ParticipantIndex and takes the first
  // free index up to MaxAutoParticipantIndex, of which 10 are not enough.
  const std::string discovery =
      element("ExternalDomainId", std::to_string(config.domain)) +
      element("ParticipantIndex", std::to_string(number)) +
      element("MaxAutoParticipantIndex", std::to_string(rtps::kParticipants - 1)) +
      element("SPDPInterval", ms(pace.announcement)) + element("LeaseDuration", ms(pace.lease)) +
      peers(config);
  // A writer that is deleted is cut off: it must not stay to say what it had left to say. And one
  // must not wait for readers that are slow: its history is bounded, and sessions do the rest.
  const std::string internal =
      "<SocketReceiveBufferSize min=\"default\" max=\"2MB\"/>"
      "<HeartbeatInterval max=\"" +
      ms(pace.heartbeat) + "\">" + ms(pace.heartbeat) + "</HeartbeatInterval>" +
      // Without a key hash Fast DDS does not understand which endpoint is gone.
      element("GenerateKeyhash", "true") + element("NackDelay", "10ms") +
      element("WriterLingerDuration", "0s") +
      element("Watermarks", element("WhcHigh", "1GB") + element("WhcLow", "1kB") +
                                element("WhcAdaptive", "false"));
  return element("CycloneDDS", "<Domain Id=\"any\">" + element("General", general) +
                                   element("Discovery", discovery) + element("Internal", internal) +
                                   "</Domain>");
}

}  // namespace skein::blackboard::cyclonedds
