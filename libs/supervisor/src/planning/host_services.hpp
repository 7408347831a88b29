// SPDX-License-Identifier: Apache-2.0
// The functions that a planning domain may call, on terms.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "planning/terms.hpp"
#include "refinery/refinery.hpp"
#include "skein/htn/functions.hpp"
#include "skein/supervisor/planner_host.hpp"

namespace skein::supervisor {

/// Within which a vehicle counts as being at a place [m]: what it wavers and, when it cannot hover,
/// its circle.
double vicinity(const Gazetteer& gazetteer);

/// Every answer of a refiner is
///   ((destination LOC) (duration LEAST MOST) (energy E) (cost C) (params (NAME VALUE…)…)),
/// with (aim ((target LOC))) before the params where a device is to be aimed at something; a
/// refusal is nil and a sentence in refusals(). A wrong argument is a failure: an error of the
/// domain. Thread rule: one thread at a time, with one store of terms.
class PlannerHost::Services {
 public:
  using Arguments = std::span<const htn::Term>;
  using Value = Result<htn::Term, Failure>;
  using Service = Value (Services::*)(htn::TermStore&, Arguments);
  struct Entry {
    const char* name;
    std::size_t arguments;
    Service service;
    bool refines;          ///< remembered, counted
    std::size_t when = 0;  ///< which argument says when, if any
  };
  static std::span<const Entry> table();
  static const Entry& entry_of(Service service);

  Services(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed, refiners::Budget budget);

  Value call(const Entry& entry, htn::TermStore& store, Arguments arguments);

  const std::vector<std::string>& refusals() const { return refusals_; }
  std::uint64_t refinements() const { return refinements_; }

 private:
  Value takeoff(htn::TermStore& store, Arguments arguments);
  Value land(htn::TermStore& store, Arguments arguments);
  Value gotoxyz(htn::TermStore& store, Arguments arguments);
  Value wait(htn::TermStore& store, Arguments arguments);
  Value wait_for_patrol(htn::TermStore& store, Arguments arguments);
  Value wait_for_sweep(htn::TermStore& store, Arguments arguments);
  Value wait_for_rest(htn::TermStore& store, Arguments arguments);
  Value is_open(htn::TermStore& store, Arguments arguments);
  Value stays_open(htn::TermStore& store, Arguments arguments);
  Value patrol(htn::TermStore& store, Arguments arguments);
  Value sweep(htn::TermStore& store, Arguments arguments);
  Value sweep_entry(htn::TermStore& store, Arguments arguments);
  Value rest(htn::TermStore& store, Arguments arguments);
  Value not_reached(htn::TermStore& store, Arguments arguments);
  Value within_reach(htn::TermStore& store, Arguments arguments);
  Value landing_place(htn::TermStore& store, Arguments arguments);
  Value way_out(htn::TermStore& store, Arguments arguments);
  Value is_free(htn::TermStore& store, Arguments arguments);
  Value stay(htn::TermStore& store, Arguments arguments);
  Value viewpoint(htn::TermStore& store, Arguments arguments);
  Value angles(htn::TermStore& store, Arguments arguments);
  Value entry(htn::TermStore& store, Arguments arguments);
  Value tour(htn::TermStore& store, Arguments arguments);
  Value target_of(htn::TermStore& store, Arguments arguments);
  Value is_at(htn::TermStore& store, Arguments arguments);
  Value is_over(htn::TermStore& store, Arguments arguments);
  Value rank_in(htn::TermStore& store, Arguments arguments);
  Value count_of(htn::TermStore& store, Arguments arguments);
  Value with_me(htn::TermStore& store, Arguments arguments);
  Value in_time(htn::TermStore& store, Arguments arguments);

  /// nil, and the sentence is kept.
  htn::Term refuse(const std::string& why);
  htn::Term answer(htn::TermStore& store, const Motion& motion, std::vector<htn::Term> params);
  htn::Term flight(htn::TermStore& store, const Answer<Motion>& motion, const std::string& what);
  static Departure departure(const htn::TermStore& store, htn::Term when);
  /// Of an answer; empty, or nothing, of what is none.
  static refiners::Way way_of(const htn::TermStore& store, htn::Term answer);
  static std::optional<Seconds> duration_of(const htn::TermStore& store, htn::Term answer);
  htn::Term waiting(htn::TermStore& store, const world::Vector3& from, htn::Term when,
                    const Outlook::Venture& venture);
  std::optional<world::Vector3> place(const htn::TermStore& store, htn::Term term);
  std::vector<std::string> team(const htn::TermStore& store, Arguments lists) const;
  struct Views {
    htn::Term device;
    std::vector<world::Vector3> points;
  };
  std::optional<Views> views(htn::TermStore& store, htn::Term place, htn::Term devices,
                             std::size_t count, htn::Term when, htn::Term seconds);

  Gazetteer gazetteer_;
  Refinery refinery_;
  MissionTime origin_;
  std::map<std::string, htn::Term> known_;
  std::vector<std::string> refusals_;
  std::uint64_t refinements_ = 0;
};

}  // namespace skein::supervisor
