// SPDX-License-Identifier: Apache-2.0
// The functions that a planning domain may call, on terms.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "planning/host_relations.hpp"
#include "planning/terms.hpp"
#include "refinery/refinery.hpp"
#include "skein/htn/functions.hpp"
#include "skein/supervisor/planner_host.hpp"

namespace skein::supervisor {

/// The departure that a term states: an interval, or the word `suited` and an interval
/// (Departure::suited). Any other term: any time.
Departure departure(const htn::TermStore& store, htn::Term when);
/// Way and duration in an answer of a refiner; empty, or absent, for other terms.
refiners::Way way_of(const htn::TermStore& store, htn::Term answer);
std::optional<Seconds> duration_of(const htn::TermStore& store, htn::Term answer);

/// Every answer of a refiner is
///   ((destination LOC) (duration LEAST MOST) (energy E) (cost C) (params (NAME VALUE…)…)),
/// with (aim ((target LOC))) before the params if a device is to be aimed at a target; a refusal is
/// nil, and a sentence in refusals(). A wrong argument is an error of the domain, and a failure.
/// Thread rule: one thread at a time, with one store of terms.
class PlannerHost::Services {
 public:
  using Arguments = HostArguments;
  using Value = HostValue;
  using Service = Value (*)(Services&, htn::TermStore&, Arguments);
  struct Entry {
    const char* name;
    std::size_t arguments;
    Service service;
    bool refines;          ///< calls a refiner: its answers are cached and counted
    std::size_t when = 0;  ///< index of the argument with the departure; 0: none
  };
  static std::span<const Entry> table();
  static const Entry& entry_of(Service service);

  Services(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed, refiners::Budget budget);

  /// Where the vehicle is now.
  VehicleStart& start() { return refinery_.air.start(); }

  Value call(const Entry& entry, htn::TermStore& store, Arguments arguments);

  void begin() {
    names_.begin();
    refinements_ = 0;
  }
  const std::vector<std::string>& refusals() const { return names_.refusals(); }
  std::uint64_t refinements() const { return refinements_; }

 private:
  Value refined(const Entry& entry, htn::TermStore& store, Arguments arguments);
  Value takeoff(htn::TermStore& store, Arguments arguments);
  Value land(htn::TermStore& store, Arguments arguments);
  Value gotoxyz(htn::TermStore& store, Arguments arguments);
  Value gotoxyz_among(htn::TermStore& store, Arguments arguments);
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
  Value part(htn::TermStore& store, Arguments arguments);
  Value within_reach(htn::TermStore& store, Arguments arguments);
  Value landing_place(htn::TermStore& store, Arguments arguments);
  Value way_out(htn::TermStore& store, Arguments arguments);
  Value is_free(htn::TermStore& store, Arguments arguments);
  Value stay(htn::TermStore& store, Arguments arguments);
  Value viewpoint(htn::TermStore& store, Arguments arguments);
  Value meeting(htn::TermStore& store, Arguments arguments);
  Value angles(htn::TermStore& store, Arguments arguments);
  Value tour(htn::TermStore& store, Arguments arguments);

  Value way(htn::TermStore& store, Arguments ends, const std::vector<Spot>& others, htn::Term when);
  htn::Term answer(htn::TermStore& store, const Motion& motion, std::vector<htn::Term> params);
  htn::Term flight(htn::TermStore& store, const Answer<Motion>& motion, const std::string& what);
  htn::Term waiting(htn::TermStore& store, const world::Vector3& from, htn::Term when,
                    const Outlook::Venture& venture);
  struct Views {
    htn::Term device;
    std::vector<world::Vector3> points;
  };
  std::optional<Views> views(htn::TermStore& store, htn::Term place, htn::Term devices,
                             std::size_t count, htn::Term when, htn::Term seconds);

  const Gazetteer& gazetteer() const { return names_.gazetteer(); }
  /// Wraps a member function of Services or of HostRelations as a plain function.
  template <auto kMember>
  static Value ask(Services& services, htn::TermStore& store, Arguments arguments) {
    if constexpr (std::is_same_v<decltype(kMember),
                                 Value (HostRelations::*)(htn::TermStore&, Arguments)>) {
      return (services.relations_.*kMember)(store, arguments);
    } else {
      return (services.*kMember)(store, arguments);
    }
  }

  Refinery refinery_;
  HostNames names_;
  HostRelations relations_;
  /// A cached answer of a refiner, with the refusals that it recorded.
  struct Known {
    htn::Term value;
    std::vector<std::string> said;
  };
  std::unordered_map<htn::Term, Known> known_;  ///< by (name argument…)
  std::uint64_t refinements_ = 0;
};

}  // namespace skein::supervisor
