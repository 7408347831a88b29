// SPDX-License-Identifier: Apache-2.0
// The radio, as world files and scenarios describe it.
#pragma once

#include "skein/config/reader.hpp"
#include "skein/world/radio_model.hpp"

// Each reports what is wrong to the reader's diagnostics and then gives something harmless.
namespace skein::world {

/// The figures of a radio; keys that are none of its own are not reported.
RadioModel read_radio_figures(const config::Reader& reader);

/// {range, line_of_sight, latency, loss, capacity, hysteresis}, or instead of `range` a link budget
/// {power, sensitivity, reference_loss, exponent}; absent: 10 km in sight. `others`: keys of the
/// same map that the caller reads.
template <class... Text>
RadioModel read_radio(const config::Reader& reader, const Text*... others) {
  reader.keys({"range", "power", "sensitivity", "reference_loss", "exponent", "line_of_sight",
               "latency", "loss", "capacity", "hysteresis", others...});
  return read_radio_figures(reader);
}

}  // namespace skein::world
