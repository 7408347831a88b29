// SPDX-License-Identifier: Apache-2.0
// Plans the sweeps of one division, and learns from them what the members can do.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "partition/divide.hpp"
#include "partition/shares.hpp"
#include "skein/refiners/partition.hpp"

namespace skein::refiners::partition {

/// One division, with all that is planned in it.
struct Trial {
  std::vector<double> areas;  ///< [m²]
  Division division;
  std::vector<Refined<Coverage>> sweeps;
  double latest = 0;              ///< expected finish [s]
  double spread = 0;              ///< as in Partition
  std::vector<double> altitudes;  ///< of the sweeps over the ground [m]
  bool flown = false;             ///< sweeps take what is flown, else what coverage has
};

/// Latest finish of a trial, and how far before it the first one is.
void judge(Trial& trial);

class Planner {
 public:
  /// Both must outlive it. Precondition: check_partition passes.
  Planner(const PartitionQuery& query, const Setting& setting);

  /// What the members could do at best: sweeping at full speed from the first second, no turns.
  std::vector<Ability> abilities() const;
  /// As divisions(), anchored at the starts: none where the time is up.
  std::vector<Division> divide(const std::vector<double>& areas, std::size_t most,
                               double between = 0.5) const;
  /// One step for each member; of the first way to divide, if none is given.
  Result<Trial, Refusal> plan(const std::vector<double>& areas);
  Result<Trial, Refusal> plan(const std::vector<double>& areas, Division division);

  /// That of one member at another altitude; nothing has changed when it is refused.
  Result<void, Refusal> fly_at(Trial& trial, std::size_t member, double altitude);

  bool has_energy(const Trial& trial) const;
  /// Lowers the limits of those that lack the energy for their part.
  void learn_limits(const Trial& trial, std::vector<Ability>& abilities) const;
  /// What each really sweeps in a second, and when it begins.
  void learn_rates(const Trial& trial, std::vector<Ability>& abilities) const;
  /// The same of one member.
  void learn_rate(const Trial& trial, std::size_t member, Ability& ability) const;

  /// Sweeps can be reckoned as they are flown.
  bool flies() const { return query_.flown && !effort_.cut_short; }
  /// The sweep of one member takes what the query has flown; false: that is not known.
  bool fly(Trial& trial, std::size_t member) const;

  /// True once the budget is used up, but not before anything is planned.
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

/// Raises sweeps until all are as far apart as the query asks for, or says why they cannot be;
/// false when the time was up before.
Result<bool, Refusal> keep_apart(Planner& planner, Trial& trial);

/// The division, of those tried, that all finish soonest and most nearly together; nothing when
/// none was found that everybody has the energy for, or when the first that is tried is refused
/// (then `refusal` says why).
std::optional<Trial> balance(Planner& planner, std::optional<Refusal>& refusal);

}  // namespace skein::refiners::partition
