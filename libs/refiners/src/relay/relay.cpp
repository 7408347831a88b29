// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/relay.hpp"

#include <cmath>

#include "common/shared_checks.hpp"
#include "relay/space.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

using relay::Meter;
using relay::Space;
using world::Vector3;

constexpr std::size_t kMostRelays = 64;

std::optional<Refusal> check_end(const Vector3& end, const std::string& field,
                                 const world::Terrain& terrain) {
  if (auto problem = check_finite(end, field)) return problem;
  const double under = terrain.elevation(end.x(), end.y()) - end.z();
  if (under > 1e-6)
    return Refusal{RefusalKind::kBlocked, field, "it is " + rounded(under) + " m under the ground"};
  return std::nullopt;
}

std::optional<Refusal> check_relay(const RelayQuery& query, const world::World& world) {
  if (auto problem = check_vehicle(query.vehicle)) return problem;
  if (query.most < 1 || query.most > kMostRelays)
    return bad("most",
               std::to_string(query.most) + " relays: from 1 to " + std::to_string(kMostRelays));
  if (!(query.least_margin >= 0 && std::isfinite(query.least_margin)))
    return bad("least_margin", "a margin is a finite number of dB, at least 0");
  if (!(query.clearance >= 0 && std::isfinite(query.clearance)))
    return bad("clearance", "a height over the ground is a finite number of metres, at least 0");
  if (const auto problems = problems_of(world.radio); !problems.empty())
    return bad("world.radio", problems.front());
  if (const auto problems = problems_of(world.airspace); !problems.empty())
    return bad("world.airspace", problems.front());
  if (auto problem = check_end(query.a, "a", world.terrain)) return problem;
  return check_end(query.b, "b", world.terrain);
}

/// Why two ends that no chain joins do not hear each other.
Refusal no_contact(const RelayQuery& query, const Space& space) {
  const double apart = (query.a - query.b).norm(), link = space.longest_link();
  const double reach = link * static_cast<double>(query.most + 1);
  const std::string relays = std::to_string(query.most) + (query.most == 1 ? " relay" : " relays");
  const std::string links = "links of at most " + rounded(link) + " m";
  if (apart > reach)
    return {RefusalKind::kNoContact, "most",
            "they are " + rounded(apart) + " m apart; " + relays + " with " + links + " span " +
                rounded(reach) + " m, " + rounded(apart - reach) + " m too little"};
  return {RefusalKind::kNoContact, "",
          "they are " + rounded(apart) + " m apart, which " + relays + " with " + links +
              " could span, but the ground or the volumes leave no places that see each other"};
}

Refined<Relay> answer(Relay relay, const Meter& meter) {
  Refined<Relay> refined;
  refined.cost = static_cast<double>(relay.positions.size());
  refined.task = std::move(relay);
  refined.effort = meter.effort();
  return refined;
}

}  // namespace

Outcome<Relay> refine(const RelayQuery& query, const Setting& setting) {
  if (auto problem = check_relay(query, setting.world)) return tl::unexpected<Refusal>(*problem);
  Meter meter(setting.budget);
  const double voxel = setting.world.airspace.voxel;
  if (!meter.link())
    return refuse(RefusalKind::kBudgetExhausted, "", "there is no budget for a single link");
  const double direct = setting.world.radio.margin(query.a, query.b, setting.world.terrain);
  if (direct >= query.least_margin) return answer({{}, direct, voxel}, meter);

  const auto space = Space::in_time(query, setting.world, setting.budget);
  if (!space)
    return refuse(RefusalKind::kBudgetExhausted, "",
                  "the time was up before it was known which air is open");
  if (const auto place = relay::best_between(*space, query.a, query.b, meter))
    return answer({{place->position}, place->margin, voxel}, meter);
  if (!meter.over())
    if (auto chain = relay::best_chain(*space, query, meter))
      return answer({std::move(chain->positions), chain->margin, chain->spacing}, meter);
  if (meter.over())
    return refuse(RefusalKind::kBudgetExhausted, "",
                  "no relay was found in " + std::to_string(meter.effort().steps) + " links");
  return tl::unexpected<Refusal>(no_contact(query, *space));
}

}  // namespace skein::refiners
