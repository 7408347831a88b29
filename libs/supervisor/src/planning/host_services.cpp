// SPDX-License-Identifier: Apache-2.0
#include "planning/host_services.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planning/terms.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermStore;
using world::Vector3;

namespace {

using Value = Result<Term, Failure>;

tl::unexpected<Failure> wrong(const TermStore& store, Term term, const std::string& expected) {
  return failure(store.to_text(term) + " is no " + expected);
}

/// Views of one place.
constexpr double kMostSides = 16;
constexpr double kRounding = 1e-6;  // [0.1 s]

Term locations_term(TermStore& store, const std::vector<Vector3>& points) {
  std::vector<Term> terms;
  for (const Vector3& point : points) terms.push_back(location_term(store, point));
  return store.list(terms);
}

/// The first way-point is where the vehicle is, unless it is the only one.
Term waypoints_term(TermStore& store, const refiners::Way& way) {
  std::vector<Term> terms;
  for (std::size_t i = way.size() > 1 ? 1 : 0; i < way.size(); ++i)
    terms.push_back(location_term(store, way[i]));
  return headed(store, "waypoints", std::move(terms));
}

/// A way is the last of an answer's parameters.
Term way_term(TermStore& store, const refiners::Way& way) {
  std::vector<Term> terms;
  for (const Vector3& point : way) terms.push_back(location_term(store, point));
  return headed(store, "way", std::move(terms));
}

/// (LOC ROOM).
Term spot_term(TermStore& store, const Spot& spot) {
  const std::vector<Term> pair = {location_term(store, spot.at), number_term(store, spot.room)};
  return store.list(pair);
}

std::vector<Spot> spots_of(const TermStore& store, Term list) {
  std::vector<Spot> spots;
  if (!store.is_list(list)) return spots;
  for (const Term one : store.items(list)) {
    const std::vector<Term> pair = store.is_list(one) ? store.items(one) : std::vector<Term>{};
    if (pair.size() != 2) continue;
    const auto at = location_of(store, pair[0]);
    const auto room = number_of(store, pair[1]);
    if (at && room) spots.push_back({*at, *room});
  }
  return spots;
}

}  // namespace

std::span<const PlannerHost::Services::Entry> PlannerHost::Services::table() {
  static constexpr std::array<Entry, 32> entries = {
      {{"compute-takeoff", 2, ask<&Services::takeoff>, true, 1},
       {"compute-land", 2, ask<&Services::land>, true},
       {"compute-gotoxyz", 3, ask<&Services::gotoxyz>, true, 2},
       {"compute-gotoxyz-among", 4, ask<&Services::gotoxyz_among>, true, 3},
       {"compute-wait", 4, ask<&Services::wait>, false},
       {"compute-wait-for-patrol", 6, ask<&Services::wait_for_patrol>, false},
       {"compute-wait-for-sweep", 4, ask<&Services::wait_for_sweep>, false},
       {"compute-wait-for-rest", 6, ask<&Services::wait_for_rest>, false},
       {"compute-next-opening", 1, ask<&HostRelations::next_opening>, false},
       {"compute-patrol", 5, ask<&Services::patrol>, true, 4},
       {"compute-sweep", 4, ask<&Services::sweep>, true, 3},
       {"compute-sweep-entry", 4, ask<&Services::sweep_entry>, false},
       {"compute-rest", 6, ask<&Services::rest>, true, 5},
       {"compute-part", 2, ask<&Services::part>, false},
       {"not-reached", 2, ask<&HostRelations::not_reached>, false},
       {"within-reach", 4, ask<&Services::within_reach>, false},
       {"is-open", 2, ask<&Services::is_open>, false},
       {"stays-open", 3, ask<&Services::stays_open>, false},
       {"compute-stay", 1, ask<&Services::stay>, false},
       {"compute-landing-place", 3, ask<&Services::landing_place>, true, 2},
       {"compute-way-out", 1, ask<&Services::way_out>, true},
       {"is-free", 1, ask<&Services::is_free>, false},
       {"compute-viewpoint", 4, ask<&Services::viewpoint>, true, 2},
       {"compute-meeting", 6, ask<&Services::meeting>, true, 5},
       {"compute-angles", 5, ask<&Services::angles>, true, 3},
       {"compute-entry", 1, ask<&HostRelations::entry>, false},
       {"compute-tour", 2, ask<&Services::tour>, true},
       {"target-of", 1, ask<&HostRelations::target_of>, false},
       {"is-at", 2, ask<&HostRelations::is_at>, false},
       {"is-over", 2, ask<&HostRelations::is_over>, false},
       {"with-me", 1, ask<&HostRelations::with_me>, false},
       {"in-time", 5, ask<&HostRelations::in_time>, false}}};
  return entries;
}

