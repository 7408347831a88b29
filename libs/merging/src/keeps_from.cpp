// SPDX-License-Identifier: Apache-2.0
#include "keeps_from.hpp"

#include <algorithm>

namespace skein::merging {

bool keeps_from(const Volumes& held, const Volumes& wanted, const Volumes& own) {
  const auto leaves = [&](const Volume& one, const Volume& piece) {
    return std::any_of(own.begin(), own.end(), [&](const Volume& place) {
      return overlap(one, place) && place.floor <= piece.floor && piece.ceiling <= place.ceiling;
    });
  };
  return std::any_of(held.begin(), held.end(), [&](const Volume& one) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const Volume& piece) {
      return overlap(one, piece) && !leaves(one, piece);
    });
  });
}

}  // namespace skein::merging
