// SPDX-License-Identifier: Apache-2.0
// Blackboards of many nodes over radio in virtual time; nobody tells them which links are there.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/memory_transport.hpp"
#include "skein/foundation/random.hpp"

namespace skein::blackboard::testing {

/// Nodes 1 to n, all of which have channels to each other, as UAVs have. Links are cut and healed
/// below the blackboards, as a real radio does it: at the receiving side, without a word.
class RadioNet {
 public:
  struct Setup {
    int nodes = 2;
    std::set<int> relays;
    Duration period = Duration::milliseconds(250);
    double loss = 0;  ///< share of streams and heartbeats that vanish, on every link
    Duration latency{};
    double capacity = 0;  ///< [bit/s] of every link in each direction; 0: unlimited
    std::size_t most_relays = 8;
    std::uint64_t seed = 1;
    /// Changes what has arrived somewhere before the blackboard there sees it; may be empty.
    std::function<void(std::vector<Arrival>&)> garble = {};
  };
  explicit RadioNet(Setup setup);
  ~RadioNet();

  void start(int node);  ///< or restarts it, in a new incarnation
  void kill(int node);
  bool lives(int node) const;
  void set_link(int from, int to, bool up);  ///< in one direction
  void set_both(int a, int b, bool up);
  bool is_up(int from, int to) const { return !cut_.contains({from, to}); }

  /// Gives the number of the event.
  std::uint64_t send_event(int from, int to);
  void set_state(int from, int to, std::uint64_t value);
  void send_stream(int from, int to, double value);
  /// Any sample, which may be refused.
  void say(int from, int to, wire::Sample sample);

  void run_for(Duration time);
  /// Whether it holds within the time.
  bool run_until(const std::function<bool()>& holds, Duration at_most);
  Duration now() const { return now_; }

  bool reachable(int from, int to) const;
  /// Numbers of the events that `at` has handled, of those that `from` sent, in that order.
  const std::vector<std::uint64_t>& handled(int at, int from) { return handled_[{at, from}]; }
  std::uint64_t state(int at, int of) { return states_[{at, of}]; }
  const std::vector<double>& streams(int at, int from) { return streams_[{at, from}]; }
  const std::vector<RouteChanged>& routes(int at) { return routes_[at]; }
  /// What went wrong on the way: a sample that came past a node twice, or past too many.
  const std::vector<std::string>& breaches() const { return breaches_; }
  /// How often an event was written, by channel (from, to), origin, destination and sequence.
  using Crossing = std::tuple<int, int, std::uint32_t, std::uint32_t, std::uint64_t>;
  const std::map<Crossing, int>& crossings() const { return crossings_; }
  std::size_t written() const { return written_; }  ///< samples in all

 private:
  class Radio;
  struct Running {
    std::unique_ptr<Radio> radio;
    std::unique_ptr<Blackboard> blackboard;
  };
  void note(int node, const Incoming& incoming);
  void note_written(int from, int to, const wire::Sample& sample);
  void step_all();
  Now at() const { return {MissionTime() + now_, now_}; }

  Setup setup_;
  MemoryHub hub_;
  Random random_;
  Duration now_;
  std::map<int, Running> nodes_;
  std::map<int, std::uint64_t> incarnations_;
  std::set<std::pair<int, int>> cut_;
  std::uint64_t sent_ = 0;
  std::map<std::pair<int, int>, std::vector<std::uint64_t>> handled_;
  std::map<std::pair<int, int>, std::uint64_t> states_;
  std::map<std::pair<int, int>, std::vector<double>> streams_;
  std::map<int, std::vector<RouteChanged>> routes_;
  std::vector<std::string> breaches_;
  std::map<Crossing, int> crossings_;
  std::size_t written_ = 0;
};

}  // namespace skein::blackboard::testing
