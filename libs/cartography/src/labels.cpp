// SPDX-License-Identifier: Apache-2.0
#include "labels.hpp"

#include <algorithm>
#include <array>

namespace skein::cartography {
namespace {

constexpr double kSize = 11;
constexpr double kAway = 8;

struct Box {
  double left, top, right, bottom;
};

double overlap(const Box& a, const Box& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return std::max(0.0, width) * std::max(0.0, height);
}

Box box_at(const Spot& centre, double width) {
  return {centre.x - width / 2, centre.y - kSize / 2 - 1, centre.x + width / 2,
          centre.y + kSize / 2 + 1};
}

double outside(const Box& box, double width, double height) {
  return std::max(0.0, -box.left) + std::max(0.0, -box.top) + std::max(0.0, box.right - width) +
         std::max(0.0, box.bottom - height);
}

std::vector<Spot> candidates(const Label& label, double width) {
  const Spot& at = label.at;
  if (!label.beside)
    return {at, {at.x, at.y - 14}, {at.x, at.y + 14}, {at.x, at.y - 28}, {at.x, at.y + 28}};
  const double side = width / 2 + kAway;
  return {{at.x + side, at.y},      {at.x - side, at.y},      {at.x, at.y - 14},
          {at.x, at.y + 15},        {at.x + side, at.y - 12}, {at.x + side, at.y + 12},
          {at.x - side, at.y - 12}, {at.x - side, at.y + 12}};
}

}  // namespace

std::string placed(const std::vector<Label>& labels, double width, double height) {
  std::vector<Box> taken;
  for (const Label& label : labels)
    if (label.beside)
      taken.push_back({label.at.x - 4, label.at.y - 4, label.at.x + 4, label.at.y + 4});
  std::string out;
  for (const Label& label : labels) {
    const double wide = width_of(label.words, kSize);
    Spot best = label.at;
    double least = -1;
    for (const Spot& spot : candidates(label, wide)) {
      const Box box = box_at(spot, wide);
      double covered = 50 * outside(box, width, height);
      for (const Box& other : taken) covered += overlap(box, other);
      if (least >= 0 && covered >= least) continue;
      least = covered;
      best = spot;
    }
    taken.push_back(box_at(best, wide));
    out += text({best.x, best.y + kSize * 0.35}, label.words,
                {.size = kSize, .anchor = "middle", .colour = label.colour, .halo = true});
  }
  return out;
}

}  // namespace skein::cartography
