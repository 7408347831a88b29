// SPDX-License-Identifier: Apache-2.0
#include "mission_host.hpp"

#include <variant>

#include "file_text.hpp"
#include "skein/world/vehicle_model_reader.hpp"
#include "skein/world/world_builder.hpp"
#include "skein/world/world_reader.hpp"

namespace skein::plan_tool {

namespace {

std::string text_in(const std::string& file, std::istream& in, Diagnostics& errors) {
  auto text = text_of_file(file, in);
  if (text) return std::move(*text);
  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.message = text.error().why;
  errors.add(diagnostic);
  return {};
}

/// What only `skein refine` and the decision node resolve.
bool has_raster(const world::WorldFile& file, Diagnostics& errors) {
  const auto refuse = [&](const world::Mark& mark) {
    errors.add({file.file, mark.line, 0, mark.path, "a raster, which is not read here",
                "a world whose terrain and risk are in its file", ""});
  };
  const std::size_t before = errors.size();
  if (const auto* terrain = std::get_if<world::RasterTerrain>(&file.terrain))
    refuse(terrain->raster.mark);
  if (const auto* risk = std::get_if<world::RasterSource>(&file.ground.risk)) refuse(risk->mark);
  return errors.size() > before;
}

}  // namespace

std::shared_ptr<const supervisor::Knowledge> knowledge_of(const MissionFiles& files,
                                                          std::istream& in, Diagnostics& errors) {
  if (files.vehicle.empty()) return nullptr;
  const std::size_t before = errors.size();
  const std::string text = text_in(files.vehicle, in, errors);
  if (errors.size() > before) return nullptr;
  auto vehicle = world::read_vehicle_model(text, files.vehicle);
  if (!vehicle) {
    errors.append(vehicle.error());
    return nullptr;
  }
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = files.uav.empty() ? vehicle->name : files.uav;
  knowledge->team = {knowledge->uav};
  knowledge->vehicle = std::move(*vehicle);
  knowledge->altitude = files.altitude;
  knowledge->home = world::Vector3(files.home[0], files.home[1], files.home[2]);
  return knowledge;
}

std::shared_ptr<const world::World> world_of(const MissionFiles& files, std::istream& in,
                                             Diagnostics& errors) {
  if (files.world.empty()) return nullptr;
  const std::size_t before = errors.size();
  const std::string text = text_in(files.world, in, errors);
  if (errors.size() > before) return nullptr;
  auto file = world::read_world_file(text, files.world);
  if (!file) {
    errors.append(file.error());
    return nullptr;
  }
  if (has_raster(*file, errors)) return nullptr;
  auto world = world::build_world(std::move(*file));
  if (world) return std::make_shared<const world::World>(std::move(*world));
  errors.append(world.error());
  return nullptr;
}

}  // namespace skein::plan_tool
