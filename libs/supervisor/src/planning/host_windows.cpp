// SPDX-License-Identifier: Apache-2.0
// Functions of the host about air that is closed for a time: what can be flown then, and whether
// waiting leads further.
#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/host_services.hpp"
#include "planning/terms.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermStore;
using world::Vector3;

namespace {

using Value = Result<Term, Failure>;

constexpr double kRounding = 1e-6;  // [0.1 s]
constexpr double kAtOnce = 0.1;     // [s]

/// (NAME VALUE…) among the parts of an answer.
std::vector<Term> part_of(const TermStore& store, Term answer, std::string_view name) {
  if (!store.is_list(answer)) return {};
  for (const Term part : store.items(answer)) {
    if (!store.is_list(part)) continue;
    std::vector<Term> items = store.items(part);
    if (!items.empty() && text_of(store, items.front()) == name) return items;
  }
  return {};
}

}  // namespace

refiners::Way way_of(const TermStore& store, Term answer) {
  const std::vector<Term> params = part_of(store, answer, "params");
  return params.empty() ? refiners::Way{} : locations_of(store, params.back());
}

std::optional<Seconds> duration_of(const TermStore& store, Term answer) {
  const std::vector<Term> parts = part_of(store, answer, "duration");
  if (parts.size() != 3) return std::nullopt;
  const auto least = number_of(store, parts[1]), most = number_of(store, parts[2]);
  if (!least) return std::nullopt;
  return Seconds{*least, most.value_or(std::numeric_limits<double>::infinity())};
}

/// An interval; after the word `suited` at a moment of it that suits. Anything else is any time.
Departure departure(const TermStore& store, Term when) {
  const bool suited = store.is_list(when) && !store.items(when).empty() &&
                      text_of(store, store.items(when).front()) == "suited";
  const auto interval = seconds_of(store, suited ? store.items(when).back() : when);
  if (!interval) return {.suited = suited};
  return {interval->least, interval->most, suited};
}

/// Seconds to wait, rounded up; nil when there is no use in it.
Term PlannerHost::Services::waiting(TermStore& store, const Vector3& from, Term when,
                                    const Outlook::Venture& venture) {
  const auto seconds = refinery_.outlook.worth_waiting(from, departure(store, when), venture);
  return seconds ? number_term(store, std::ceil(*seconds * 10 - kRounding) / 10) : kNil;
}

/// (compute-wait FROM TO WHEN STAY): seconds to wait where it is until air that is closed for a
/// time is open again, when that is possible and leads there earlier than any way around; else nil.
/// It is to stay there for STAY seconds.
Value PlannerHost::Services::wait(TermStore& store, Arguments arguments) {
  if (!refinery_.air.has_windows()) return kNil;
  const auto from = names_.place(store, arguments[0]), to = names_.place(store, arguments[1]);
  if (!from || !to) return kNil;
  const Vector3 there = gazetteer().flown_to(*to);
  const double stay = number_of(store, arguments[3]).value_or(0);
  return waiting(store, *from, arguments[2], [&](const Departure& when) {
    return refinery_.outlook.of_way(*from, there, stay, when);
  });
}

/// (compute-wait-for-patrol FROM PLACE ZONE DEVICE SECONDS WHEN): likewise, for who goes to PLACE
/// and from there has the zone in sight.
Value PlannerHost::Services::wait_for_patrol(TermStore& store, Arguments arguments) {
  if (!refinery_.air.has_windows()) return kNil;
  const auto from = names_.place(store, arguments[0]), to = names_.place(store, arguments[1]);
  const world::Zone* zone = gazetteer().zone(text_of(store, arguments[2]));
  const auto* device = gazetteer().sensor(text_of(store, arguments[3]));
  const auto seconds = number_of(store, arguments[4]);
  if (!from || !to || zone == nullptr || device == nullptr || !seconds) return kNil;
  const Vector3 there = gazetteer().flown_to(*to);
  return waiting(store, *from, arguments[5], [&](const Departure& when) {
    return refinery_.outlook.of_patrol(*from, there, *zone, *device, *seconds, when);
  });
}