const PlannerHost::Services::Entry& PlannerHost::Services::entry_of(Service service) {
  return *std::find_if(table().begin(), table().end(),
                       [&](const Entry& one) { return one.service == service; });
}

PlannerHost::Services::Services(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed,
                                refiners::Budget budget)
    : refinery_(gazetteer, origin, seed, std::move(budget)),
      names_(std::move(gazetteer)),
      relations_(names_, origin) {}

Value PlannerHost::Services::call(const Entry& entry, TermStore& store, Arguments arguments) {
  Value value =
      entry.refines ? refined(entry, store, arguments) : entry.service(*this, store, arguments);
  if (!value) value.error().why.insert(0, std::string(entry.name) + ": ");
  return value;
}

Value PlannerHost::Services::refined(const Entry& entry, TermStore& store, Arguments arguments) {
  // When it is makes no difference where no air is closed for a time, but to what begins in flight.
  std::vector<Term> named = {store.symbol(entry.name)};
  named.insert(named.end(), arguments.begin(), arguments.end());
  if (entry.when != 0 && !refinery_.air.has_windows()) {
    Term& when = named[entry.when + 1];
    const Departure then = departure(store, when);
    when = refinery_.air.start().in_flight(then) ? store.symbol("in-flight")
           : refinery_.air.still_stands(then)    ? store.symbol("standing")
                                                 : kNil;
  }
  const Term question = store.list(named);
  if (const auto known = known_.find(question); known != known_.end()) {
    for (const std::string& why : known->second.said) names_.refuse(why);
    return known->second.value;
  }
  const auto before = static_cast<std::ptrdiff_t>(names_.said().size());
  Value value = entry.service(*this, store, arguments);
  if (value) known_[question] = {*value, {names_.said().begin() + before, names_.said().end()}};
  ++refinements_;
  return value;
}

Term PlannerHost::Services::answer(TermStore& store, const Motion& motion,
                                   std::vector<Term> params) {
  const Term destination = headed(store, "destination", {location_term(store, motion.way.back())});
  const Term duration =
      headed(store, "duration",
             {number_term(store, motion.times.least), number_term(store, motion.times.most)});
  params.push_back(way_term(store, motion.way));
  std::vector<Term> all = {destination, duration,
                           headed(store, "energy", {number_term(store, motion.energy)}),
                           headed(store, "cost", {number_term(store, motion.times.expected)})};
  if (motion.aim) all.push_back(headed(store, "aim", {target_term(store, *motion.aim)}));
  all.push_back(headed(store, "params", std::move(params)));
  return store.list(all);
}

Term PlannerHost::Services::flight(TermStore& store, const Answer<Motion>& motion,
                                   const std::string& what) {
  if (!motion) return names_.refuse(what + ": " + motion.error());
  return answer(store, *motion, {waypoints_term(store, motion->way)});
}

