// SPDX-License-Identifier: Apache-2.0
// Model files (YAML) of vehicles.
#pragma once

#include <string>
#include <string_view>

#include "skein/config/reader.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::world {

/// Reads one vehicle model. `file` is only the name used in diagnostics. Unknown and repeated keys,
/// missing keys, wrong types, figures out of range and figures that contradict each other are
/// errors; all of them are returned at once. The format is in scenarios/comets/models and the
/// README.
Result<VehicleModel, Diagnostics> read_vehicle_model(std::string_view text,
                                                     const std::string& file);

/// The same of a model inside another document. What is wrong goes to the reader's diagnostics, and
/// something harmless is given in its place.
VehicleModel read_vehicle_model(const config::Reader& reader);

/// Adds the figures of a map to those that the model declares, or puts them in their place. What
/// follows from the rest of a model cannot be declared.
void read_abilities(const config::Reader& reader, VehicleModel& model);

}  // namespace skein::world
