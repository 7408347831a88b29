// SPDX-License-Identifier: Apache-2.0
// Whole missions whose nodes hear foul words beside fair ones: whatever well-formed samples say,
// no node ends, and none is at it for ever. What becomes of the mission is not asked.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <ostream>
#include <string>
#include <utility>

#include "skein/assembly/assembly.hpp"
#include "test_cases.hpp"
#include "testing/foul.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

using blackboard::testing::Fouler;

/// A node whose radio garbles some words, says some twice and some again much later.
class HardOfHearing final : public node::Node {
 public:
  HardOfHearing(std::unique_ptr<node::Node> node, std::uint64_t seed, double foul)
      : node_(std::move(node)), random_(seed), fouler_(seed), foul_(foul) {}

  node::Effects handle(const node::Input& input, MissionTime now) override {
    const auto* received = std::get_if<node::Received>(&input);
    if (received == nullptr) return node_->handle(input, now);
    heard_.push_back(*received);
    if (heard_.size() > kRemembered) heard_.pop_front();
    if (!random_.chance(foul_)) return node_->handle(input, now);
    node::Effects effects = node_->handle(misheard(), now);
    if (random_.chance(0.5)) return effects;  // the fair word is lost
    for (node::Effect& more : node_->handle(input, now)) effects.push_back(std::move(more));
    return effects;
  }
  std::optional<MissionTime> next_wakeup() const override { return node_->next_wakeup(); }
  void begin_recall() override { node_->begin_recall(); }
  node::Effects end_recall() override { return node_->end_recall(); }

 private:
  static constexpr std::size_t kRemembered = 60;

  /// The last word or an earlier one, garbled.
  node::Received misheard() {
    const bool last = random_.chance(0.7);
    const node::Received& word = last ? heard_.back() : heard_[random_.below(heard_.size())];
    return {word.from, fouler_.foul(word.sample)};
  }

  std::unique_ptr<node::Node> node_;
  Random random_;
  Fouler fouler_;
  double foul_;
  std::deque<node::Received> heard_;
};

struct Case {
  std::string scenario;
  double duration;          ///< [s]
  std::uint64_t first = 1;  ///< seed; where one ended a node once, that one
};
void PrintTo(const Case& what, std::ostream* out) { *out << what.scenario; }

TEST(Fouler, ChangesManySamplesAndMakesNoneMalformed) {
  wire::MergeMessage fair;
  fair.number = 7;
  fair.held.resize(2);
  fair.waits_for = {"heliv"};
  Fouler fouler(1);
  int changed = 0;
  for (int i = 0; i < 200; ++i) {
    const wire::Sample foul = fouler.foul(fair);
    if (!(foul == wire::Sample(fair))) ++changed;
    EXPECT_FALSE(wire::find_violation(foul));
  }
  EXPECT_GT(changed, 100);
}

class FoulWords : public ::testing::TestWithParam<Case> {
 protected:
  enum class Hears { kAllButTheSimulator, kTheSimulator };

  /// A broken contract ends this program: the last seed that was said is the one.
  static void play_each(Hears who) {
    const char* first = std::getenv("SKEIN_FIRST_SEED");
    const std::uint64_t from = first != nullptr ? std::stoull(first) : GetParam().first;
    const auto seeds = cases<std::uint64_t>(3, 200);
    for (std::uint64_t seed = from; seed < from + seeds; ++seed) {
      std::cout << GetParam().scenario << " seed " << seed << std::endl;
      EXPECT_GT(steps_of(seed, who), 100U);
    }
  }

 private:
  static std::uint64_t steps_of(std::uint64_t seed, Hears who) {
    const scenario::Scenario scenario = scenario_at(GetParam().scenario, with(seed));
    const assembly::NodeMaker make(scenario);
    node::VirtualConfig config = assembly::virtual_config(scenario);
    config.time_limit = MissionTime::seconds(GetParam().duration);
    Random random(seed);
    const double foul = random.uniform(0.005, 0.2);
    const auto hard_of_hearing = [&](const std::string& name) -> std::unique_ptr<node::Node> {
      if ((name == "sim") != (who == Hears::kTheSimulator)) return make(name);
      return std::make_unique<HardOfHearing>(make(name), random.bits(), foul);
    };
    return node::run_virtual(make.roster(), hard_of_hearing, config, [](const auto&) {}).steps;
  }
};

TEST_P(FoulWords, EndNoNodeWhateverTheySay) { play_each(Hears::kAllButTheSimulator); }

TEST_P(FoulWords, EndNoSimulatorThatHearsThem) { play_each(Hears::kTheSimulator); }

INSTANTIATE_TEST_SUITE_P(Of, FoulWords,
                         ::testing::Values(Case{"comets/confirmed", 900}, Case{"team/two", 600},
                                           Case{"team/five", 900, 42}, Case{"team/crossing", 900},
                                           Case{"mref/nominal", 900},
                                           Case{"area-sharing/negotiated", 900},
                                           Case{"action/patrol", 900}, Case{"relaying/chain", 900}),
                         [](const auto& of) {
                           std::string name = of.param.scenario;
                           for (char& one : name)
                             if (std::isalnum(static_cast<unsigned char>(one)) == 0) one = '_';
                           return name;
                         });

}  // namespace
}  // namespace skein::testing
