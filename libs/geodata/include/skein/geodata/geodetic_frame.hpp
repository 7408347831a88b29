// SPDX-License-Identifier: Apache-2.0
// Between places on Earth and the local ENU frame: see libs/geodesy.
#pragma once

#include "skein/geodesy/geodetic_frame.hpp"

namespace skein::geodata {

using geodesy::GeodeticFrame;

}  // namespace skein::geodata
