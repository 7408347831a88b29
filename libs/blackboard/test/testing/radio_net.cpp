// SPDX-License-Identifier: Apache-2.0
#include "testing/radio_net.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::blackboard::testing {
namespace {

Node node_of(int number) {
  return {NodeNumber(static_cast<std::uint32_t>(number)), "n" + std::to_string(number)};
}

}  // namespace

/// Sees what is written, and loses what the radio loses.
class RadioNet::Radio final : public Transport {
 public:
  Radio(RadioNet& net, int self) : net_(net), self_(self), inner_(net.hub_) {}

  Result<void, Failure> open(const TransportPlan& plan) override {
    channels_ = plan.channels;
    return inner_.open(plan);
  }
  bool write(std::size_t channel, const wire::Sample& sample) override {
    net_.note_written(self_, static_cast<int>(channels_[channel].to.value()), sample);
    return inner_.write(channel, sample);
  }
  Result<void, Failure> set_up(std::size_t channel, bool up) override {
    return inner_.set_up(channel, up);
  }
  std::vector<Arrival> take() override {
    std::vector<Arrival> all = inner_.take();
    std::erase_if(all, [&](const Arrival& one) {
      const auto* sample = std::get_if<wire::Sample>(&one.content);
      return sample != nullptr &&
             wire::slot_class(wire::slot_of(*sample)) == wire::SlotClass::kStream &&
             net_.random_.chance(net_.setup_.loss);
    });
    if (net_.setup_.garble) net_.setup_.garble(all);
    return all;
  }
  void on_arrival(std::function<void()> notify) override { inner_.on_arrival(std::move(notify)); }

  void set_link_from(int from, bool up) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (static_cast<int>(channels_[i].from.value()) == from) (void)inner_.set_up(i, up);
    }
  }

 private:
  RadioNet& net_;
  int self_;
  MemoryTransport inner_;
  std::vector<ChannelConfig> channels_;
};

RadioNet::RadioNet(Setup setup) : setup_(std::move(setup)), random_(setup_.seed, "radio-net") {
  for (int node = 1; node <= setup_.nodes; ++node) start(node);
}

RadioNet::~RadioNet() { nodes_.clear(); }

void RadioNet::start(int node) {
  nodes_.erase(node);
  Config config;
  config.self = node_of(node).number;
  config.incarnation = ++incarnations_[node];
  config.heartbeat_period = setup_.period;
  config.retransmission = Duration::nanoseconds(setup_.period.count() + setup_.period.count() / 2);
  config.seed = setup_.seed;
  config.relaying.most_relays = setup_.most_relays;
  for (const int relay : setup_.relays) config.relaying.relays.insert(node_of(relay).number);
  for (int other = 1; other <= setup_.nodes; ++other) {
    if (other == node) continue;
    for (ChannelConfig channel : radio_link(node_of(node), node_of(other))) {
      const auto relays = [&](NodeNumber end) { return config.relaying.relays.contains(end); };
      if (!setup_.relays.empty()) {
        RelayEnds ends;
        ends.from = relays(channel.from);
        ends.to = relays(channel.to);
        add_relayed(channel, ends);
      }
      config.channels.push_back(std::move(channel));
    }
  }
  Running& running = nodes_[node];
  running.radio = std::make_unique<Radio>(*this, node);
  auto opened = Blackboard::open(std::move(config), *running.radio);
  SKEIN_ENSURES(opened.has_value());
  running.blackboard = std::make_unique<Blackboard>(std::move(*opened));
  for (const auto& [from, to] : cut_) {
    if (to == node) running.radio->set_link_from(from, false);
  }
  ChannelCondition condition;
  condition.latency = setup_.latency;
  condition.capacity = setup_.capacity;
  for (int other = 1; other <= setup_.nodes; ++other) {
    running.blackboard->set_condition(node_of(node).number, node_of(other).number, condition, at());
    running.blackboard->set_condition(node_of(other).number, node_of(node).number, condition, at());
  }
}

void RadioNet::kill(int node) { nodes_.erase(node); }

bool RadioNet::lives(int node) const { return nodes_.contains(node); }

