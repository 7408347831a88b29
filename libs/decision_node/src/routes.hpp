// SPDX-License-Identifier: Apache-2.0
// The table that routes requests to components.
#pragma once

#include "skein/mission/request.hpp"

namespace skein::decision_node {

enum class Addressee { kExecution, kDeliberation, kAutonomy };

/// One row for each kind of request.
struct Route {
  mission::RequestKind kind;
  Addressee to;
  int least_degree;     ///< below this degree the request is refused
  const char* refusal;  ///< the reason given then
};

const Route& route_of(mission::RequestKind kind);

}  // namespace skein::decision_node