Value PlannerHost::Services::takeoff(TermStore& store, Arguments arguments) {
  auto from = names_.place(store, arguments[0]);
  if (!from) return kNil;
  from->z() = gazetteer().ground(*from);
  const auto motion = refinery_.ways.takeoff(*from, departure(store, arguments[1]));
  if (!motion) return names_.refuse("takeoff: " + motion.error());
  const double altitude = motion->way.back().z() - from->z();
  return answer(store, *motion, {headed(store, "altitude", {number_term(store, altitude)})});
}

Value PlannerHost::Services::land(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]), to = names_.place(store, arguments[1]);
  if (!from || !to) return kNil;
  const auto motion = refinery_.ways.landing(*from, *to);
  if (!motion) return names_.refuse("landing: " + motion.error());
  return answer(store, *motion, {});
}

/// (compute-landing-place FROM PLACE WHEN): PLACE as it is given, or the nearest ground that
/// serves, for who sets out for it then.
Value PlannerHost::Services::landing_place(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]), to = names_.place(store, arguments[1]);
  if (!from || !to) return kNil;
  const auto at = refinery_.ways.landing_place(*from, *to, departure(store, arguments[2]));
  if (!at)
    return names_.refuse("landing at " + Gazetteer::words(store, arguments[1]) + ": " + at.error());
  return at->instead.empty() ? arguments[1] : location_term(store, at->at);
}

Value PlannerHost::Services::way_out(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]);
  if (!from) return kNil;
  return flight(store, refinery_.ways.way_out(*from), "no way out");
}

Value PlannerHost::Services::is_free(TermStore& store, Arguments arguments) {
  const auto at = names_.place(store, arguments[0]);
  return TermStore::boolean(at && refinery_.air.may_stay(*at));
}

/// (compute-gotoxyz FROM TO WHEN): WHEN is the interval in which the motion may begin; nil: at any
/// time.
Value PlannerHost::Services::gotoxyz(TermStore& store, Arguments arguments) {
  return way(store, arguments.first(2), {}, arguments[2]);
}

/// (compute-gotoxyz-among FROM TO ((LOC ROOM)…) WHEN): likewise, around where others wait.
Value PlannerHost::Services::gotoxyz_among(TermStore& store, Arguments arguments) {
  return way(store, arguments.first(2), spots_of(store, arguments[2]), arguments[3]);
}

Value PlannerHost::Services::way(TermStore& store, Arguments ends, const std::vector<Spot>& others,
                                 Term when) {
  const auto from = names_.place(store, ends[0]), to = names_.place(store, ends[1]);
  if (!from || !to) return kNil;
  return flight(
      store,
      refinery_.ways.path_among(*from, gazetteer().flown_to(*to), others, departure(store, when)),
      "no way from " + Gazetteer::words(store, ends[0]) + " to " +
          Gazetteer::words(store, ends[1]));
}

Value PlannerHost::Services::patrol(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]);
  const std::string name = text_of(store, arguments[1]);
  const world::Zone* zone = gazetteer().zone(name);
  const auto* device = gazetteer().sensor(text_of(store, arguments[2]));
  const auto seconds = number_of(store, arguments[3]);
  if (device == nullptr)
    return names_.refuse("no device '" + text_of(store, arguments[2]) + "' on board");
  if (!seconds || *seconds <= 0) return wrong(store, arguments[3], "positive number of seconds");
  if (!from) return kNil;
  if (zone == nullptr) return names_.refuse("unknown zone '" + name + "'");
  return flight(
      store,
      refinery_.patrols.over(*from, *zone, *device, *seconds, departure(store, arguments[4])),
      "no detection over " + zone->name);
}

Value PlannerHost::Services::sweep(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]);
  const std::string name = text_of(store, arguments[1]);
  const world::Zone* zone = gazetteer().zone(name);
  const auto* device = gazetteer().sensor(text_of(store, arguments[2]));
  if (device == nullptr)
    return names_.refuse("no device '" + text_of(store, arguments[2]) + "' on board");
  if (!from) return kNil;
  if (zone == nullptr) return names_.refuse("unknown zone '" + name + "'");
  return flight(store, refinery_.sweeps.over(*from, *zone, *device, departure(store, arguments[3])),
                "no mapping of " + zone->name);
}

