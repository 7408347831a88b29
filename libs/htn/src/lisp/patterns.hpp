// SPDX-License-Identifier: Apache-2.0
// Lists of parameters, and patterns that take lists apart.
#pragma once

#include "lisp/compiler.hpp"

namespace skein::htn::lisp {

/// Emits the code that binds the variables of patterns. Lifetime: refers to the compiler.
class Patterns {
 public:
  explicit Patterns(Compiler& compiler)
      : compiler_(compiler),
        source_(compiler.source()),
        writer_(compiler.writer()),
        scope_(compiler.scope()) {}

  void parameters(NodeIndex list);
  /// Binds the pattern at this node to the value on top of the stack.
  void bind(NodeIndex at);

 private:
  void optional_parameter(NodeIndex at, std::uint32_t index);
  void list(NodeIndex at, std::uint32_t source);
  void optional_item(NodeIndex at, std::uint32_t source);
  void next_item(std::uint32_t source);
  void copy_local(std::uint32_t from, NodeIndex to);

  Compiler& compiler_;
  Source& source_;
  Writer& writer_;
  Scope& scope_;
};

}  // namespace skein::htn::lisp
