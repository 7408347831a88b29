// SPDX-License-Identifier: Apache-2.0
// Events over channels as they are on bad days: cuts that are told and cuts that are not, in one
// direction or both, limited capacity, restarts; against a model that knows only when events were
// sent, until when they counted, and when the channel carried.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/memory_transport.hpp"

namespace skein::blackboard {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(200);
const std::array<Node, 2> kNodes{Node{NodeNumber(1), "a"}, Node{NodeNumber(2), "b"}};
Duration milliseconds(std::size_t n) {
  return Duration::milliseconds(static_cast<std::int64_t>(n));
}

/// The onlooker: what became of each event, and whether it had to.
class Model {
 public:
  struct Event {
    std::size_t from = 0;
    std::uint64_t sender_life = 0;
    Duration sent, expires;
    bool handled = false, reported = false;
    bool had_contact = false;  ///< long enough, between sending and expiry
  };

  void send(std::uint64_t id, std::size_t from, Duration now, Duration expires) {
    events_[id] = {from, lives_[from], now, expires};
  }
  void handle(std::uint64_t id, std::size_t by, Duration now) {
    Event& event = events_.at(id);
    RC_ASSERT(event.from != by);
    RC_ASSERT(now <= event.expires);
    RC_ASSERT(id > last_handled_[by]);  // ids grow: once and in order
    last_handled_[by] = id;
    event.handled = true;
  }
  void report(std::uint64_t id) { events_.at(id).reported = true; }
  void restart(std::size_t node, Duration now) {
    ++lives_[node];
    last_handled_[node] = 0;
    disturb(now);
  }
  /// Something changed: contact begins anew.
  void disturb(Duration now) { undisturbed_since_ = now; }
  void pass(Duration now, bool carries, Duration enough) {
    if (!carries) return disturb(now);
    for (auto& [id, event] : events_) {
      if (event.handled || event.sender_life != lives_[event.from]) continue;
      const Duration since = std::max(event.sent, undisturbed_since_);
      const Duration latest = std::min(now, event.expires);
      if (latest - since > enough) event.had_contact = true;
    }
  }
  void judge() const {
    for (const auto& [id, event] : events_) {
      const bool sender_lives = event.sender_life == lives_[event.from];
      if (event.had_contact) RC_ASSERT(event.handled);
      if (!event.handled && sender_lives) RC_ASSERT(event.reported);
    }
  }
  std::size_t count(bool Event::*what) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(events_, [&](const auto& entry) { return entry.second.*what; }));
  }

 private:
  std::map<std::uint64_t, Event> events_;
  std::array<std::uint64_t, 2> lives_{1, 1};
  std::array<std::uint64_t, 2> last_handled_{0, 0};
  Duration undisturbed_since_;
};

class Link {
 public:
  Link() {
    for (std::size_t node : {0, 1}) start(node);
    pass(Duration::milliseconds(500));
  }

