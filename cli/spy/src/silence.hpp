// SPDX-License-Identifier: Apache-2.0
// Diagnosis when no samples were received.
#pragma once

#include <string>
#include <vector>

#include "graph.hpp"
#include "skein/spy_tool/spy.hpp"

namespace skein::spy_tool {

struct Silence {
  enum class Cause : std::uint8_t {
    kNobody,    ///< no participants in the domain
    kNoWriter,  ///< no writer of the wanted topics in these partitions
    kRefused,   ///< DDS does not match the writers with the spy: type or QoS
    kSilent,    ///< there are writers, but they write nothing
    kFiltered   ///< samples arrived, but none matched the options
  };
  Cause cause = Cause::kNobody;
  std::string why;  ///< a sentence
};

/// `passed_over`: number of samples that did not match the options.
Silence silence_of(const SpyOptions& options, const Graph& graph, std::uint64_t passed_over);

/// "no writer", "QoS refused", …: what scripts may look for.
std::string_view name_of(Silence::Cause cause);

}  // namespace skein::spy_tool
