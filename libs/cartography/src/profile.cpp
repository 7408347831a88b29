// SPDX-License-Identifier: Apache-2.0
// Heights along a way, over the ground and the closed volumes below it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing.hpp"

namespace skein::cartography {

double tick_step(double span, double ticks) {
  const double power = std::pow(10, std::floor(std::log10(std::max(span, 1e-6) / ticks)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (span / (factor * power) <= ticks) return factor * power;
  return 10 * power;
}

namespace {

using world::Vector3;

constexpr double kLeft = 46, kBottom = 30, kTop = 8;
/// Places along the way at which the ground is looked up.
constexpr std::size_t kSamples = 400;

struct Sample {
  double along;  ///< [m]
  Vector3 at;
  double ground;
};

std::vector<Sample> samples_of(const refiners::Way& way, const world::Terrain& terrain) {
  const double whole = refiners::length_of(way);
  std::vector<Sample> samples;
  double along = 0;
  const auto add = [&](double distance, const Vector3& at) {
    samples.push_back({distance, at, terrain.elevation(at.x(), at.y())});
  };
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double leg = (way[i] - way[i - 1]).norm();
    const auto steps = static_cast<std::size_t>(
        std::ceil(1 + static_cast<double>(kSamples) * leg / std::max(whole, 1e-9)));
    for (std::size_t k = 0; k < steps; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(steps);
      add(along + part * leg, way[i - 1] + part * (way[i] - way[i - 1]));
    }
    along += leg;
  }
  add(along, way.back());
  return samples;
}

/// Lengths and heights to pixels.
struct Axes {
  double length, low, high;
  double width;
  Spot operator()(double along, double z) const {
    const double tall = kProfileHeight - kTop - kBottom;
    return {kLeft + along / std::max(length, 1e-9) * (width - kLeft),
            kTop + (high - z) / std::max(high - low, 1e-9) * tall};
  }
};

Axes axes_of(const std::vector<Sample>& samples, double width) {
  Axes axes{samples.back().along, samples.front().ground, samples.front().at.z(), width};
  for (const Sample& sample : samples) {
    axes.low = std::min({axes.low, sample.ground, sample.at.z()});
    axes.high = std::max({axes.high, sample.ground, sample.at.z()});
  }
  const double room = std::max(5.0, 0.12 * (axes.high - axes.low));
  axes.low -= room / 2;
  axes.high += room;
  return axes;
}

/// Where the way passes over, under or through a closed volume.
std::string volume_bands(const std::vector<Sample>& samples, const Axes& axes,
                         const world::Volume& volume) {
  const double low = std::clamp(volume.floor, axes.low, axes.high);
  const double high = std::clamp(volume.ceiling, axes.low, axes.high);
  std::string out;
  for (std::size_t i = 0; i < samples.size();) {
    const auto inside = [&](std::size_t k) {
      return world::contains(volume.polygon, samples[k].at.head<2>());
    };
    std::size_t end = i;
    while (end < samples.size() && inside(end)) ++end;
    if (end > i) {
      const Spot a = axes(samples[i].along, high), b = axes(samples[end - 1].along, low);
      out += fmt::format(
          R"svg(<rect x="{}" y="{}" width="{}" height="{}" fill="url(#closed)" stroke="#b3202c" stroke-width="0.8"/>)svg"
          "\n",
          px(a.x), px(a.y), px(std::max(1.0, b.x - a.x)), px(std::max(0.0, b.y - a.y)));
    }
    i = end + 1;
  }
  return out;
}

std::string ticks(const Axes& axes) {
  std::string out;
  const double step = tick_step(axes.high - axes.low, 4);
  for (double z = std::ceil(axes.low / step) * step; z <= axes.high; z += step) {
    const Spot at = axes(0, z);
    out += fmt::format(R"(<path d="M{} {}H{}" stroke="#d0d0d0" stroke-width="0.6"/>)"
                       "\n",
                       px(kLeft), px(at.y), px(axes.width));
    out += text({kLeft - 5, at.y + 3.5}, fmt::format("{:g}", std::abs(z) < step / 2 ? 0 : z),
                {.size = 10, .anchor = "end"});
  }
  const double along = tick_step(axes.length, 8);
  for (double s = 0; s <= axes.length; s += along)
    out += text({axes(s, 0).x, kProfileHeight - kBottom + 13}, fmt::format("{:g}", s),
                {.size = 10, .anchor = "middle"});
  return out + text({axes.width, kProfileHeight - 3}, "along the way [m], height [m] upwards",
                    {.size = 10, .anchor = "end", .colour = "#707070"});
}

}  // namespace

std::string profile_of(const Map::Drawing& drawing, const refiners::Way& way,
                       const std::string& colour) {
  const std::vector<Sample> samples = samples_of(way, drawing.world.terrain);
  const Axes axes = axes_of(samples, std::max(drawing.scale.width(), 620.0));
  std::vector<Spot> ground = {axes(0, axes.low)}, flown;
  for (const Sample& sample : samples) {
    ground.push_back(axes(sample.along, sample.ground));
    flown.push_back(axes(sample.along, sample.at.z()));
  }
  ground.push_back(axes(axes.length, axes.low));
  std::string out = ticks(axes);
  out += fmt::format(R"(<polygon points="{}" fill="#cbb493" stroke="#7a5c3a" stroke-width="0.8"/>)"
                     "\n",
                     points(ground));
  for (const world::Volume& volume : drawing.closed) out += volume_bands(samples, axes, volume);
  return out +
         fmt::format(
             R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="2" stroke-linejoin="round"/>)"
             "\n",
             points(flown), colour);
}

}  // namespace skein::cartography