/// (compute-rest FROM ZONE DEVICE BEFORE (LOC…) WHEN): the motion along what is left of a way over
/// the zone that was flown with the device BEFORE; nil, without a sentence, when it is to be
/// planned anew.
Value PlannerHost::Services::rest(TermStore& store, Arguments arguments) {
  const auto from = gazetteer().place(store, arguments[0]);
  const auto* device = gazetteer().sensor(text_of(store, arguments[2]));
  const auto* before = gazetteer().sensor(text_of(store, arguments[3]));
  const std::vector<Vector3> way = locations_of(store, arguments[4]);
  if (!from || device == nullptr || before == nullptr || way.size() < 2) return kNil;
  if (gazetteer().zone(text_of(store, arguments[1])) == nullptr) return kNil;
  const auto motion =
      refinery_.sweeps.rest(*from, way, *device, *before, departure(store, arguments[5]));
  return motion ? flight(store, motion, "rest") : Value(kNil);
}

/// (compute-part LANES SHARE): of the motion along lanes the first of two parts, and what it leaves
/// as (beyond LOC…); nil when the lanes cannot be parted.
Value PlannerHost::Services::part(TermStore& store, Arguments arguments) {
  const auto share = number_of(store, arguments[1]);
  if (!share || *share <= 0 || *share >= 1)
    return wrong(store, arguments[1], "share between 0 and 1");
  const auto parts = refinery_.sweeps.parted(way_of(store, arguments[0]), *share);
  if (!parts) return kNil;
  const Term first = answer(store, parts->first, {waypoints_term(store, parts->first.way)});
  std::vector<Term> all = store.items(first), beyond;
  for (const Vector3& point : parts->beyond) beyond.push_back(location_term(store, point));
  all.insert(all.end() - 1, headed(store, "beyond", std::move(beyond)));
  return store.list(all);
}

/// Where the sweep begins: the first of its way.
Value PlannerHost::Services::sweep_entry(TermStore& store, Arguments arguments) {
  const Value whole = call(entry_of(ask<&Services::sweep>), store, arguments);
  if (!whole || *whole == kNil) return whole;
  return location_term(store, way_of(store, *whole).front());
}

Value PlannerHost::Services::stay(TermStore& store, Arguments arguments) {
  const std::string word = text_of(store, arguments[0]);
  const bool stopped = word == "stopped", unlimited = word == "unlimited";
  const double seconds = number_of(store, arguments[0]).value_or(0);
  if (!stopped && !unlimited && seconds <= 0)
    return wrong(store, arguments[0], "positive number of seconds, `stopped` or `unlimited`");
  const Times times = waiting_times(seconds, gazetteer().knowledge().vehicle);
  const Term most =
      unlimited ? store.symbol("unlimited") : number_term(store, stopped ? 0 : times.most);
  std::vector<Term> params;
  if (unlimited) params.push_back(headed(store, "open-ended", {}));
  if (seconds > 0) params.push_back(headed(store, "duration", {number_term(store, seconds)}));
  const double energy = refinery_.ways.energy_of_stay(seconds);
  const std::vector<Term> all = {
      headed(store, "duration", {number_term(store, seconds), most}),
      headed(store, "energy", {number_term(store, energy)}),
      headed(store, "cost", {number_term(store, seconds > 0 ? times.expected : 0)}),
      headed(store, "params", std::move(params))};
  return store.list(all);
}

