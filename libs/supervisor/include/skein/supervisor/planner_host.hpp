// SPDX-License-Identifier: Apache-2.0
// The host functions of the planning domain: calls of refiners, and names of the world.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "skein/htn/functions.hpp"
#include "skein/refiners/budget.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// The functions that docs/comets-domain.md lists (compute-gotoxyz, in-time, …), for plannings from
/// one origin. Answers of refiners are cached, and every refusal is kept in words. Airspaces are
/// built on demand. `budget` is that of each call of a refiner. Thread rule: one thread at a time.
class PlannerHost {
 public:
  PlannerHost(std::shared_ptr<const Knowledge> knowledge, std::shared_ptr<const world::World> world,
              MissionTime origin, std::uint64_t seed, refiners::Budget budget = {});
  ~PlannerHost();
  PlannerHost(const PlannerHost&) = delete;
  PlannerHost& operator=(const PlannerHost&) = delete;

  /// The UAV is passing `position` with that heading [rad]: motions that begin there within some
  /// seconds begin in flight, not at rest or on a circle.
  void flies_on(const world::Vector3& position, double heading);
  /// The UAV stands at `position` now: motions that begin there begin exactly there. Motions from
  /// other places on the ground begin where a landing ended.
  void stands_at(const world::Vector3& position);

  /// Registers the functions, which may outlive the host.
  void offer(htn::Functions& functions) const;
  /// Registers functions of the same names and arities that fail when called: for reading a domain
  /// without a world.
  static void declare(htn::Functions& functions);

  /// Forwards the functions of a domain to the host seated at it, so that one compiled domain
  /// serves one host after another. Thread rule: as PlannerHost.
  class Desk;

  /// A new planning begins: refusals() and refinements() are cleared, cached answers are kept. A
  /// cached refusal is reported again with the same words.
  void begin();
  /// Why refiners and name look-ups refused, since begin(): each sentence once, in order.
  const std::vector<std::string>& refusals() const;
  /// Calls of refiners since begin() whose answers were not cached.
  std::uint64_t refinements() const;

 private:
  class Services;
  std::shared_ptr<Services> services_;
};

class PlannerHost::Desk {
 public:
  Desk();
  /// Registers the functions, which may outlive the desk; while no host is seated they fail.
  void offer(htn::Functions& functions) const;
  void seat(const PlannerHost& host);
  void leave();

 private:
  struct Seat {
    std::shared_ptr<Services> taken;
  };
  std::shared_ptr<Seat> seat_;
};

}  // namespace skein::supervisor
