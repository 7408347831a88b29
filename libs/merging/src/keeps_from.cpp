// SPDX-License-Identifier: Apache-2.0
#include "keeps_from.hpp"

#include <algorithm>

#include "skein/world/segment.hpp"

namespace skein::merging {

namespace {

/// Whether who flies along `piece` comes no nearer to the middle of `one` than where it begins. The
/// distance to a straight line is convex, so it never comes back either.
bool leads_out(const Volume& piece, const Volume& one) {
  constexpr double kRounding = 1e-3;  // [m]
  const double first = world::between_segments(piece.from, piece.from, one.from, one.to);
  return world::between_segments(piece.from, piece.to, one.from, one.to) >= first - kRounding;
}

}  // namespace

bool keeps_from(const Volumes& held, const Volumes& wanted, const Volumes& own) {
  const auto leaves = [&](const Volume& one, const Volume& piece) {
    const bool is_there = std::any_of(own.begin(), own.end(), [&](const Volume& place) {
      return overlap(one, place) && place.floor <= piece.floor && piece.ceiling <= place.ceiling;
    });
    return is_there && leads_out(piece, one);
  };
  return std::any_of(held.begin(), held.end(), [&](const Volume& one) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const Volume& piece) {
      return overlap(one, piece) && !leaves(one, piece);
    });
  });
}

}  // namespace skein::merging
