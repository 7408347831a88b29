// SPDX-License-Identifier: Apache-2.0
// Blackboards that hear samples whose headers lie, beside those that do not: of other nodes and
// lives, replayed, from the end of time, past relays that there are not; acknowledgements of what
// was never said; parts of nothing. No blackboard ends by that, and none is at it for ever. What
// becomes of what is said meanwhile is not asked.
#include <gtest/gtest.h>

#include <deque>
#include <iostream>
#include <ostream>
#include <string>
#include <utility>

#include "test_cases.hpp"
#include "testing/foul.hpp"
#include "testing/radio_net.hpp"
#include "testing/random_sample.hpp"

namespace skein::blackboard::testing {
namespace {

constexpr int kNodes = 4;

/// Garbles some of what arrives, says some twice and some again much later.
class FoulAir {
 public:
  explicit FoulAir(std::uint64_t seed)
      : random_(seed, "foul-air"),
        fouler_(seed, Fouler::Changes::kAll),
        foul_(random_.uniform(0.01, 0.3)) {}

  void operator()(std::vector<Arrival>& arrivals) {
    std::vector<Arrival> heard;
    for (Arrival& fair : arrivals) {
      kept_.push_back(fair);
      if (kept_.size() > kKept) kept_.pop_front();
      if (!random_.chance(foul_)) {
        heard.push_back(std::move(fair));
        continue;
      }
      heard.push_back(misheard(fair.channel));
      if (random_.chance(0.5)) heard.push_back(std::move(fair));
    }
    arrivals = std::move(heard);
  }

 private:
  static constexpr std::size_t kKept = 100;

  Arrival misheard(std::size_t channel) {
    Arrival foul = random_.chance(0.7) ? kept_.back() : kept_[random_.below(kept_.size())];
    foul.channel = channel;
    if (auto* sample = std::get_if<wire::Sample>(&foul.content)) {
      if (random_.chance(0.8)) *sample = fouler_.foul(*sample);
      if (random_.chance(0.1))
        foul.content = Malformed{wire::slot_of(*sample), wire::header_of(*sample), {"x", "y"}};
    }
    return foul;
  }

  Random random_;
  Fouler fouler_;
  double foul_;
  std::deque<Arrival> kept_;
};

struct Case {
  std::string name;
  std::set<int> relays;
  double capacity = 0;  ///< [bit/s]
};
void PrintTo(const Case& what, std::ostream* out) { *out << what.name; }

class FoulHeaders : public ::testing::TestWithParam<Case> {
 protected:
  static std::size_t written_in_a_minute(std::uint64_t seed) {
    RadioNet::Setup setup;
    setup.nodes = kNodes;
    setup.relays = GetParam().relays;
    setup.capacity = GetParam().capacity;
    setup.latency = Duration::milliseconds(20);
    setup.seed = seed;
    setup.garble = FoulAir(seed);
    RadioNet net(std::move(setup));
    Random random(seed);
    for (int turn = 0; turn < 120; ++turn) {
      for (int i = 0; i < 4; ++i) say_anything(net, random);
      if (random.chance(0.05)) net.start(node(random));
      if (random.chance(0.2)) net.set_both(node(random), node(random), random.chance(0.6));
      net.run_for(Duration::milliseconds(500));
    }
    return net.written();
  }

 private:
  static int node(Random& random) { return 1 + static_cast<int>(random.below(kNodes)); }

  static void say_anything(RadioNet& net, Random& random) {
    const int from = node(random), to = node(random);
    if (from == to) return;
    if (random.chance(0.05)) {
      wire::PlanBoard longer;
      longer.tasks.resize(200);
      return net.say(from, to, std::move(longer));
    }
    const std::uint64_t slot = random.below(wire::kSlotCount);
    std::uint64_t at = 0;
    for_each_slot_type([&]<class T>() {
      if (at++ == slot) net.say(from, to, random_value<T>(random));
    });
  }
};

TEST_P(FoulHeaders, EndNoBlackboardWhateverTheySay) {
  const char* first = std::getenv("SKEIN_FIRST_SEED");
  const std::uint64_t from = first != nullptr ? std::stoull(first) : 1;
  const auto seeds = skein::testing::cases<std::uint64_t>(20, 1000);
  for (std::uint64_t seed = from; seed < from + seeds; ++seed) {
    std::cout << GetParam().name << " seed " << seed << std::endl;  // the last one, if it ends
    EXPECT_GT(written_in_a_minute(seed), 1000U);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, FoulHeaders,
                         ::testing::Values(Case{"direct", {}}, Case{"narrow", {}, 9600},
                                           Case{"relayed", {2, 3}},
                                           Case{"narrow_and_relayed", {2, 3}, 9600}),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace skein::blackboard::testing