void RadioNet::set_link(int from, int to, bool up) {
  if (up == is_up(from, to)) return;
  if (up) {
    cut_.erase({from, to});
  } else {
    cut_.insert({from, to});
  }
  const auto found = nodes_.find(to);
  if (found != nodes_.end()) found->second.radio->set_link_from(from, up);
}

void RadioNet::set_both(int a, int b, bool up) {
  set_link(a, b, up);
  set_link(b, a, up);
}

std::uint64_t RadioNet::send_event(int from, int to) {
  wire::SyncMessage message;
  message.id = ++sent_;
  const auto sent = nodes_.at(from).blackboard->send(message, node_of(to).number, at());
  SKEIN_ENSURES(sent.has_value());
  return sent_;
}

void RadioNet::set_state(int from, int to, std::uint64_t value) {
  wire::PlanBoard board;
  board.tasks.resize(1);
  board.tasks.front().id = value;
  const auto sent = nodes_.at(from).blackboard->send(board, node_of(to).number, at());
  SKEIN_ENSURES(sent.has_value());
}

void RadioNet::send_stream(int from, int to, double value) {
  wire::Telemetry telemetry;
  telemetry.energy = static_cast<float>(value);
  const auto sent = nodes_.at(from).blackboard->send(telemetry, node_of(to).number, at());
  SKEIN_ENSURES(sent.has_value());
}

void RadioNet::say(int from, int to, wire::Sample sample) {
  (void)nodes_.at(from).blackboard->send(std::move(sample), node_of(to).number, at());
}

void RadioNet::note_written(int from, int to, const wire::Sample& sample) {
  ++written_;
  const wire::SampleHeader& header = wire::header_of(sample);
  std::set<std::uint32_t> met{header.origin};
  bool twice = false;
  for (const std::uint32_t relay : header.via) twice = !met.insert(relay).second || twice;
  if (twice || header.via.size() > setup_.most_relays) breaches_.push_back(wire::to_json(sample));
  if (wire::slot_class(wire::slot_of(sample)) == wire::SlotClass::kEvent)
    ++crossings_[{from, to, header.origin, header.destination, header.sequence_number}];
}

void RadioNet::note(int node, const Incoming& incoming) {
  if (const auto* route = std::get_if<RouteChanged>(&incoming)) routes_[node].push_back(*route);
  if (const auto* dropped = std::get_if<Dropped>(&incoming))
    breaches_.push_back("dropped: " + dropped->field + " " + dropped->why);
  const auto* received = std::get_if<Received>(&incoming);
  if (received == nullptr) return;
  const std::pair key{node, static_cast<int>(received->origin.value())};
  if (const auto* event = std::get_if<wire::SyncMessage>(&received->sample))
    handled_[key].push_back(event->id);
  const auto* board = std::get_if<wire::PlanBoard>(&received->sample);
  if (board != nullptr && !board->tasks.empty()) states_[key] = board->tasks.front().id;
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&received->sample))
    streams_[key].push_back(telemetry->energy);
}

void RadioNet::step_all() {
  for (bool busy = true; busy;) {
    busy = false;
    for (auto& [number, node] : nodes_) {
      const std::vector<Incoming> all = node.blackboard->step(at());
      for (const Incoming& one : all) note(number, one);
      busy = busy || !all.empty();
    }
  }
}

void RadioNet::run_for(Duration time) {
  const Duration end = now_ + time;
  run_until([] { return false; }, time);
  now_ = end;
}

bool RadioNet::run_until(const std::function<bool()>& holds, Duration at_most) {
  const Duration end = now_ + at_most;
  while (true) {
    step_all();
    if (holds()) return true;
    if (now_ >= end) return false;
    Duration next = end;
    for (const auto& [number, node] : nodes_) {
      if (const auto due = node.blackboard->next_wakeup()) next = std::min(next, *due);
    }
    now_ = std::max(next, now_ + Duration::milliseconds(1));
  }
}

bool RadioNet::reachable(int from, int to) const {
  return nodes_.at(from).blackboard->reachable(node_of(to).number);
}

}  // namespace skein::blackboard::testing