/// Of the devices the first that sees the place from so many sides, when it sets out then and stays
/// for SECONDS.
std::optional<PlannerHost::Services::Views> PlannerHost::Services::views(TermStore& store,
                                                                         Term where, Term devices,
                                                                         std::size_t count,
                                                                         Term when, Term seconds) {
  const auto at = names_.place(store, where);
  if (!at || !store.is_list(devices)) return std::nullopt;
  std::vector<std::string> why;
  for (const Term device : store.items(devices)) {
    const auto* sensor = gazetteer().sensor(text_of(store, device));
    if (sensor == nullptr) {
      why.push_back("no device '" + text_of(store, device) + "' on board");
      continue;
    }
    // A place in the air is flown to, and there are no sides of it.
    if (!gazetteer().on_ground(*at)) return Views{device, {*at}};
    auto found = refinery_.views.of(*at, *sensor, count, departure(store, when),
                                    number_of(store, seconds).value_or(0));
    if (found) return Views{device, std::move(*found)};
    why.push_back("nowhere to see " + Gazetteer::words(store, where) + " with " + sensor->device +
                  ": " + found.error());
  }
  for (const std::string& one : why) names_.refuse(one);
  return std::nullopt;
}

/// (compute-viewpoint PLACE DEVICES WHEN SECONDS): (DEVICE LOC).
Value PlannerHost::Services::viewpoint(TermStore& store, Arguments arguments) {
  const auto seen = views(store, arguments[0], arguments[1], 1, arguments[2], arguments[3]);
  if (!seen) return kNil;
  const std::vector<Term> pair = {seen->device, location_term(store, seen->points.front())};
  return store.list(pair);
}

/// (compute-meeting PLACE DEVICE ORDER SENDERS RECEIVERS WHEN): (LOC (LOC ROOM)…), where this UAV
/// waits for the others at the place, whose device sees it from there, and where they do, that look
/// with the first of the order that is theirs.
Value PlannerHost::Services::meeting(TermStore& store, Arguments arguments) {
  const auto at = names_.place(store, arguments[0]);
  if (!at) return kNil;
  MeetingPlaces::Devices devices{text_of(store, arguments[1]), {}};
  if (!store.is_list(arguments[2])) return wrong(store, arguments[2], "list of devices");
  for (const Term one : store.items(arguments[2])) devices.order.push_back(text_of(store, one));
  const auto found = refinery_.meetings.at(*at, relations_.who_meet(store, arguments.subspan(3, 2)),
                                           devices, departure(store, arguments[5]));
  if (!found)
    return names_.refuse("no place to meet at " + Gazetteer::words(store, arguments[0]) + " with " +
                         devices.own + ": " + found.error());
  std::vector<Term> all = {location_term(store, found->own.at)};
  for (const Spot& other : found->others) all.push_back(spot_term(store, other));
  return store.list(all);
}

/// (compute-angles PLACE DEVICES COUNT WHEN SECONDS): (DEVICE LOC…).
Value PlannerHost::Services::angles(TermStore& store, Arguments arguments) {
  const auto count = number_of(store, arguments[2]);
  if (!count || *count < 1 || *count > kMostSides)
    return wrong(store, arguments[2], "number from 1 to 16");
  const auto seen = views(store, arguments[0], arguments[1], static_cast<std::size_t>(*count),
                          arguments[3], arguments[4]);
  if (!seen) return kNil;
  std::vector<Term> all = {seen->device};
  for (const Vector3& point : seen->points) all.push_back(location_term(store, point));
  return store.list(all);
}

Value PlannerHost::Services::tour(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]);
  if (!store.is_list(arguments[1])) return wrong(store, arguments[1], "list of places");
  std::vector<supervisor::Views::Stop> stops;
  std::string names;
  bool known = from.has_value();
  for (const Term term : store.items(arguments[1])) {
    const auto at = names_.place(store, term);
    known = known && at;
    const std::string name = Gazetteer::words(store, term);
    if (at) stops.push_back({name, *at});
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!known) return kNil;
  if (stops.empty()) return names_.refuse("a tour of no places");
  const auto order = refinery_.views.tour(*from, stops);
  if (!order) return names_.refuse("no tour of " + names + ": " + order.error());
  return locations_term(store, *order);
}

}  // namespace skein::supervisor
