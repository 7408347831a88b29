// SPDX-License-Identifier: Apache-2.0
// Graph of places from which all cells of a patrol are perceived, linked by flyable legs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "patrol/field.hpp"

namespace skein::refiners {

/// A closed walk: places, each linked to the next and the last to the first.
using Walk = std::vector<std::uint32_t>;

/// Places about a footprint's width apart. A vehicle that passes a place, from any of its links to
/// any other, perceives all cells of the place; every cell of the field belongs to one place.
struct WalkGraph {
  struct Link {
    std::uint32_t to;
    double length;  ///< straight [m]
  };
  struct Place {
    world::Vector2 at = world::Vector2::Zero();
    double risk = 0;                     ///< of all its cells
    double top = 0;                      ///< of its most risky cell
    std::vector<Link> links;             ///< at most four; symmetrical
    std::vector<world::Vector2> passes;  ///< from link i to link j: at i × links + j. Turns are
                                         ///< pushed outwards as far as the outermost cells need
    std::vector<double> detours;         ///< same index: length added to half of each link [m]
  };

  std::vector<Place> places;
  double total_risk = 0;

  /// Index of the link from a place to another; the number of links if there is none.
  std::size_t link_to(std::uint32_t place, std::uint32_t other) const {
    const std::vector<Link>& links = places[place].links;
    std::size_t i = 0;
    while (i < links.size() && links[i].to != other) ++i;
    return i;
  }
  bool are_linked(std::uint32_t place, std::uint32_t other) const {
    return link_to(place, other) < places[place].links.size();
  }
  /// Length of a link. Precondition: the places are linked.
  double length(std::uint32_t from, std::uint32_t to) const {
    return places[from].links[link_to(from, to)].length;
  }
  /// Length added by passing `place` between two places linked to it [m].
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

/// A graph of places on a lattice, for a hovering vehicle (turns are sharp). Nothing if some cells
/// are perceived from no such place (along slanted borders, beside closed volumes), if not all
/// places can be reached, or if the deadline of the sight has passed.
std::optional<WalkGraph> make_walk_graph(const PatrolField& field, const PatrolSpace& space,
                                         const PatrolSight& sight);

/// Lower bound on the risk-weighted mean idleness of any walk, as a length [m]: (Σ √(R c))² / 2 Σ
/// R, where R is the risk of a place and c the least length of passing it. Proof:
/// docs/decisions/0027.
double least_mean_of_walks(const WalkGraph& graph);

/// Lower bound on the greatest risk × idleness of any walk, as a length [m]: Σ t c, where t is the
/// risk of a place's most risky cell. Proof: docs/decisions/0027.
double least_worst_of_walks(const WalkGraph& graph);

/// Lower bound on the risk-weighted mean idleness [m] of walks whose greatest risk × idleness is at
/// most `worst` [m]; infinite below least_worst_of_walks. Source: docs/decisions/0027.
double least_mean_of_walks(const WalkGraph& graph, double worst);

/// A walk over all places, lane by lane, with shortest paths where one lane does not lead to the
/// next.
Walk walk_in_turn(const WalkGraph& graph);

/// Appends the places strictly between two places on a path with the fewest links. False: no path.
bool append_shortest(const WalkGraph& graph, std::uint32_t from, std::uint32_t to, Walk& walk);

/// The track of a walk: one point for each visit.
std::vector<world::Vector2> track_of(const WalkGraph& graph, const Walk& walk);

}  // namespace skein::refiners
