// SPDX-License-Identifier: Apache-2.0
// Places from which all of a patrol's ground is perceived, and which can be flown to from which.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "patrol/field.hpp"

namespace skein::refiners {

/// A closed walk: places, each linked to the next and the last to the first.
using Walk = std::vector<std::uint32_t>;

/// Places about as far apart as the footprint is wide. A vehicle that passes one, on the way from
/// any of its links to any, perceives all its cells; every cell of the field is of one place.
struct WalkGraph {
  struct Link {
    std::uint32_t to;
    double length;  ///< straight [m]
  };
  struct Place {
    world::Vector2 at = world::Vector2::Zero();
    double risk = 0;                     ///< of all its cells
    double top = 0;                      ///< of the most risky
    std::vector<Link> links;             ///< at most four; there and back
    std::vector<world::Vector2> passes;  ///< from link i to link j: at i × links + j. Turns are
                                         ///< pushed outwards as far as the outermost cells need
    std::vector<double> detours;         ///< likewise: what that adds to half of each link [m]
  };

  std::vector<Place> places;
  double total_risk = 0;

  /// Which of the links of a place leads to another; at most its number of links: none.
  std::size_t link_to(std::uint32_t place, std::uint32_t other) const {
    const std::vector<Link>& links = places[place].links;
    std::size_t i = 0;
    while (i < links.size() && links[i].to != other) ++i;
    return i;
  }
  bool are_linked(std::uint32_t place, std::uint32_t other) const {
    return link_to(place, other) < places[place].links.size();
  }
  /// Precondition: they are linked.
  double length(std::uint32_t from, std::uint32_t to) const {
    return places[from].links[link_to(from, to)].length;
  }
  /// Of passing a place on the way between two that it is linked to [m].
  double detour(std::uint32_t before, std::uint32_t place, std::uint32_t after) const {
    return places[place].detours[pass(before, place, after)];
  }
  const world::Vector2& passed_at(std::uint32_t before, std::uint32_t place,
                                  std::uint32_t after) const {
    return places[place].passes[pass(before, place, after)];
  }

 private:
  std::size_t pass(std::uint32_t before, std::uint32_t place, std::uint32_t after) const {
    return link_to(place, before) * places[place].links.size() + link_to(place, after);
  }
};

/// Places on a lattice. Nothing where some cells are perceived from no such place, as along slanted
/// borders and beside what is closed; where not all places can be reached; or when the deadline of
/// the sight has passed. For a vehicle that hovers: turns are sharp.
std::optional<WalkGraph> make_walk_graph(const PatrolField& field, const PatrolSpace& space,
                                         const PatrolSight& sight);

/// What the mean idleness by risk of no walk is below, by length [m]: (Σ √(R c))² / 2 Σ R, where R
/// is the risk of a place and c the least that passing it takes. Proof: docs/decisions/0027.
double least_mean_of_walks(const WalkGraph& graph);

/// What the greatest risk × idleness of no walk is below, by length [m]: Σ t c, where t is the risk
/// of a place's most risky cell. Proof: docs/decisions/0027.
double least_worst_of_walks(const WalkGraph& graph);

/// What the mean idleness by risk of no walk is below whose greatest risk × idleness is `worst` [m]
/// at most; infinite below least_worst_of_walks. Source: docs/decisions/0027.
double least_mean_of_walks(const WalkGraph& graph, double worst);

/// Lanes in turn, and shortest ways where one does not lead to the next. Visits every place.
Walk walk_in_turn(const WalkGraph& graph);

/// Adds the places strictly between two to a walk, of one of the shortest ways (fewest links).
/// False: there is none.
bool append_shortest(const WalkGraph& graph, std::uint32_t from, std::uint32_t to, Walk& walk);

/// What is flown: one point for each visit.
std::vector<world::Vector2> track_of(const WalkGraph& graph, const Walk& walk);

}  // namespace skein::refiners
