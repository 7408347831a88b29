// SPDX-License-Identifier: Apache-2.0
#include "testing/ping_system.hpp"

#include <map>
#include <tuple>

#include "skein/foundation/random.hpp"
#include "testing/fake_node.hpp"

namespace skein::node::testing {

namespace {

constexpr Duration kPeriod = Duration::milliseconds(300);

// Sends every period to somebody, and writes what it gets.
class PingNode final : public Node {
 public:
  PingNode(const Roster& roster, const Member& self, std::uint64_t seed)
      : self_(self), random_(seed, "ping " + self.name) {
    for (const Member& other : roster.members()) {
      if (other.role == wire::Role::kRunner || other.role == wire::Role::kSim) continue;
      if (other.number != self.number) peers_.push_back(other.number);
    }
  }

  Effects handle(const Input& input, MissionTime now) override {
    if (const auto* started = std::get_if<Started>(&input)) {
      life_ = started->incarnation;
      next_ = now + kPeriod;
    }
    if (const auto* received = std::get_if<Received>(&input)) return {Log{heard(*received, now)}};
    if (!std::holds_alternative<Wakeup>(input)) return {};
    next_ = now + Duration::nanoseconds(kPeriod.count() / 2 +
                                        static_cast<std::int64_t>(random_.below(300'000'000)));
    return ping();
  }
  std::optional<MissionTime> next_wakeup() const override { return next_; }

 private:
  Effects ping() {
    if (peers_.empty()) return {};
    const NodeNumber to = peers_[random_.below(peers_.size())];
    wire::Telemetry telemetry;
    telemetry.position.x = static_cast<float>(random_.uniform(0, 100));
    return {Send{to, abort_request(++sent_)}, Send{to, telemetry}, Send{to, wire::PlanBoard{}}};
  }

  journal::Record heard(const Received& received, MissionTime now) const {
    const auto& header = wire::header_of(received.sample);
    return journal::Record(now, self_.name, "heard")
        .with("slot", wire::slot_name(wire::slot_of(received.sample)))
        .with("from", received.from.value())
        .with("their", header.incarnation)
        .with("sequence", header.sequence_number)
        .with("mine", life_);
  }

  Member self_;
  Random random_;
  std::vector<NodeNumber> peers_;
  std::optional<MissionTime> next_;
  std::uint64_t life_ = 0;
  std::uint64_t sent_ = 0;
};

// Tells the state of every link at the start and at each change of one.
class RadioNode final : public Node {
 public:
  RadioNode(const Roster& roster, const std::vector<Cut>& cuts, double loss) : loss_(loss) {
    for (const Member& a : roster.members()) {
      for (const Member& b : roster.members()) {
        if (a.name < b.name) changes_.emplace(MissionTime(), Change{a.number, b.number, true});
      }
    }
    for (const Cut& cut : cuts) {
      const NodeNumber a = roster.find(cut.a)->number;
      const NodeNumber b = roster.find(cut.b)->number;
      changes_.emplace(cut.from, Change{a, b, false});
      changes_.emplace(cut.until, Change{a, b, true});
    }
  }

  Effects handle(const Input&, MissionTime now) override {
    Effects effects;
    for (; !changes_.empty() && changes_.begin()->first <= now; changes_.erase(changes_.begin())) {
      const Change& change = changes_.begin()->second;
      effects.push_back(Publish{bad_link(change.a, change.b, change.up)});
      effects.push_back(Publish{bad_link(change.b, change.a, change.up)});
    }
    return effects;
  }
  std::optional<MissionTime> next_wakeup() const override {
    if (changes_.empty()) return std::nullopt;
    return changes_.begin()->first;
  }

 private:
  struct Change {
    NodeNumber a, b;
    bool up = true;
  };
  wire::LinkState bad_link(NodeNumber from, NodeNumber to, bool up) const {
    wire::LinkState state = link(from, to, up);
    state.latency = Duration::milliseconds(40).count();
    state.loss = loss_;
    return state;
  }
  double loss_;
  std::multimap<MissionTime, Change> changes_;
};

// Finds an event that was handled twice, or out of order, by one life of its receiver. (A later
// life may handle again what the one before did not live to acknowledge.)
class EventLaw {
 public:
  void see(const journal::Record& record) {
    if (record.kind() != "heard" || record.text("slot") != "TaskRequest") return;
    const std::tuple key{record.node(), record.number("mine"), record.number("from"),
                         record.number("their")};
    double& last = last_[key];
    if (record.number("sequence") <= last) violation += to_json(record) + "\n";
    last = record.number("sequence");
  }
  std::string violation;

 private:
  std::map<std::tuple<std::string, double, double, double>, double> last_;
};

std::vector<std::string> names(int uavs) {
  std::vector<std::string> all;
  for (int i = 0; i < uavs; ++i) all.push_back("uav-" + std::to_string(i));
  return all;
}

}  // namespace

PingSystem PingSystem::random(std::uint64_t seed) {
  Random random(seed, "ping system");
  PingSystem system;
  system.seed = seed;
  system.uavs = static_cast<int>(random.below(4));
  system.time_limit = MissionTime::seconds(10);
  std::vector<std::string> nodes = names(system.uavs);
  nodes.emplace_back("ground");
  const auto instant = [&] { return MissionTime::seconds(random.uniform(0, 12)); };
  for (std::uint64_t i = random.below(4); i > 0 && nodes.size() > 1; --i) {
    const std::size_t a = random.below(nodes.size());
    const std::size_t b = (a + 1 + random.below(nodes.size() - 1)) % nodes.size();
    const MissionTime from = instant();
    system.cuts.push_back(
        {nodes[a], nodes[b], from, from + Duration::seconds(random.uniform(0, 5))});
  }
  nodes.emplace_back("sim");
  for (std::uint64_t i = random.below(4); i > 0; --i) {
    Crash crash{instant(), nodes[random.below(nodes.size())], std::nullopt};
    if (random.chance(0.7)) crash.restart = crash.at + Duration::seconds(random.uniform(0, 4));
    crash.remembers = random.chance(0.5);
    system.crashes.push_back(crash);
  }
  system.silent = random.chance(0.5);
  return system;
}

Played PingSystem::play() const {
  const Roster roster(names(uavs));
  VirtualConfig config;
  config.seed = seed;
  config.time_limit = time_limit;
  config.crashes = crashes;
  config.silent_cuts = silent;
  Played played;
  EventLaw law;
  played.outcome = run_virtual(
      roster,
      [&](const std::string& name) -> std::unique_ptr<Node> {
        if (name == "sim") return std::make_unique<RadioNode>(roster, cuts, loss);
        return std::make_unique<PingNode>(roster, *roster.find(name), seed);
      },
      config,
      [&](const journal::Record& record) {
        law.see(record);
        played.log += to_json(record) + "\n";
      });
  played.violation = law.violation;
  return played;
}

}  // namespace skein::node::testing
