// SPDX-License-Identifier: Apache-2.0
#include "type_description.hpp"

#include <array>

namespace skein::blackboard::cyclonedds {
namespace {

#include "idl/types.inc"  // made by idl/generate.sh

#define SKEIN_DESCRIPTION(T) TypeDescription{k##T##_INFO, k##T##_MAP},
constexpr std::array kDescriptions{SKEIN_FOR_EACH_SLOT(SKEIN_DESCRIPTION)};
#undef SKEIN_DESCRIPTION
static_assert(kDescriptions.size() == wire::kSlotCount);

}  // namespace

TypeDescription describe(wire::Slot slot) { return kDescriptions[static_cast<std::size_t>(slot)]; }

}  // namespace skein::blackboard::cyclonedds
