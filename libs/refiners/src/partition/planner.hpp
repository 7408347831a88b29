// SPDX-License-Identifier: Apache-2.0
// Plans the sweeps of a division, and estimates the members' abilities from them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "partition/divide.hpp"
#include "partition/shares.hpp"
#include "skein/refiners/partition.hpp"

namespace skein::refiners::partition {

/// One division with its planned sweeps.
struct Trial {
  std::vector<double> areas;  ///< [m²]
  Division division;
  std::vector<Refined<Coverage>> sweeps;
  double latest = 0;              ///< expected finish [s]
  double spread = 0;              ///< as in Partition
  std::vector<double> altitudes;  ///< of the sweeps over the ground [m]
  bool flown = false;             ///< durations are those of real flight, else of coverage
};

/// Computes `latest` and `spread` of a trial.
void judge(Trial& trial);

class Planner {
 public:
  /// Both must outlive it. Precondition: check_partition passes.
  Planner(const PartitionQuery& query, const Setting& setting);

  /// Ideal abilities of the members: sweeping at full speed from the first second, without turns.
  std::vector<Ability> abilities() const;
  /// Like divisions(), anchored at the members' starts; none if the time is up.
  std::vector<Division> divide(const std::vector<double>& areas, std::size_t most,
                               double between = 0.5) const;
  /// One step for each member; of the first way to divide, if none is given.
  Result<Trial, Refusal> plan(const std::vector<double>& areas);
  Result<Trial, Refusal> plan(const std::vector<double>& areas, Division division);

  /// Replans the sweep of one member at another altitude; on refusal nothing has changed.
  Result<void, Refusal> fly_at(Trial& trial, std::size_t member, double altitude);

  bool has_energy(const Trial& trial) const;
  /// Lowers the limits of members that lack the energy for their part.
  void learn_limits(const Trial& trial, std::vector<Ability>& abilities) const;
  /// Sets each member's real sweep rate, and the time at which it begins.
  void learn_rates(const Trial& trial, std::vector<Ability>& abilities) const;
  /// The same of one member.
  void learn_rate(const Trial& trial, std::size_t member, Ability& ability) const;

  /// Whether durations of real flight are available.
  bool flies() const { return query_.flown && !effort_.cut_short; }
  /// Sets the duration of one member's sweep to that of real flight; false: unknown.
  bool fly(Trial& trial, std::size_t member) const;

  /// Whether the budget is used up and at least one sweep is planned.
  bool finished();
  bool out_of_budget() const;
  const Effort& effort() const { return effort_; }
  double whole() const { return whole_; }
  const PartitionQuery& query() const { return query_; }
  const Setting& setting() const { return setting_; }

 private:
  Outcome<Coverage> sweep(const Member& member, double altitude, const world::Polygon& part);
  double seconds_to(const Member& member, const Refined<Coverage>& sweep) const;

  const PartitionQuery& query_;
  const Setting& setting_;
  double whole_;
  Effort effort_;
  std::uint64_t late_ = 0;  ///< sweeps since the time is up
  std::uint64_t steps_;     ///< allowed
};

/// Fraction of the energy held when full that may be used.
double usable(const Member& member);

/// Raises sweeps until all are separated by PartitionQuery::apart; refused if impossible, false if
/// the time was up before.
Result<bool, Refusal> keep_apart(Planner& planner, Trial& trial);

/// The division tried with the earliest and most balanced finish; nothing if none is within the
/// energy of all members, or if the first one tried is refused (`refusal` then has the reason).
std::optional<Trial> balance(Planner& planner, std::optional<Refusal>& refusal);

}  // namespace skein::refiners::partition
