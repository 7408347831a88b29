// SPDX-License-Identifier: Apache-2.0
// Event sessions against everything a network can do.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <set>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {
namespace {

const Node kSender{NodeNumber(1), "sender"};
const Node kReceiver{NodeNumber(2), "receiver"};

/// A transport that keeps its promises even less than the port allows: each sample lies in a pool
/// until somebody delivers it, drops it, or delivers it and leaves it there.
class Pool {
 public:
  struct InFlight {
    NodeNumber to;
    wire::Sample sample;
  };
  std::deque<InFlight> in_flight;
  std::map<NodeNumber, std::vector<wire::Sample>> mailboxes;

  void deliver(std::size_t choice, bool keep) {
    if (in_flight.empty()) return;
    const auto at = in_flight.begin() + static_cast<std::ptrdiff_t>(choice % in_flight.size());
    mailboxes[at->to].push_back(at->sample);
    if (!keep) in_flight.erase(at);
  }
  void drop(std::size_t choice) {
    if (in_flight.empty()) return;
    in_flight.erase(in_flight.begin() + static_cast<std::ptrdiff_t>(choice % in_flight.size()));
  }
  void deliver_all() {
    while (!in_flight.empty()) deliver(0, false);
  }
};

class PoolTransport final : public Transport {
 public:
  explicit PoolTransport(Pool& pool) : pool_(pool) {}
  Result<void, Failure> open(const TransportPlan& plan) override {
    plan_ = plan;
    pool_.mailboxes[plan_.self].clear();
    return {};
  }
  bool write(std::size_t channel, const wire::Sample& sample) override {
    pool_.in_flight.push_back({plan_.channels[channel].to, sample});
    return true;
  }
  Result<void, Failure> set_up(std::size_t, bool) override { return {}; }
  std::vector<Arrival> take() override {
    std::vector<Arrival> arrivals;
    for (wire::Sample& sample : pool_.mailboxes[plan_.self]) {
      const NodeNumber origin(wire::header_of(sample).origin);
      const auto from = std::ranges::find(plan_.channels, origin, &ChannelConfig::from);
      arrivals.push_back({static_cast<std::size_t>(from - plan_.channels.begin()), sample});
    }
    pool_.mailboxes[plan_.self].clear();
    return arrivals;
  }
  void on_arrival(std::function<void()>) override {}

 private:
  Pool& pool_;
  TransportPlan plan_;
};

/// A sender and a receiver over a Pool, and what an onlooker knows of every event.
class World {
 public:
  World() {
    restart_sender();
    restart_receiver();
  }

  void restart_sender() {
    sender_ = start(kSender, ++sender_incarnation_);
    owed_.clear();    // what it had not delivered is gone with it
    untold_.clear();  // and with whom it would have told
    first_of_sender_ = last_sent_ + 1;
  }
  void restart_receiver() {
    receiver_ = start(kReceiver, ++receiver_incarnation_);
    last_handled_ = 0;
  }

  void send(std::uint64_t lifetime) {
    wire::TaskEvent event;
    event.id = ++last_sent_;
    const MissionTime expires =
        lifetime == 0 ? MissionTime::max()
                      : now_.mission + Duration::milliseconds(static_cast<std::int64_t>(lifetime));
    const auto sent = sender_->board->send(event, kReceiver.number, now_, {expires, last_sent_});
    if (!sent) return;
    by_sequence_[{sender_incarnation_, *sent}] = last_sent_;
    if (last_sent_ >= first_of_sender_) untold_.insert(last_sent_);
    if (lifetime == 0) owed_.insert(last_sent_);
    expires_[last_sent_] = expires;
  }

  void cut(bool up) {
    const ChannelCondition condition{.up = up, .latency = {}, .loss = 0};
    sender_->board->set_condition(kSender.number, kReceiver.number, condition, now_);
  }

  void pass(std::int64_t milliseconds) {
    now_.steady = now_.steady + Duration::milliseconds(milliseconds);
    now_.mission = now_.mission + Duration::milliseconds(milliseconds);
  }

  void step_sender() {
    for (const Incoming& incoming : sender_->board->step(now_)) {
      if (const auto* delivered = std::get_if<EventDelivered>(&incoming)) see(*delivered);
      const auto* expired = std::get_if<EventExpired>(&incoming);
      if (expired != nullptr) RC_ASSERT(untold_.erase(id_of(*expired)) == 1U);
    }
    if (!nothing_held()) return;
    for (std::uint64_t id = first_of_sender_; id <= last_sent_; ++id) settled_.insert(id);
  }
  void step_receiver() {
    for (const Incoming& incoming : receiver_->board->step(now_)) {
      if (const auto* late = std::get_if<EventExpired>(&incoming)) arrived_.insert(id_of(*late));
      const auto* received = std::get_if<Received>(&incoming);
      if (received == nullptr) continue;
      handle(std::get<wire::TaskEvent>(received->sample).id);
    }
  }

