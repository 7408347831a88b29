// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/partition.hpp"

#include "common/shared_checks.hpp"
#include "partition/checks.hpp"
#include "partition/planner.hpp"

namespace skein::refiners {
namespace {

using partition::Ability;
using partition::Planner;
using partition::Trial;

/// Divisions tried for one that everybody has the energy for.
constexpr int kEnergyRounds = 12;

Refusal too_much_area(const std::vector<Ability>& abilities, double whole) {
  double limits = 0;
  for (const Ability& ability : abilities) limits += ability.limit;
  return {RefusalKind::kBeyondVehicle, "members",
          "with the energy that they hold when full, less their reserves, all members together "
          "sweep less than the area: some " +
              rounded(limits) + " of " + rounded(whole) + " m2"};
}

Refusal too_much_asked(const PartitionQuery& query, const Trial& trial) {
  const auto excess = [&](std::size_t i) {
    return trial.sweeps[i].task.energy / partition::usable(query.members[i]);
  };
  std::size_t worst = 0;
  for (std::size_t i = 0; i < trial.sweeps.size(); ++i)
    if (excess(i) > excess(worst)) worst = i;
  return {RefusalKind::kBeyondVehicle, "members." + std::to_string(worst) + ".share",
          query.members[worst].uav + " would need " +
              rounded(100 * trial.sweeps[worst].task.energy) + " % of the energy held when full; " +
              rounded(100 * partition::usable(query.members[worst])) + " % may be used"};
}

std::vector<double> areas_asked_for(const Planner& planner) {
  double total = 0;
  for (const Member& member : planner.query().members) total += *member.share;
  std::vector<double> areas;
  for (const Member& member : planner.query().members)
    areas.push_back(*member.share / total * planner.whole());
  return areas;
}

Result<Trial, Refusal> as_asked(Planner& planner) {
  const auto areas = areas_asked_for(planner);
  auto trial = planner.plan(areas);
  if (trial && !planner.has_energy(*trial))
    return tl::unexpected<Refusal>(too_much_asked(planner.query(), *trial));
  return trial;
}

Result<Trial, Refusal> in_proportion(Planner& planner) {
  std::vector<Ability> abilities = planner.abilities();
  for (int round = 0; round < kEnergyRounds && !planner.finished(); ++round) {
    const auto areas = fair_areas(abilities, planner.whole());
    if (!areas) break;
    auto trial = planner.plan(*areas);
    if (!trial || planner.has_energy(*trial)) return trial;
    planner.learn_limits(*trial, abilities);
  }
  if (planner.out_of_budget())
    return refuse(RefusalKind::kBudgetExhausted, "members",
                  "no division was found that everybody has the energy for");
  return tl::unexpected<Refusal>(too_much_area(abilities, planner.whole()));
}

/// Where no balance is found, what stands in the way of proportion does too, or proportion is the
/// best there is.
Result<Trial, Refusal> in_balance(Planner& planner) {
  std::optional<Refusal> refusal;
  if (auto trial = balance(planner, refusal)) return *trial;
  if (refusal) return tl::unexpected<Refusal>(*refusal);
  return in_proportion(planner);
}

Refined<Partition> answer(const Planner& planner, Trial trial) {
  Refined<Partition> refined;
  for (std::size_t i = 0; i < trial.sweeps.size(); ++i) {
    Refined<Coverage>& sweep = trial.sweeps[i];
    if (sweep.duration.expected >= refined.duration.expected) refined.duration = sweep.duration;
    refined.task.parts.push_back({planner.query().members[i].uav,
                                  std::move(trial.division.parts[i]),
                                  trial.areas[i] / planner.whole(), trial.division.anchors[i],
                                  trial.altitudes[i], std::move(sweep.task), sweep.duration});
  }
  refined.task.spread = trial.spread;
  refined.cost = trial.latest;
  refined.effort = planner.effort();
  return refined;
}

}  // namespace

Outcome<Partition> refine(const PartitionQuery& query, const Setting& setting) {
  if (auto problem = check_partition(query, setting.world))
    return tl::unexpected<Refusal>(*problem);
  Planner planner(query, setting);
  const bool given = query.members[0].share.has_value();
  auto trial = given                                ? as_asked(planner)
               : query.mode == ShareMode::kBalanced ? in_balance(planner)
                                                    : in_proportion(planner);
  if (!trial) return tl::unexpected<Refusal>(trial.error());
  const auto apart = keep_apart(planner, *trial);
  if (!apart) return tl::unexpected<Refusal>(apart.error());
  Refined<Partition> refined = answer(planner, std::move(*trial));
  refined.task.apart = *apart;
  refined.effort.cut_short = refined.effort.cut_short || !*apart;
  return refined;
}

}  // namespace skein::refiners
