// SPDX-License-Identifier: Apache-2.0
// Functions of the host that need no refiner: relations of places, of UAVs, and of times.
#pragma once

#include "planning/host_names.hpp"
#include "skein/foundation/time.hpp"

namespace skein::supervisor {

/// Lifetime: refers to the names.
class HostRelations {
 public:
  HostRelations(HostNames& names, MissionTime origin) : names_(names), origin_(origin) {}

  HostValue target_of(htn::TermStore& store, HostArguments arguments);
  HostValue entry(htn::TermStore& store, HostArguments arguments);
  HostValue is_at(htn::TermStore& store, HostArguments arguments);
  HostValue is_over(htn::TermStore& store, HostArguments arguments);
  HostValue not_reached(htn::TermStore& store, HostArguments arguments);
  HostValue with_me(htn::TermStore& store, HostArguments arguments);
  HostValue in_time(htn::TermStore& store, HostArguments arguments);
  HostValue next_opening(htn::TermStore& store, HostArguments arguments);

  /// The UAVs named in `lists`, and this UAV, in the order of the team.
  std::vector<std::string> who_meet(const htn::TermStore& store, HostArguments lists) const;

 private:
  const Gazetteer& gazetteer() const { return names_.gazetteer(); }
  std::vector<std::string> team(const htn::TermStore& store, HostArguments lists,
                                std::vector<std::string> given) const;

  HostNames& names_;
  MissionTime origin_;
};

}  // namespace skein::supervisor
