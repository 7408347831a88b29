// SPDX-License-Identifier: Apache-2.0
// Why nothing came.
#pragma once

#include <string>
#include <vector>

#include "graph.hpp"
#include "skein/spy_tool/spy.hpp"

namespace skein::spy_tool {

struct Silence {
  enum class Cause : std::uint8_t {
    kNobody,    ///< nobody takes part in the domain
    kNoWriter,  ///< of what was asked for, in these partitions
    kRefused,   ///< DDS keeps the writers and us apart: type or QoS
    kSilent,    ///< there are writers, who write nothing
    kFiltered   ///< samples came; none was what was asked for
  };
  Cause cause = Cause::kNobody;
  std::string why;  ///< a sentence
};

/// `passed_over`: samples that came and were not what was asked for.
Silence silence_of(const SpyOptions& options, const Graph& graph, std::uint64_t passed_over);

/// "no writer", "QoS refused", …: what scripts may look for.
std::string_view name_of(Silence::Cause cause);

}  // namespace skein::spy_tool
