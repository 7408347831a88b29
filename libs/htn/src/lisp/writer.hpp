// SPDX-License-Identifier: Apache-2.0
// Emits the instructions of one unit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lisp/program.hpp"

namespace skein::htn::lisp {

/// Keeps count of the values on the stack, of locals, and of the blocks that may be left. Lifetime:
/// refers to its arguments.
class Writer {
 public:
  Writer(Program& program, const Document& document) : program_(program) {
    unit_.document = &document;
  }

  std::size_t emit(Op op, std::uint32_t operand = 0, std::uint32_t count = 0);
  void emit_constant(Term term);
  /// With the term, for messages.
  void emit_global(std::uint32_t global, Term term);
  void emit_function(std::string_view builtin, std::uint32_t count);
  /// Sets the target of the jump to the current position.
  void patch(std::size_t jump);
  std::uint32_t here() const { return static_cast<std::uint32_t>(unit_.code.size()); }
  /// Adds to the tracked stack height: at this point there are `by` more values than the preceding
  /// instructions imply.
  void raise(std::uint32_t by);
  /// Subtracts one from the tracked stack height, since the other branch pushed the value.
  void drop() { --height_; }

  std::uint32_t new_local() { return unit_.locals++; }
  /// Stores the value on top of the stack in the local.
  void set_hidden(std::uint32_t local);
  /// A local for the variable of the unit around this one.
  std::uint32_t capture(std::uint32_t outer_local);
  /// The parameters are the first locals. Precondition: there are none yet.
  void set_parameters(std::size_t required, std::size_t optional, bool rest);

  void begin_block(Term name) { blocks_.push_back({name, height_, {}}); }
  void end_block();
  /// Leaves a block with the value on top of the stack. False: there is no such block.
  bool leave_block(Term name);

  NodeIndex place() const { return place_; }
  /// Sets the source position of the next instructions.
  void set_place(NodeIndex at) { place_ = at; }
  Unit finish(std::string name);

 private:
  struct Block {
    Term name;
    std::uint32_t height = 0;
    std::vector<std::size_t> exits;
  };

  Program& program_;
  Unit unit_;
  std::vector<Block> blocks_;
  std::uint32_t height_ = 0;  ///< values above the locals at this point of the code
  NodeIndex place_ = kNoNode;
};

}  // namespace skein::htn::lisp