  /// A good network for a while.
  void exchange(std::int64_t milliseconds) {
    pool.deliver_all();
    step_sender();
    step_receiver();
    pass(milliseconds);
  }
  /// And for long enough.
  void heal() {
    cut(true);
    for (int i = 0; i < 200; ++i) exchange(25);
  }

  std::uint64_t handled() const { return handled_; }
  bool nothing_untold() const { return untold_.empty(); }
  bool nothing_owed() const { return owed_.empty(); }
  bool nothing_held() const { return sender_->board->unacknowledged(kReceiver.number) == 0; }

  Pool pool;

 private:
  struct Running {
    std::unique_ptr<PoolTransport> transport;
    std::unique_ptr<Blackboard> board;
  };

  std::unique_ptr<Running> start(const Node& node, std::uint64_t incarnation) {
    Config config;
    config.self = node.number;
    config.incarnation = incarnation;
    config.channels = radio_link(kSender, kReceiver);
    config.held_events = 64;
    auto running = std::make_unique<Running>();
    running->transport = std::make_unique<PoolTransport>(pool);
    running->board = std::make_unique<Blackboard>(
        std::move(*Blackboard::open(std::move(config), *running->transport)));
    return running;
  }

  std::uint64_t id_of(const EventExpired& expired) const {
    return by_sequence_.at({expired.incarnation, expired.sequence});
  }

  /// Told once, instead of an expiry, in the order sent, and of what was there.
  void see(const EventDelivered& delivered) {
    RC_ASSERT(delivered.to == kReceiver.number);
    RC_ASSERT(untold_.erase(delivered.receipt) == 1U);
    RC_ASSERT(delivered.receipt > last_delivered_);
    RC_ASSERT(arrived_.contains(delivered.receipt));
    last_delivered_ = delivered.receipt;
  }

  /// Ids grow with sending, over all incarnations of the sender: so order and uniqueness for one
  /// incarnation of the receiver are that they only grow.
  void handle(std::uint64_t id) {
    RC_ASSERT(id > last_handled_);
    RC_ASSERT(expires_.at(id) >= now_.mission);
    RC_ASSERT(!settled_.contains(id));
    last_handled_ = id;
    arrived_.insert(id);
    ++handled_;
    owed_.erase(id);
  }

  Now now_;
  std::uint64_t sender_incarnation_ = 0;
  std::uint64_t receiver_incarnation_ = 0;
  std::unique_ptr<Running> sender_;
  std::unique_ptr<Running> receiver_;
  std::uint64_t last_sent_ = 0;
  std::uint64_t last_handled_ = 0;
  std::uint64_t handled_ = 0;
  std::set<std::uint64_t> owed_;     ///< accepted, without expiry, never handled
  std::set<std::uint64_t> settled_;  ///< the sender holds them no more: not to be handled again
  std::uint64_t first_of_sender_ = 1;
  std::map<std::uint64_t, MissionTime> expires_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> by_sequence_;
  std::set<std::uint64_t> arrived_;  ///< handled, or found too late
  std::set<std::uint64_t> untold_;   ///< neither delivered nor expired for its sender
  std::uint64_t last_delivered_ = 0;
};

/// One thing that happens. Half of them keep the session alive, so that the others have something
/// to disturb.
void act(World& world, std::uint8_t what, std::uint8_t argument) {
  switch (what % 20) {
    case 0:
    case 1:
    case 2:
    case 3:
      return world.send(0);
    case 4:
      return world.send(argument * 4U + 1U);
    case 5:
    case 6:
      return world.pool.deliver(argument, false);
    case 7:
    case 8:
      return world.pool.deliver(argument, true);
    case 9:
      return world.pool.drop(argument);
    case 10:
    case 11:
      return world.step_sender();
    case 12:
    case 13:
      return world.step_receiver();
    case 14:
    case 15:
    case 16:
      return world.exchange(argument);
    case 17:
      return world.pass(argument * 4);
    case 18:
      return world.cut(argument % 3 != 0);
    default:
      if (argument % 4 == 0) return world.restart_sender();
      if (argument % 4 == 1) return world.restart_receiver();
      return world.exchange(5);
  }
}

using Script = std::vector<std::pair<std::uint8_t, std::uint8_t>>;

RC_GTEST_PROP(EventSession, HandlesEveryEventOnceAndInOrderWhateverHappens, ()) {
  const auto script = *rc::gen::scale(
      4.0, rc::gen::container<Script>(rc::gen::pair(rc::gen::arbitrary<std::uint8_t>(),
                                                    rc::gen::arbitrary<std::uint8_t>())));
  World world;
  for (int i = 0; i < 4; ++i) world.exchange(50);

  for (const auto& [what, argument] : script) act(world, what, argument);
  world.heal();

  RC_ASSERT(world.nothing_owed());
  RC_ASSERT(world.nothing_held());
  RC_ASSERT(world.nothing_untold());
  RC_CLASSIFY(world.handled() >= 5, "at least 5 events handled");
}

}  // namespace
}  // namespace skein::blackboard
