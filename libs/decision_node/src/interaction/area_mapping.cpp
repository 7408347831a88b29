// SPDX-License-Identifier: Apache-2.0
#include "interaction/area_mapping.hpp"

#include <cmath>

#include "interaction/area_cutting.hpp"
#include "interaction/role_tasks.hpp"

namespace skein::decision_node {

namespace {

/// Way-points are passed within that [m].
double passing_distance(const world::VehicleModel& vehicle, const world::Wind& wind) {
  return 5 + 6 * world::tracking_spread(vehicle) + vehicle.wind_drift * wind.speed;
}

}  // namespace

AreaMapping::AreaMapping(const PlaySurroundings& of, RoleCourse& course)
    : host_(of.host),
      sightings_(of.sightings),
      my_(of.my),
      course_(course),
      share_(of.host.config().uav) {}

SweepSetting AreaMapping::setting(const std::string& role) const {
  const auto& knowledge = host_.config().knowledge;
  return {knowledge, host_.world(), host_.bus().now(), sightings_.own()->state,
          device_of(my_.joint.library->roles.at(role), knowledge->vehicle)};
}

Result<interaction::Rows, Failure> AreaMapping::offer(const interaction::Terms& terms) const {
  return share_.offer(terms, setting(my_.holders.at(host_.config().uav)));
}

void AreaMapping::map(const std::string& componel) {
  if (!share_.agreed()) return course_.fail(componel, "the area is not shared");
  // Of who was lost while the role began this anew it has not heard.
  if (!share_.nobodys().empty()) course_.tell(interaction::Message{kMemberLost});
  const SweepSetting setting = this->setting(course_.play().role());
  const auto way = share_.set_out(setting);
  if (!way && way.error().opens) return wait(componel, way.error());
  if (!way) return course_.fail(componel, way.error().why);
  if (way->empty()) return course_.tell_status(componel, interaction::Status::Word::kEnded);
  const executive::TaskId flight = course_.give(componel, flight_along(*way));
  course_.give(componel, look_along(flight, setting.device), flight);
}

bool AreaMapping::goes_on_after(executive::TaskId task) {
  if (waits_.erase(task) > 0) return true;
  share_.flown();
  return share_.area_left() > kNoArea;
}

void AreaMapping::wait(const std::string& componel, const supervisor::NoSweep& refused) {
  const Duration length = *refused.opens - host_.bus().now();
  host_.bus().emit(Notice{my_.joint.subject + ": " + componel + ": " + refused.why +
                          "; it waits until air is open again, " +
                          std::to_string(std::lround(length.to_seconds())) + " s"});
  executive::Task wait;
  wait.type = "wait";
  wait.parameters.add("duration", length.to_seconds());
  waits_.insert(course_.give(componel, std::move(wait)));
}

void AreaMapping::see() {
  share_.fly(sightings_.own()->state.position,
             passing_distance(host_.config().knowledge->vehicle, host_.world()->wind));
}

}  // namespace skein::decision_node
