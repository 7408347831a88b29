// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the reading of a vehicle model.
#include <cstdint>
#include <string_view>

#include "skein/foundation/contract.hpp"
#include "skein/world/vehicle_model_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto model = skein::world::read_vehicle_model(text, "fuzz");
  SKEIN_ENSURES(model.has_value() || !model.error().empty());
  return 0;
}
