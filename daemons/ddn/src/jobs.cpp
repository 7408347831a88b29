// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn/jobs.hpp"

#include <any>
#include <utility>
#include <vector>

#include "skein/supervisor/area_sweep.hpp"

namespace skein::ddn {

namespace {

namespace dn = decision_node;

using Rows = Result<interaction::Rows, Failure>;
using Detours = std::vector<supervisor::Detour>;
using Path = std::optional<refiners::Path>;

/// Those of the supervisor come before.
constexpr std::uint64_t kFirstReckoning = std::uint64_t{1} << 32U;
constexpr std::uint64_t kFirstDetours = std::uint64_t{1} << 48U;
constexpr std::uint64_t kFirstWaySearch = std::uint64_t{1} << 56U;

/// Of a job that plans detours, with a real clock: more of them wait for the next one.
constexpr Duration kDetours = Duration::milliseconds(250);

std::optional<double> seconds_of(const auto& sweeper, const auto& part, const world::World& ground) {
  return supervisor::seconds_of_sweep(
      {sweeper.vehicle, sweeper.altitude, sweeper.swath, sweeper.start}, part,
      std::make_shared<const world::World>(ground));
}

}  // namespace

// It has all the time it needs: members whose clocks cut it short would reckon other results.
node::StartJob Jobs::effect_of(const dn::StartReckoning& asked) const {
  const auto work = [terms = asked.terms,
                     offers = asked.offers](const node::TimeIsUp& is_unwanted) -> std::any {
    if (is_unwanted && is_unwanted()) return Rows(failure("nobody wants it any more"));
    return interaction::reckon(terms, offers,
                               [](const auto& sweeper, const auto& part, const auto& ground) {
                                 return seconds_of(sweeper, part, ground);
                               });
  };
  return {kFirstReckoning + asked.job, work};
}

node::StopJob Jobs::effect_of(const dn::StopReckoning& asked) const {
  return {kFirstReckoning + asked.job};
}

// No plan or repair waits for what only bids are made of.
node::StartJob Jobs::effect_of(const dn::StartDetours& asked) const {
  const auto work = [request = asked.request](const node::TimeIsUp& time_is_up) -> std::any {
    return supervisor::plan_detours(request, time_is_up);
  };
  return {kFirstDetours + asked.job, work, kDetours, true};
}

node::StartJob Jobs::effect_of(const dn::StartWaySearch& asked) const {
  const auto work = [search = asked.search](const node::TimeIsUp& is_unwanted) -> std::any {
    return dn::search_way(search, is_unwanted);
  };
  return {kFirstWaySearch + asked.job, work, Duration::max(), true};
}

node::StartJob Jobs::effect_of(const supervisor::StartDeliberation& asked) const {
  const auto work = [deliberator = deliberator_,
                     request = asked.request](const node::TimeIsUp& time_is_up) -> std::any {
    return deliberator->deliberate(*request, time_is_up);
  };
  return {asked.job, work, deliberation_};
}

node::StopJob Jobs::effect_of(const supervisor::StopDeliberation& asked) const {
  return {asked.job};
}

std::optional<dn::Input> Jobs::input_of(const node::JobDone& done) {
  if (const auto* plan = std::any_cast<supervisor::DeliberationResult>(&done.result))
    return supervisor::JobFinished{done.id, *plan};
  if (const auto* rows = std::any_cast<Rows>(&done.result))
    return dn::ReckoningFinished{done.id - kFirstReckoning, *rows};
  if (const auto* detours = std::any_cast<Detours>(&done.result))
    return dn::DetoursPlanned{done.id - kFirstDetours, *detours};
  if (const auto* path = std::any_cast<Path>(&done.result))
    return dn::WaySearched{done.id - kFirstWaySearch, *path};
  return std::nullopt;
}

}  // namespace skein::ddn
