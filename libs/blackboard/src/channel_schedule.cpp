// SPDX-License-Identifier: Apache-2.0
#include "channel_schedule.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "skein/blackboard/channel.hpp"

namespace skein::blackboard {
namespace {

constexpr double kBitsPerByte = 8;
/// What a flow may save up: its fraction of so much time, and no less than a sample of this size,
/// so that who speaks seldom need not wait.
constexpr Duration kSaved = Duration::milliseconds(1000);
constexpr double kLeastSaved = 512;  ///< [byte]

}  // namespace

ChannelSchedule::ChannelSchedule(std::vector<SlotShare> flows)
    : ChannelSchedule(std::move(flows), 0, {}) {}

ChannelSchedule::ChannelSchedule(std::vector<SlotShare> flows, std::size_t bytes, Duration period)
    : first_bytes_(bytes), first_period_(period) {
  for (const SlotShare& share : flows) flows_.push_back({share, share.fraction, 0, {}, false});
}

void ChannelSchedule::set_capacity(double bits_per_second, Duration now) {
  if (bits_per_second == capacity_) return;
  const bool begins = capacity_ <= 0;
  if (!begins) fill(now);
  capacity_ = bits_per_second;
  filled_ = now;
  if (limited()) share_out();
  if (!begins) return;
  for (Flow& flow : flows_) flow.credit = depth(flow);
}

// What the first flow needs is taken from the others, in proportion.
void ChannelSchedule::share_out() {
  for (Flow& flow : flows_) flow.fraction = flow.share.fraction;
  if (first_bytes_ == 0) return;
  const double needed = std::min(
      1.0, blackboard::airtime(first_bytes_, capacity_).to_seconds() / first_period_.to_seconds());
  flows_[0].fraction = std::max(flows_[0].fraction, needed);
  double others = 0;
  for (std::size_t i = 1; i < flows_.size(); ++i) others += flows_[i].fraction;
  const double left = 1 - flows_[0].fraction;
  if (others <= left) return;
  for (std::size_t i = 1; i < flows_.size(); ++i) flows_[i].fraction *= left / others;
}

Duration ChannelSchedule::airtime(std::size_t bytes) const {
  return limited() ? blackboard::airtime(bytes, capacity_) : Duration{};
}

double ChannelSchedule::depth(const Flow& flow) const {
  if (flow.fraction <= 0) return 0;
  return std::max(flow.fraction * capacity_ / kBitsPerByte * kSaved.to_seconds(), kLeastSaved);
}

void ChannelSchedule::fill(Duration now) {
  const double seconds = (now - filled_).to_seconds();
  filled_ = now;
  for (Flow& flow : flows_) {
    const double more = flow.fraction * capacity_ / kBitsPerByte * seconds;
    flow.credit = std::min(depth(flow), flow.credit + more);
  }
}

// Of a sample greater than all that can be saved, a full bucket is enough; it is paid for after.
bool ChannelSchedule::has_credit(const Flow& flow, std::size_t bytes) const {
  if (flow.fraction <= 0) return false;
  return flow.credit >= std::min(static_cast<double>(bytes), depth(flow));
}

std::optional<std::size_t> ChannelSchedule::pick(std::span<const std::size_t> waiting,
                                                 Duration now) {
  fill(now);
  std::optional<std::size_t> best;
  const auto rank = [&](std::size_t i) {
    const Flow& flow = flows_[i];
    return std::tuple(!has_credit(flow, waiting[i]), -static_cast<int>(flow.share.priority),
                      flow.last_served, i);
  };
  for (std::size_t i = 0; i < flows_.size(); ++i) {
    Flow& flow = flows_[i];
    if (waiting[i] > 0 && !flow.waits) flow.last_served = now;
    flow.waits = waiting[i] > 0;
    if (flow.waits && (!best || rank(i) < rank(*best))) best = i;
  }
  return best;
}

Duration ChannelSchedule::write(std::size_t flow, std::size_t bytes, Duration now) {
  Flow& one = flows_[flow];
  if (has_credit(one, bytes)) one.credit -= static_cast<double>(bytes);
  one.last_served = now;
  free_at_ = std::max(free_at_, now) + airtime(bytes);
  return free_at_;
}

}  // namespace skein::blackboard
