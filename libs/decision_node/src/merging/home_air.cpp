// SPDX-License-Identifier: Apache-2.0
#include "merging/home_air.hpp"

#include "core.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/supervisor/own_ways.hpp"

namespace skein::decision_node {

using world::Vector3;

namespace {

functional::Request along(const std::vector<Vector3>& way) {
  functional::Request request{functional::Verb::kDispatch, {}, "goto", {}};
  request.parameters.add(elementary::points_parameter("waypoints", {way.begin() + 1, way.end()}));
  return request;
}

}  // namespace

bool HomeAir::returns() const {
  const Config& config = core_.config();
  return config.merging && !config.merging->witness.empty() && !config.drives &&
         config.contact_policy == ContactPolicy::kReturn && config.knowledge &&
         core_.deliberation().possible();
}

bool HomeAir::is_new(const std::optional<Vector3>& rest) const {
  return reaches_ground_ && returns() && (from_ != rest || world_ != core_.deliberation().world());
}

void HomeAir::look(const std::optional<Vector3>& rest, const AirwaySituation& situation) {
  from_ = rest;
  world_ = core_.deliberation().world();
  flight_.reset();
  air_.clear();
  if (!rest) return;
  const MergingConfig& config = *core_.config().merging;
  const auto& place = core_.config().home;
  const Vector3 home(place.at(0), place.at(1), place.at(2));
  const auto margins = merging::margins_of(config.model, config.wind, config.model.cruise_speed);
  AirwaySituation there = situation;
  there.state.airborne = true;
  there.state.position = *rest;
  there.rest = rest;
  if ((*rest - home).norm() > margins.settled && !add_flight(home, there)) return;
  const Vector3 wavering(0, 0, margins.slope);
  air_.push_back(landing_at(home + wavering, margins));
}

bool HomeAir::add_flight(const Vector3& home, const AirwaySituation& there) {
  const auto way = supervisor::own_way(core_.config().knowledge, world_, there.now, *from_, home);
  auto ways = airways_of(along(way), false, *core_.config().merging, there);
  if (!ways || ways->empty()) return false;
  flight_ = std::move(ways->front());
  air_ = flight_->air;
  return true;
}

std::optional<Airway> HomeAir::flight(const functional::Request& request,
                                      const std::optional<Vector3>& rest) const {
  if (!flight_ || request.type != "goto" || !is_own(request.id) || rest != from_)
    return std::nullopt;
  Airway home = *flight_;
  home.request.id = request.id;
  return home;
}

}  // namespace skein::decision_node
