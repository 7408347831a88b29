// SPDX-License-Identifier: Apache-2.0
// Scenarios of the experiment: a random order of the arcs, each fixed once.
#include <algorithm>
#include <optional>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/random.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"
#include "skein/temporal_lab/reference_solution.hpp"

namespace skein::temporal {

namespace {

constexpr std::uint64_t kFarthest = 10;  // [s] outside its interval an arc is relaxed to

// Uniform among the whole seconds that `min` and whole steps from it reach up to `max`.
Ticks draw_between(Random& random, Ticks min, Ticks max) {
  const auto steps = static_cast<std::uint64_t>((max - min) / kTicksPerSecond);
  return min + static_cast<Ticks>(random.below(steps + 1)) * kTicksPerSecond;
}

/// The network as the steps so far have left it.
class Script {
 public:
  Script(const Mastn& mastn, const ScenarioOptions& options, std::uint64_t seed)
      : nodes_(mastn.nodes.size()),
        arcs_(mastn.arcs),
        options_(options),
        random_(seed, "mastn/scenario") {}

  std::vector<Step> run(std::vector<std::uint32_t> order) {
    for (std::size_t left = order.size(); left > 1; --left) {
      std::swap(order[left - 1], order[random_.below(left)]);
    }
    std::vector<Step> steps;
    for (const std::uint32_t index : order) {
      Arc& arc = arcs_[index];
      const Ticks value = random_.chance(options_.relaxations) ? relaxed(index) : contracted(index);
      arc.min = arc.max = value;
      const auto number = static_cast<Ticks>(steps.size() + 1);
      steps.push_back({number * options_.interval, index, value, value});
    }
    return steps;
  }

 private:
  Ticks contracted(std::uint32_t index) {
    const Arc& arc = arcs_[index];
    const std::optional<ReferenceWindow> allowed = allowed_by(arcs_, arc);
    return allowed ? draw_between(random_, allowed->min, allowed->max)
                   : draw_between(random_, arc.min, arc.max);
  }

  Ticks relaxed(std::uint32_t index) {
    const Arc& arc = arcs_[index];
    std::vector<Ticks> outside;
    for (std::uint64_t by = 1; by <= kFarthest; ++by) {
      const Ticks distance = static_cast<Ticks>(by) * kTicksPerSecond;
      outside.push_back(arc.min - distance);
      outside.push_back(arc.max + distance);
    }
    if (options_.mode == ScenarioMode::kKept) keep_allowed(outside, index);
    return outside[random_.below(outside.size())];
  }

  // Leaves the values that the other constraints allow, if there are any.
  void keep_allowed(std::vector<Ticks>& values, std::uint32_t index) const {
    std::vector<Arc> others = arcs_;
    others[index].min = kMinusInfinite;
    others[index].max = kInfinite;
    const std::optional<ReferenceWindow> allowed = allowed_by(others, arcs_[index]);
    if (!allowed) return;
    std::vector<Ticks> kept;
    std::copy_if(values.begin(), values.end(), std::back_inserter(kept),
                 [&](Ticks value) { return allowed->min <= value && value <= allowed->max; });
    if (!kept.empty()) values = std::move(kept);
  }

  // What the arcs together allow between the ends of one; nothing if they are inconsistent.
  std::optional<ReferenceWindow> allowed_by(const std::vector<Arc>& arcs, const Arc& arc) const {
    if (!solve_reference(nodes_, arcs).consistent) return std::nullopt;
    return implied_interval(nodes_, arcs, arc.from, arc.to);
  }

  std::size_t nodes_;
  std::vector<Arc> arcs_;
  ScenarioOptions options_;
  Random random_;
};

}  // namespace

std::vector<Step> make_scenario(const Mastn& mastn, const std::vector<std::uint32_t>& arcs,
                                const ScenarioOptions& options, std::uint64_t seed) {
  for (const std::uint32_t arc : arcs) {
    SKEIN_EXPECTS(arc < mastn.arcs.size());
    SKEIN_EXPECTS(mastn.arcs[arc].min != kMinusInfinite && mastn.arcs[arc].max != kInfinite);
  }
  return Script(mastn, options, seed).run(arcs);
}

}  // namespace skein::temporal
