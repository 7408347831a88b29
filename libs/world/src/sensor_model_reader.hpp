// SPDX-License-Identifier: Apache-2.0
// The sensors of model files.
#pragma once

#include <string>

#include "skein/config/reader.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::world {

/// Reads one entry of `sensors`; errors go to the reader's diagnostics.
SensorModel read_sensor(const std::string& device, const config::Reader& reader);

}  // namespace skein::world
