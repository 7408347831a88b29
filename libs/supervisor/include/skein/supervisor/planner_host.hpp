// SPDX-License-Identifier: Apache-2.0
// What the planning domain asks of its host: refiners, and the names of the world.
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
/// one origin: what was refined once is not refined again, and every refusal is kept in words. The
/// airspace is built at the first way that is asked for; volumes that are closed for a time only
/// count all along. `budget` is that of each call of a refiner. Thread rule: one thread at a time.
class PlannerHost {
 public:
  PlannerHost(std::shared_ptr<const Knowledge> knowledge, std::shared_ptr<const world::World> world,
              MissionTime origin, std::uint64_t seed, refiners::Budget budget = {});
  ~PlannerHost();
  PlannerHost(const PlannerHost&) = delete;
  PlannerHost& operator=(const PlannerHost&) = delete;

  /// What begins at `position` begins in flight, with that heading [rad], up to some seconds later.
  void flies_on(const world::Vector3& position, double heading);
  /// What begins at `position` begins there, on the ground; elsewhere, where a landing ended.
  void stands_at(const world::Vector3& position);

  /// The functions may outlive the host.
  void offer(htn::Functions& functions) const;
  /// The same names and numbers of arguments, for reading a domain where there is no world: called,
  /// they fail.
  static void declare(htn::Functions& functions);

  /// Gives a domain the functions of whichever host sits at it, so that one compiled domain serves
  /// hosts one after another. Thread rule: as a host.
  class Desk;

  /// The next planning begins: from here on refusals and refinements count. What was refined before
  /// is known; what was refused then is refused again with the same words.
  void begin();
  /// Each once, in the order they came.
  const std::vector<std::string>& refusals() const;
  /// Calls of refiners that were not known from before.
  std::uint64_t refinements() const;

 private:
  class Services;
  std::shared_ptr<Services> services_;
};

class PlannerHost::Desk {
 public:
  Desk();
  /// The functions may outlive the desk; while nobody sits at it they fail.
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
