// SPDX-License-Identifier: Apache-2.0
// Task networks as written: of methods, and of problems.
#pragma once

#include "compile/condition_compiler.hpp"

namespace skein::htn {

/// The network of a method's branch: nodes, leaves, and the ways to force a first task.
void compile_network(Expression tasks, ConditionCompiler& compiler, CompiledDomain& domain,
                     ClauseScope& scope, Branch& branch);

/// The ways in which a reduction may begin: its first task becomes immediate; of tasks that are not
/// ordered each is first in one way; where one is immediate already there is nothing to force.
std::vector<Forcing> forcings(const std::vector<BodyNode>& body);

}  // namespace skein::htn
