// SPDX-License-Identifier: Apache-2.0
#include "skein/air/air.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::air {

Air::Air(std::size_t nodes, std::uint64_t seed, Duration longest_queue)
    : nodes_(nodes), longest_queue_(longest_queue), channels_(nodes * nodes), random_(seed) {}

void Air::set(std::size_t from, std::size_t to, const Condition& condition) {
  SKEIN_EXPECTS(from < nodes_ && to < nodes_);
  at(from, to).condition = condition;
}

const Condition& Air::condition(std::size_t from, std::size_t to) const {
  return channels_[from * nodes_ + to].condition;
}

const Counts& Air::counts(std::size_t from, std::size_t to) const {
  return channels_[from * nodes_ + to].counts;
}

std::optional<Duration> Air::send(std::size_t from, std::size_t to, std::size_t bytes,
                                  Duration now) {
  SKEIN_EXPECTS(from < nodes_ && to < nodes_ && from != to);
  Channel& channel = at(from, to);
  const Condition& condition = channel.condition;
  if (!condition.up) {
    ++channel.counts.cut;
    return std::nullopt;
  }
  Duration out = std::max(now, channel.free);
  if (condition.rate > 0) {
    if (out - now > longest_queue_) {
      ++channel.counts.overflowed;
      return std::nullopt;
    }
    out = out + Duration::seconds(static_cast<double>(bytes) / condition.rate);
    channel.free = out;
  }
  // What is lost was sent all the same: it took its time on the channel.
  const double chance = std::generate_canonical<double, 53>(random_);
  if (chance < condition.loss) {
    ++channel.counts.lost;
    return std::nullopt;
  }
  channel.last = std::max(channel.last, out + condition.delay);
  return channel.last;
}

bool Air::arrives(std::size_t from, std::size_t to, std::size_t bytes) {
  Channel& channel = at(from, to);
  if (!channel.condition.up) {
    ++channel.counts.cut;
    return false;
  }
  ++channel.counts.carried;
  channel.counts.bytes += bytes;
  return true;
}

}  // namespace skein::air
