// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_setup/belief_layer.hpp"

#include <algorithm>
#include <array>

#include "page_grid.hpp"
#include "skein/translation/sensing.hpp"

namespace skein::ground_setup {

namespace {

/// Of odds against those of the prior: each level begins here.
constexpr std::array kLevels = {0.05, 0.2, 0.6, 1.0, 3.0, 8.0, 25.0, 80.0, 250.0};

double odds(double belief) { return belief / (1 - belief); }

char level_of(double belief, double prior) {
  const double ratio = odds(belief) / odds(prior);
  const auto level = std::upper_bound(kLevels.begin(), kLevels.end(), ratio) - kLevels.begin();
  return static_cast<char>('0' + level);
}

}  // namespace

BeliefLayer::BeliefLayer(const scenario::Scenario& scenario)
    : prior_(scenario.ground.pps.prior),
      terrain_(scenario.world.terrain),
      map_(scenario.ground.pps, terrain_, page_grid(scenario.world.terrain)) {
  for (const scenario::UavSpec& uav : scenario.uavs) uavs_.insert(uav.name);
}

std::vector<std::pair<std::string, std::string>> BeliefLayer::see(const wire::Sample& sample) {
  std::vector<std::pair<std::string, std::string>> news;
  std::optional<world::Perception> look;
  if (const auto* report = std::get_if<wire::PerceptionReport>(&sample))
    look = translation::from_wire(*report);
  if (const auto* sighting = std::get_if<wire::Sighting>(&sample))
    look = translation::from_wire(*sighting);
  if (!look || !uavs_.contains(look->uav)) return news;
  for (const std::size_t one : map_.handle(*look)) {
    const std::string number = std::to_string(one);
    news.emplace_back("belief " + number,
                      R"({"belief":{"row":)" + number + R"(,"cells":")" + row(one) + "\"}}");
  }
  return news;
}

std::string BeliefLayer::row(std::size_t row) const {
  std::string cells(map_.grid().columns, '.');
  for (std::size_t column = 0; column < cells.size(); ++column) {
    if (const auto belief = map_.belief(map_.grid().index(column, row))) {
      cells[column] = level_of(*belief, prior_);
    }
  }
  return cells;
}

}  // namespace skein::ground_setup
