// SPDX-License-Identifier: Apache-2.0
#include "ears.hpp"

#include "skein/blackboard/dds_transport.hpp"

namespace skein::run_tool {

Result<void, Failure> Ears::open(blackboard::Now now) {
  const node::Member& self = *roster_.find(roster_.runner());
  auto transport = blackboard::make_dds_transport(config_);
  transport->on_arrival(notify_);
  blackboard::Config config;
  config.self = self.number;
  config.incarnation = static_cast<std::uint64_t>(now.steady.count());
  config.channels = roster_.channels_of(self);
  config.world_reads = roster_.world_reads_of(self.role);
  auto board = blackboard::Blackboard::open(std::move(config), *transport);
  if (!board) return tl::unexpected(board.error());
  if (board_) last_ = listen(now);
  board_ = std::move(*board);  // before the transport that the former one uses
  transport_ = std::move(transport);
  return {};
}

std::vector<blackboard::Incoming> Ears::listen(blackboard::Now now) {
  std::vector<blackboard::Incoming> heard = std::exchange(last_, {});
  for (blackboard::Incoming& one : board_->step(now))
    if (is_news(one)) heard.push_back(std::move(one));
  return heard;
}

bool Ears::is_news(const blackboard::Incoming& incoming) {
  const auto* received = std::get_if<blackboard::Received>(&incoming);
  if (received == nullptr) return true;
  const auto* record = std::get_if<wire::JournalEntry>(&received->sample);
  return record == nullptr || records_.is_news(received->origin, *record);
}

}  // namespace skein::run_tool
