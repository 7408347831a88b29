// SPDX-License-Identifier: Apache-2.0
#include "partition/planner.hpp"

#include <algorithm>
#include <limits>

namespace skein::refiners::partition {
namespace {

/// Sweeps are planned with so many times the energy, to learn what they take.
constexpr double kPlenty = 1e6;
/// A limit learnt is kept that much below where it was seen, for it is not quite linear.
constexpr double kCaution = 0.99;
/// Sweeps for a first answer, once the time is up.
constexpr std::uint64_t kLateSweeps = 5;

double speed_of(const Member& member) {
  return member.speed > 0 ? member.speed : member.vehicle.cruise_speed;
}

Duration later(Duration duration, double seconds) {
  return duration == Duration::max() ? duration : duration + Duration::seconds(seconds);
}

void delay(Refined<Coverage>& sweep, double seconds) {
  sweep.cost += seconds;
  DurationInterval& duration = sweep.duration;
  duration = {later(duration.least, seconds), later(duration.expected, seconds),
              later(duration.most, seconds)};
}

}  // namespace

void judge(Trial& trial) {
  double earliest = std::numeric_limits<double>::infinity();
  trial.latest = 0;
  for (const Refined<Coverage>& sweep : trial.sweeps) {
    trial.latest = std::max(trial.latest, sweep.cost);
    earliest = std::min(earliest, sweep.cost);
  }
  trial.spread = (trial.latest - earliest) / trial.latest;
}

double usable(const Member& member) { return 1 - member.vehicle.energy.reserve; }

Planner::Planner(const PartitionQuery& query, const Setting& setting)
    : query_(query),
      setting_(setting),
      whole_(world::area(query.area)),
      steps_(setting.budget.steps) {}

bool Planner::fly(Trial& trial, std::size_t member) const {
  const Member& who = query_.members[member];
  const auto seconds = query_.flown(who, trial.altitudes[member], trial.division.parts[member]);
  if (!seconds) return false;
  delay(trial.sweeps[member], who.busy + *seconds - trial.sweeps[member].cost);
  return true;
}

std::vector<Ability> Planner::abilities() const {
  std::vector<Ability> abilities;
  for (const Member& member : query_.members) {
    const double speed = speed_of(member), rate = speed * member.swath;
    const double seconds = usable(member) * member.vehicle.energy.capacity /
                           world::flight_power(member.vehicle, speed, 0);
    abilities.push_back({rate, 0, rate * seconds});
  }
  return abilities;
}

std::vector<Division> Planner::divide(const std::vector<double>& areas, std::size_t most,
                                      double between) const {
  std::vector<world::Vector2> starts;
  for (const Member& member : query_.members) starts.push_back(member.start);
  const Budget clock{setting_.budget.time_is_up};
  return divisions(query_.area, starts, areas, most, clock, between);
}

Result<Trial, Refusal> Planner::plan(const std::vector<double>& areas) {
  std::vector<Division> found = divide(areas, 1);
  if (!found.empty()) return plan(areas, std::move(found.front()));
  effort_.cut_short = true;
  return refuse(RefusalKind::kBudgetExhausted, "members",
                "the time was up before the area was divided");
}

Result<Trial, Refusal> Planner::plan(const std::vector<double>& areas, Division division) {
  Trial trial{areas, std::move(division), {}, 0, 0, {}};
  for (std::size_t i = 0; i < query_.members.size(); ++i) {
    const Member& member = query_.members[i];
    if (setting_.budget.expired() && ++late_ > kLateSweeps)
      return refuse(RefusalKind::kBudgetExhausted, "members",
                    "the time was up before anybody's part was swept");
    ++effort_.steps;
    auto swept = sweep(member, member.altitude, trial.division.parts[i]);
    if (!swept)
      return refuse(swept.error().kind, "members." + std::to_string(i) + "." + swept.error().field,
                    "in the part of " + member.uav + ": " + swept.error().why);
    trial.sweeps.push_back(std::move(*swept));
    trial.altitudes.push_back(member.altitude);
  }
  judge(trial);
  return trial;
}

Result<void, Refusal> Planner::fly_at(Trial& trial, std::size_t member, double altitude) {
  auto swept = sweep(query_.members[member], altitude, trial.division.parts[member]);
  if (!swept) return tl::unexpected<Refusal>(swept.error());
  trial.sweeps[member] = std::move(*swept);
  trial.altitudes[member] = altitude;
  if (trial.flown) fly(trial, member);
  judge(trial);
  return {};
}

Outcome<Coverage> Planner::sweep(const Member& member, double altitude,
                                 const world::Polygon& part) {
  CoverageQuery query;
  query.vehicle = member.vehicle;
  query.vehicle.energy.capacity *= kPlenty;
  query.area = part;
  query.swath = member.swath;
  query.altitude = altitude;
  query.speed = member.speed;
  query.depart = query_.depart;
  const double ground = setting_.world.terrain.elevation(member.start.x(), member.start.y());
  query.start = world::Vector3(member.start.x(), member.start.y(), ground + altitude);
  Setting setting{setting_.world, {}, setting_.seed, setting_.paths};
  setting.budget.time_is_up = setting_.budget.time_is_up;
  auto swept = refine(query, setting);
  if (!swept) return swept;
  swept->task.energy *= kPlenty;
  delay(*swept, member.busy);
  effort_.cut_short = effort_.cut_short || swept->effort.cut_short;
  return swept;
}

bool Planner::has_energy(const Trial& trial) const {
  for (std::size_t i = 0; i < trial.sweeps.size(); ++i)
    if (!(trial.sweeps[i].task.energy <= usable(query_.members[i]))) return false;
  return true;
}

double Planner::seconds_to(const Member& member, const Refined<Coverage>& sweep) const {
  const double distance = (sweep.task.lanes.front().from - member.start).norm();
  return std::min(member.busy + distance / speed_of(member), sweep.cost);
}

void Planner::learn_limits(const Trial& trial, std::vector<Ability>& abilities) const {
  for (std::size_t i = 0; i < abilities.size(); ++i) {
    const Member& member = query_.members[i];
    const Refined<Coverage>& sweep = trial.sweeps[i];
    if (sweep.task.energy <= usable(member)) continue;
    // What is drawn on the way there is drawn for any area.
    const double on_the_way = sweep.task.energy * (seconds_to(member, sweep) - member.busy) /
                              std::max(sweep.cost - member.busy, 1e-9);
    const double left = std::max(0.0, usable(member) - on_the_way);
    const double taken = std::max(sweep.task.energy - on_the_way, 1e-9);
    abilities[i].limit = kCaution * trial.areas[i] * left / taken;
  }
}

void Planner::learn_rates(const Trial& trial, std::vector<Ability>& abilities) const {
  for (std::size_t i = 0; i < abilities.size(); ++i) learn_rate(trial, i, abilities[i]);
}

void Planner::learn_rate(const Trial& trial, std::size_t member, Ability& ability) const {
  const Refined<Coverage>& sweep = trial.sweeps[member];
  ability.ready = seconds_to(query_.members[member], sweep);
  ability.rate = trial.areas[member] / std::max(sweep.cost - ability.ready, 1e-9);
}

bool Planner::out_of_budget() const { return effort_.cut_short || effort_.steps >= steps_; }

bool Planner::finished() {
  if (effort_.steps == 0) return false;
  effort_.cut_short = effort_.cut_short || setting_.budget.expired();
  return out_of_budget();
}

}  // namespace skein::refiners::partition
