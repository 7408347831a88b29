// SPDX-License-Identifier: Apache-2.0
// skein-refine: `skein refine` and `skein terrain`, apart because they load libraries of maps and
// motion planning that no other command needs. `skein` starts it.
#include "actions.hpp"
#include "commands.hpp"
#include "on_streams.hpp"
#include "skein/refine_tool/refine.hpp"
#include "skein/supervisor/area_sweep.hpp"
#include "skein/terrain_tool/terrain.hpp"

namespace {

/// Parts of an area take what a UAV's own mapping of them does.
int run_refine(const skein::refine_tool::RefineOptions& options, std::istream& in,
               std::ostream& out, std::ostream& err) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the function is short
  refine_tool::RefineOptions with_flights = options;
  with_flights.flown = [](const refiners::Member& member, double altitude,
                          const world::Polygon& part,
                          const std::shared_ptr<const world::World>& world) {
    return supervisor::seconds_of_sweep({member.vehicle, altitude, member.swath, member.start},
                                        part, world, supervisor::Sweeping::kOwn);
  };
  return refine_tool::run_refine(with_flights, in, out, err);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions(cli::start_skein_instead);
  actions.add(cli::on_streams(run_refine));
  actions.add(cli::on_streams(terrain_tool::make_terrain));
  actions.add(cli::on_streams(terrain_tool::show_terrain));
  return cli::run_command_line(argc, argv, actions);
}
