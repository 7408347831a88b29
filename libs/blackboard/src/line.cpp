// SPDX-License-Identifier: Apache-2.0
#include "line.hpp"

#include <algorithm>

namespace skein::blackboard {
namespace {

/// An event of more goes in parts [byte]; less is what would keep a narrow channel from heartbeats,
/// but not less than this.
constexpr double kLongEvent = 16'384, kLeastLongEvent = 1024;
/// Content of a part [byte], as long as the wire allows and no longer than others may wait for it.
constexpr double kLongestPart = 4096, kShortestPart = 512;
constexpr double kPartsASecond = 4;
/// A state of more goes in parts, on a channel of limited capacity.
constexpr std::size_t kPartsOfALongState = 2;
constexpr double kBitsPerByte = 8;

}  // namespace

Line::Line(PeerChannels channels, const Config& config) : channels_(channels), config_(&config) {
  limit(config.channels[channels.outgoing].capacity, {});
}

void Line::limit(double capacity, Duration now) {
  if (capacity <= 0) return limited_.reset();
  if (!limited_)
    limited_ = std::make_unique<LimitedChannel>(config_->channels[channels_.outgoing].slots,
                                                config_->shares, config_->heartbeat_period);
  limited_->set_capacity(capacity, now);
}

void Line::set_outgoing(const ChannelCondition& condition, Duration now) {
  outgoing_ = condition;
  const double declared = config_->channels[channels_.outgoing].capacity;
  const double capacity = condition.capacity > 0 ? condition.capacity : declared;
  if (condition.up || capacity > 0) limit(capacity, now);
  if (limited_ && !condition.up) limited_->cut();
}

void Line::set_way(std::size_t relays, bool heard_of) {
  relays_ = relays;
  heard_of_ = heard_of;
}

// Who is heard by somebody is only waited for while the way past that one opens.
Duration Line::silence_limit() const {
  const Duration period = config_->heartbeat_period;
  const Duration limit = period + period + period;
  return heard_of_ ? limit + limit : limit;
}

RoundTrip Line::round_trip() const {
  RoundTrip trip;
  trip.latency = outgoing_.latency + incoming_.latency;
  trip.out = limited_ ? limited_->capacity() : 0;
  trip.back =
      incoming_.capacity > 0 ? incoming_.capacity : config_->channels[channels_.incoming].capacity;
  trip.relays = relays_;
  trip.period = config_->heartbeat_period;
  return trip;
}

bool Line::is_long_event(const wire::Sample& event) const {
  const ChannelConfig& channel = config_->channels[channels_.outgoing];
  if (!channel.carries(wire::Slot::kPart)) return false;
  double most = kLongEvent;
  if (channel.capacity > 0) {
    const double in_two_periods =
        channel.capacity / kBitsPerByte * 2 * config_->heartbeat_period.to_seconds();
    most = std::clamp(in_two_periods, kLeastLongEvent, kLongEvent);
  }
  return static_cast<double>(channel_bytes(event)) > most;
}

bool Line::is_long_state(const wire::Sample& state) const {
  return wire::slot_class(wire::slot_of(state)) == wire::SlotClass::kState &&
         config_->channels[channels_.outgoing].carries(wire::Slot::kPart) &&
         channel_bytes(state) > kPartsOfALongState * bytes_of_a_part();
}

std::uint32_t Line::bytes_of_a_part() const {
  if (!limited_) return static_cast<std::uint32_t>(kLongestPart);
  return static_cast<std::uint32_t>(
      std::clamp(limited_->capacity() / kBitsPerByte / kPartsASecond, kShortestPart, kLongestPart));
}

}  // namespace skein::blackboard