/// (compute-wait-for-sweep FROM ZONE DEVICE WHEN): likewise, or until more of the zone can be seen.
Value PlannerHost::Services::wait_for_sweep(TermStore& store, Arguments arguments) {
  if (!refinery_.air.has_windows()) return kNil;
  const auto from = names_.place(store, arguments[0]);
  const world::Zone* zone = gazetteer().zone(text_of(store, arguments[1]));
  const auto* device = gazetteer().sensor(text_of(store, arguments[2]));
  if (!from || zone == nullptr || device == nullptr) return kNil;
  return waiting(store, *from, arguments[3], [&](const Departure& when) {
    return refinery_.outlook.of_sweep(*from, *zone, *device, when);
  });
}

/// (compute-wait-for-rest FROM ZONE DEVICE BEFORE (LOC…) WHEN): likewise, for what is left of one.
Value PlannerHost::Services::wait_for_rest(TermStore& store, Arguments arguments) {
  if (!refinery_.air.has_windows()) return kNil;
  const auto from = names_.place(store, arguments[0]);
  const auto* device = gazetteer().sensor(text_of(store, arguments[2]));
  const auto* before = gazetteer().sensor(text_of(store, arguments[3]));
  const std::vector<Vector3> way = locations_of(store, arguments[4]);
  if (!from || device == nullptr || before == nullptr || way.size() < 2) return kNil;
  return waiting(store, *from, arguments[5], [&](const Departure& when) {
    return refinery_.outlook.of_rest(*from, way, *device, *before, when);
  });
}

/// (compute-next-opening WHEN): seconds until some volume that is closed for a time opens again;
/// nil: none does.
HostValue HostRelations::next_opening(TermStore& store, HostArguments arguments) {
  const double now = departure(store, arguments[0]).least;
  std::optional<double> next;
  for (const world::Volume& volume : gazetteer().world().volumes) {
    if (volume.when.until == MissionTime::max()) continue;
    const double opens = (volume.when.until - origin_).to_seconds() - now;
    if (opens > kAtOnce && (!next || opens < *next)) next = opens;
  }
  return next ? number_term(store, std::ceil(*next * 10 - kRounding) / 10) : kNil;
}

/// (within-reach FROM (LOC…) WHEN STAY): those that there is a way to, from the ground from above
/// it, at once or after a wait, and where it may stay for so many seconds then.
Value PlannerHost::Services::within_reach(TermStore& store, Arguments arguments) {
  const auto from = names_.place(store, arguments[0]);
  if (!from) return kNil;
  const Term start = location_term(store, gazetteer().flown_to(*from));
  const Departure when = departure(store, arguments[2]);
  const double stay = number_of(store, arguments[3]).value_or(0);
  std::vector<Term> there;
  for (const Vector3& at : locations_of(store, arguments[1])) {
    const std::vector<Term> leg = {start, location_term(store, at), arguments[2], arguments[3]};
    Value way = call(entry_of(ask<&Services::gotoxyz>), store, Arguments(leg).first(3));
    const auto times = way && *way != kNil ? duration_of(store, *way) : std::nullopt;
    const bool serves =
        times && (!refinery_.air.has_windows() ||
                  refinery_.air.may_stay(at, when.after({times->least, 0, times->most}), stay));
    const std::vector<Term> all_the_way = {arguments[0], leg[1], leg[2], leg[3]};
    if (way && !serves) way = wait(store, all_the_way);
    if (!way) return way;
    if (*way != kNil) there.push_back(leg[1]);
  }
  return store.list(there);
}

/// (is-open ANSWER WHEN): whether the way, begun then, meets no closed air.
Value PlannerHost::Services::is_open(TermStore& store, Arguments arguments) {
  if (!refinery_.air.has_windows()) return TermStore::boolean(true);
  return TermStore::boolean(
      refinery_.air.stays_open(way_of(store, arguments[0]), departure(store, arguments[1])));
}

/// (stays-open PLACE START DURATION): whether no air closes around who is there then for so long,
/// if that is known.
Value PlannerHost::Services::stays_open(TermStore& store, Arguments arguments) {
  if (!refinery_.air.has_windows()) return TermStore::boolean(true);
  const auto at = names_.place(store, arguments[0]);
  const auto duration = seconds_of(store, arguments[2]);
  if (!at || !duration) return kNil;
  if (std::isinf(duration->most)) return TermStore::boolean(true);
  if (refinery_.air.stays_open(*at, departure(store, arguments[1]), duration->most))
    return TermStore::boolean(true);
  return names_.refuse("the air at " + Gazetteer::words(store, arguments[0]) +
                       " closes before it is done there");
}

}  // namespace skein::supervisor
