// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <ostream>
#include <set>

#include "recorder.hpp"
#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/node/waker.hpp"
#include "skein/spy_tool/record.hpp"

namespace skein::spy_tool {

namespace {

using blackboard::ChannelKind;
using blackboard::NodeNumber;

/// Of no node.
constexpr std::uint32_t kPlayerNumber = 4'000'000'002;
constexpr std::uint32_t kNobody = 4'000'000'001;
constexpr Duration kLinger = Duration::milliseconds(500);  ///< for what is resent at the end

ChannelKind kind_of(const std::string& partition) {
  if (partition == blackboard::world_channel().partition) return ChannelKind::kWorld;
  return partition.starts_with("onboard/") ? ChannelKind::kOnboard : ChannelKind::kRadio;
}

/// A channel for each partition of the samples, and which is whose.
class Stage {
 public:
  explicit Stage(const std::vector<Taken>& samples) {
    std::map<std::string, std::set<wire::Slot>> slots;
    for (const Taken& one : samples) slots[one.partition].insert(one.slot);
    plan_.self = NodeNumber(kPlayerNumber);
    for (const auto& [partition, all] : slots) {
      blackboard::ChannelConfig channel;
      channel.from = plan_.self;
      channel.to = NodeNumber(kNobody);
      channel.kind = kind_of(partition);
      channel.partition = partition;
      for (const wire::Slot slot : all)  // the heartbeat is on every channel that is not the world
        if (slot != wire::Slot::kHeartbeat || channel.kind == ChannelKind::kWorld)
          channel.slots.push_back(slot);
      channels_[partition] = plan_.channels.size();
      plan_.channels.push_back(std::move(channel));
    }
  }
  const blackboard::TransportPlan& plan() const { return plan_; }
  std::size_t channel_of(const Taken& one) const { return channels_.at(one.partition); }

 private:
  blackboard::TransportPlan plan_;
  std::map<std::string, std::size_t> channels_;
};

std::optional<std::vector<Taken>> read_samples(const std::string& name, std::ostream& err) {
  std::ifstream in(name, std::ios::binary);
  if (in) in.peek();
  if (!in.is_open() || in.bad()) {
    err << name << ": cannot be read\n";
    return std::nullopt;
  }
  const std::string file{std::istreambuf_iterator<char>(in), {}};
  std::vector<Taken> samples;
  const mcap::Contents contents =
      samples_of(file, [&](Taken taken) { samples.push_back(std::move(taken)); });
  for (const std::string& problem : contents.problems) err << name << ": " << problem << '\n';
  if (samples.empty()) {
    err << name << ": no samples of skein spy record\n";
    return std::nullopt;
  }
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Taken& a, const Taken& b) { return a.heard < b.heard; });
  return samples;
}

/// False when it was not taken, or was malformed.
bool write(blackboard::Transport& transport, const Stage& stage, const Taken& one) {
  const auto content = blackboard::decode(
      one.slot, {reinterpret_cast<const std::uint8_t*>(one.bytes.data()), one.bytes.size()});
  const auto* sample = std::get_if<wire::Sample>(&content);
  return sample != nullptr && transport.write(stage.channel_of(one), *sample);
}

struct Score {
  std::uint64_t written = 0, refused = 0;
};

Score play_all(const PlayOptions& options, const std::vector<Taken>& samples, const Stage& stage,
               blackboard::Transport& transport, node::Waker& waker) {
  Score score;
  const Duration begin = node::Waker::steady_now() + Duration::seconds(options.wait);
  for (const Taken& one : samples) {
    const double after = static_cast<double>(one.heard - samples.front().heard) * 1e-9;
    const Duration due = begin + Duration::seconds(after / options.rate);
    for (Duration now = node::Waker::steady_now(); now < due && !waker.stop_requested();
         now = node::Waker::steady_now())
      waker.wait(due - now);
    if (waker.stop_requested()) return score;
    ++(write(transport, stage, one) ? score.written : score.refused);
    if (score.written % 256 == 0) (void)transport.take();
  }
  waker.wait(kLinger);
  return score;
}

}  // namespace

int play(const PlayOptions& options, std::ostream& out, std::ostream& err) {
  const auto samples = read_samples(options.file, err);
  if (!samples) return kExitBadInput;
  node::Waker waker;  // before the middleware's threads: it blocks signals for them too
  const Stage stage(*samples);
  blackboard::DdsConfig config{options.domain, "play", options.network, {}};
  config.endpoints_at_once = true;
  const auto transport = blackboard::make_dds_transport(std::move(config));
  if (auto opened = transport->open(stage.plan()); !opened) {
    err << opened.error().why << '\n';
    return kExitSystem;
  }
  const Score score = play_all(options, *samples, stage, *transport, waker);
  out << score.written << " of " << samples->size() << " samples written\n";
  if (score.refused > 0)
    err << score.refused << " samples were malformed, or DDS did not take them\n";
  return waker.stop_requested() ? kExitInterrupted : kExitOk;
}

}  // namespace skein::spy_tool
