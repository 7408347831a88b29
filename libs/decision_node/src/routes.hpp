// SPDX-License-Identifier: Apache-2.0
// Which component gets which request.
#pragma once

#include "skein/mission/request.hpp"

namespace skein::decision_node {

enum class Addressee { kExecution, kDeliberation, kAutonomy };

/// One row for each kind of request.
struct Route {
  mission::RequestKind kind;
  Addressee to;
  int least_degree;     ///< below it the request is refused
  const char* refusal;  ///< with this reason
};

const Route& route_of(mission::RequestKind kind);

}  // namespace skein::decision_node
