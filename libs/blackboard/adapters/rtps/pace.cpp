// SPDX-License-Identifier: Apache-2.0
// How often the protocol itself speaks, beside the samples.
#include "pace.hpp"

#include <algorithm>

namespace skein::blackboard::rtps {
namespace {

using std::chrono::milliseconds;

constexpr double kBitsPerByte = 8;
/// As measured, with what carries them [byte].
constexpr double kAnnouncement = 900, kHeartbeat = 110;
constexpr double kForAnnouncements = 0.05, kForAWriter = 0.02;  ///< shares of the channel
constexpr milliseconds kRarestAnnouncement{20'000}, kRarestHeartbeat{5000};
/// A silent participant must not be forgotten for a few announcements that were lost: to meet it
/// again takes more of the channel than anything else.
constexpr int kAnnouncementsInALease = 5;

milliseconds period(double bytes, double share, double capacity) {
  return milliseconds(static_cast<std::int64_t>(1000 * bytes * kBitsPerByte / (share * capacity)));
}

}  // namespace

Pace pace_of(double capacity) {
  Pace pace;
  if (capacity <= 0) return pace;
  pace.announcement = std::clamp(period(kAnnouncement, kForAnnouncements, capacity),
                                 pace.announcement, kRarestAnnouncement);
  pace.lease = std::max(pace.lease, kAnnouncementsInALease * pace.announcement);
  pace.heartbeat =
      std::clamp(period(kHeartbeat, kForAWriter, capacity), pace.heartbeat, kRarestHeartbeat);
  return pace;
}

Pace pace_of(const TransportPlan& plan) {
  double narrowest = 0;
  for (const ChannelConfig& channel : plan.channels) {
    if (channel.capacity <= 0) continue;
    narrowest = narrowest > 0 ? std::min(narrowest, channel.capacity) : channel.capacity;
  }
  return pace_of(narrowest);
}

}  // namespace skein::blackboard::rtps