  void send(std::size_t from, std::size_t size, Duration lifetime) {
    wire::TaskEvent event;
    event.id = ++last_id_;
    event.type = std::string(size, 'x');
    const Duration expires = lifetime == Duration{} ? Duration::max() : now_ + lifetime;
    const MissionTime at =
        lifetime == Duration{} ? MissionTime::max() : MissionTime() + now_ + lifetime;
    const auto sent = boards_[from]->send(event, kNodes[1 - from].number, now(), {at});
    if (!sent) return;
    sequences_[{from, lives_[from], *sent}] = last_id_;
    bytes_ += size + 300;
    model.send(last_id_, from, now_, expires);
  }
  void send_stream(std::size_t from, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      wire::Telemetry telemetry;
      telemetry.header.instance = i % 3;
      RC_ASSERT(boards_[from]->send(telemetry, kNodes[1 - from].number, now()).has_value());
    }
  }
  void carry(std::size_t from, bool carries) {
    carries_[from] = carries;
    model.disturb(now_);
    hub_.carry(kNodes[from].number, kNodes[1 - from].number, carries);
  }
  void tell(bool up, double capacity) {
    up_ = up;
    capacity_ = capacity;
    model.disturb(now_);
    for (std::size_t node : {0, 1}) tell(node);
  }
  void restart(std::size_t node) {
    start(node);
    model.restart(node, now_);
  }

  void pass(Duration time) {
    const Duration until = now_ + time;
    while (now_ < until) {
      Duration next = until;
      for (const auto& board : boards_) {
        if (const auto due = board->next_wakeup()) next = std::min(next, *due);
        if (const auto due = board->next_expiry()) next = std::min(next, *due - MissionTime());
      }
      now_ = std::max(now_, next);
      settle();
      model.pass(now_, carries_[0] && carries_[1] && up_, enough());
    }
  }
  /// A good channel for long enough.
  void heal() {
    for (const std::size_t from : {0, 1}) carry(from, true);
    tell(true, 0);
    pass(milliseconds(70'000));
  }
  std::size_t held() const {
    return boards_[0]->unacknowledged(kNodes[1].number) +
           boards_[1]->unacknowledged(kNodes[0].number);
  }

  Model model;

 private:
  Now now() const { return {MissionTime() + now_, now_}; }

  void start(std::size_t node) {
    boards_[node].reset();
    transports_[node].reset();
    Config config;
    config.self = kNodes[node].number;
    config.incarnation = ++lives_[node];
    config.channels = radio_link(kNodes[0], kNodes[1]);
    config.heartbeat_period = kPeriod;
    config.held_events = 200;
    transports_[node] = std::make_unique<MemoryTransport>(hub_);
    boards_[node] = std::make_unique<Blackboard>(
        std::move(*Blackboard::open(std::move(config), *transports_[node])));
    tell(node);
  }
  void tell(std::size_t node) {
    const ChannelCondition condition{up_, Duration::milliseconds(20), 0, capacity_};
    for (const std::size_t from : {0, 1}) {
      boards_[node]->set_condition(kNodes[from].number, kNodes[1 - from].number, condition, now());
    }
  }
  // At one instant, until nobody has anything to do any more.
  void settle() {
    for (bool busy = true; busy;) {
      busy = false;
      for (const std::size_t node : {0, 1}) {
        for (const Incoming& incoming : boards_[node]->step(now())) {
          busy = true;
          see(node, incoming);
        }
      }
    }
  }
  void see(std::size_t node, const Incoming& incoming) {
    if (const auto* received = std::get_if<Received>(&incoming)) {
      const auto* event = std::get_if<wire::TaskEvent>(&received->sample);
      if (event != nullptr) model.handle(event->id, node, now_);
    } else if (const auto* expired = std::get_if<EventExpired>(&incoming)) {
      if (expired->from != kNodes[node].number) return;
      model.report(sequences_.at({node, lives_[node], expired->sequence}));
    }
  }
  /// What an undisturbed channel needs at most for anything: the longest time-out, which is that of
  /// the greatest capacity that was slow, and for everything that ever was sent, twice.
  Duration enough() const {
    const double slowest = 16'000;
    const Duration timeout = Duration::milliseconds(300 + 40) + airtime(512 + 512 + 960, slowest);
    return Duration::nanoseconds(timeout.count() * (OutgoingEvents_kMostBackOff + 2)) +
           airtime(2 * bytes_, slowest) + milliseconds(3 * 200);
  }
  static constexpr std::int64_t OutgoingEvents_kMostBackOff = 8;

  MemoryHub hub_;
  Duration now_;
  bool up_ = true;
  double capacity_ = 0;
  std::array<bool, 2> carries_{true, true};
  std::array<std::uint64_t, 2> lives_{0, 0};
  std::array<std::unique_ptr<MemoryTransport>, 2> transports_;
  std::array<std::unique_ptr<Blackboard>, 2> boards_;
  std::uint64_t last_id_ = 0;
  std::size_t bytes_ = 0;
  std::map<std::tuple<std::size_t, std::uint64_t, std::uint64_t>, std::uint64_t> sequences_;
};

void act(Link& link, std::uint8_t what, std::uint8_t argument) {
  const std::size_t side = argument % 2;
  switch (what % 16) {
    case 0:
    case 1:
    case 2:
      return link.send(side, argument, {});
    case 3:
    case 4:
      return link.send(side, argument, milliseconds(1 + argument * 200U));
    case 5:
      for (int i = 0; i < argument % 32; ++i) link.send(side, argument, milliseconds(40'000));
      return;
    case 6:
      return link.send_stream(side, argument % 16);
    case 7:
      return link.carry(side, argument % 4 > 1);
    case 8:
      link.carry(0, argument % 4 > 1);
      return link.carry(1, argument % 4 > 1);
    case 9:
      return link.tell(argument % 4 != 0, argument % 3 == 0 ? 0 : 16'000 + argument * 400.0);
    case 10:
      if (argument % 8 == 0) return link.restart(argument / 8 % 2);
      return link.pass(milliseconds(5));
    default:
      return link.pass(milliseconds(argument * 20U));
  }
}

using Script = std::vector<std::pair<std::uint8_t, std::uint8_t>>;

RC_GTEST_PROP(ChannelLaw, EveryEventIsHandledOnceAndInOrderIfContactAllowsAndElseReported, ()) {
  const auto script = *rc::gen::scale(
      2.0, rc::gen::container<Script>(rc::gen::pair(rc::gen::arbitrary<std::uint8_t>(),
                                                    rc::gen::arbitrary<std::uint8_t>())));
  Link link;
  for (const auto& [what, argument] : script) act(link, what, argument);
  link.heal();

  link.model.judge();
  RC_ASSERT(link.held() == 0U);
  RC_CLASSIFY(link.model.count(&Model::Event::handled) >= 5, "at least 5 handled");
  RC_CLASSIFY(link.model.count(&Model::Event::reported) >= 1, "some reported");
}

}  // namespace
}  // namespace skein::blackboard
