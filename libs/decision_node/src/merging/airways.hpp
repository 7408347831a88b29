// SPDX-License-Identifier: Apache-2.0
// The air that a motion of the vehicle takes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/decision_node/config.hpp"
#include "skein/elementary/task_checks.hpp"
#include "skein/foundation/result.hpp"
#include "skein/functional/port.hpp"
#include "skein/merging/way.hpp"
#include "skein/refiners/path.hpp"
#include "skein/world/vehicle_state.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/world.hpp"

namespace skein::decision_node {

/// A motion as it would be flown, one of several ways to do it.
struct Airway {
  functional::Request request;        ///< for the vehicle
  std::optional<merging::Way> way;    ///< of a flight; takeoffs and landings have none
  merging::Volumes air;               ///< that it takes, at last where it stays
  std::optional<world::Vector3> end;  ///< where it comes to rest in the air
  double raised = 0;                  ///< above what was asked for [m]
  double energy = 0;                  ///< of a way around: of what is held when full
};
using Airways = std::vector<Airway>;

/// What is known of the vehicle and of closed air when a way is made.
struct AirwaySituation {
  world::VehicleState state;
  std::optional<world::Vector3> rest;  ///< where it holds or circles
  bool aside = false;                  ///< it is there because it got out of the way
  bool passing = false;                ///< it comes to `rest` in flight, and flies on
  std::vector<world::Volume> volumes;  ///< no-fly
  MissionTime now;
};

/// The same, were it to hold or circle there.
AirwaySituation resting_at(AirwaySituation situation, const world::Vector3& place);

/// Does the motion move the vehicle, so that it needs air?
bool needs_air(const functional::Request& request);

/// Of a flight; nothing: it is none, or the vehicle cannot.
std::optional<elementary::GotoTask> flight_of(const functional::Request& request,
                                              const MergingConfig& config,
                                              const AirwaySituation& situation);

/// It lands, or looks, where the vehicle is.
bool is_done_in_place(const functional::Request& request);

/// The motion as it was asked for, and then, when it may be flown at any height, higher ones that
/// meet no closed air but what they leave. An error: why the vehicle cannot do it, in all its
/// reasons.
Result<Airways, Failure> airways_of(const functional::Request& request, bool at_any_height,
                                    const MergingConfig& config, const AirwaySituation& situation);

/// The motion's air as it would be from there; none: it cannot, or needs none.
merging::Volumes air_from(const world::Vector3& place, const functional::Request& request,
                          const MergingConfig& config, const AirwaySituation& situation);

/// Flights to the place under that number, at any height; none: the vehicle cannot.
Airways flights_to(const world::Vector3& place, functional::TaskId id, const MergingConfig& config,
                   const AirwaySituation& situation);

/// What a landing takes that begins there. Cost: constant.
merging::Volume landing_at(const world::Vector3& place, const merging::Margins& margins);

/// For a way to where the motion leads that keeps out of `taken`, the air of others. Nothing: it is
/// no flight.
std::optional<refiners::PathQuery> query_around(const functional::Request& request,
                                                const merging::Volumes& taken,
                                                const MergingConfig& config,
                                                const AirwaySituation& situation);

/// The flight to where the motion leads along a path that was found for it. Nothing: the vehicle is
/// not where it begins, or it does not keep out of `taken` and closed air.
std::optional<Airway> airway_along(const functional::Request& request, const refiners::Path& path,
                                   const merging::Volumes& taken, const MergingConfig& config,
                                   const AirwaySituation& situation);

/// The flight by way of `place`, where it was planned to begin; as it was if the vehicle is there,
/// or if it is no flight.
functional::Request begun_at(const world::Vector3& place, const functional::Request& request,
                             const MergingConfig& config, const AirwaySituation& situation);

/// The flight, for a vehicle that is elsewhere than where it was planned from: where the leg to its
/// first way-point would lead through closed air, by way-points around that. As it was: the leg is
/// free, it is no flight, or no way around is known. Cost: that of search_way().
functional::Request led_around(const functional::Request& request, const MergingConfig& config,
                               const AirwaySituation& situation,
                               const std::shared_ptr<const world::World>& world);

/// Short flights from where it rests to places that are free of `others`, the nearest first: up,
/// then beside, at each of these heights above it [m], at last down where the ground leaves room.
/// Not the way there: where it is now is what others want. Precondition: it rests in the air.
Airways ways_aside(functional::TaskId id, const merging::Volumes& others,
                   const MergingConfig& config, const AirwaySituation& situation,
                   const std::vector<double>& heights = {0});

}  // namespace skein::decision_node
