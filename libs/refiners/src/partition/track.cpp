// SPDX-License-Identifier: Apache-2.0
#include "partition/track.hpp"

namespace skein::refiners::partition {

Vector2 middle_of(const Polygon& polygon) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

double unlikeness(const Division& a, const Division& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    sum += (middle_of(a.parts[i]) - middle_of(b.parts[i])).squaredNorm();
  return sum;
}

}  // namespace skein::refiners::partition
