// SPDX-License-Identifier: Apache-2.0
#include "lisp/writer.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::htn::lisp {

namespace {

// How much higher the stack is after an instruction that takes `count` values.
int growth(Op op, std::uint32_t count) {
  switch (op) {
    case Op::kConstant:
    case Op::kInstance:
    case Op::kSlot:
    case Op::kLocal:
    case Op::kBoxed:
    case Op::kGlobal:
    case Op::kClosure:
      return 1;
    case Op::kBox:
    case Op::kPop:
    case Op::kJumpIfNil:
    case Op::kJumpIfNilKeep:
    case Op::kJumpIfTrueKeep:
      return -1;
    case Op::kList:
    case Op::kListStar:
    case Op::kCall:
      return 1 - static_cast<int>(count);
    case Op::kFuncall:
      return -static_cast<int>(count);
    default:
      return 0;
  }
}

}  // namespace

std::size_t Writer::emit(Op op, std::uint32_t operand, std::uint32_t count) {
  unit_.code.push_back({op, operand, count, kNil, place_});
  const int change = growth(op, count);
  SKEIN_ENSURES(static_cast<int>(height_) + change >= 0);
  if (change < 0) height_ -= static_cast<std::uint32_t>(-change);
  if (change > 0) raise(static_cast<std::uint32_t>(change));
  return unit_.code.size() - 1;
}

void Writer::raise(std::uint32_t by) {
  height_ += by;
  unit_.height = std::max(unit_.height, height_);
}

void Writer::emit_constant(Term term) {
  if (term.is(TermKind::kSlot)) {
    emit(Op::kSlot, term.index());
    return;
  }
  const bool with_slots = (program_.store().content(term) & kHasSlot) != 0;
  emit(with_slots ? Op::kInstance : Op::kConstant);
  unit_.code.back().term = term;
}

void Writer::emit_function(std::string_view builtin, std::uint32_t count) {
  const auto index = program_.find(program_.store().symbol(builtin));
  SKEIN_ENSURES(index.has_value());
  emit(Op::kCall, *index, count);
}

void Writer::patch(std::size_t jump) { unit_.code[jump].operand = here(); }

void Writer::emit_global(std::uint32_t global, Term term) {
  emit(Op::kGlobal, global);
  unit_.code.back().term = term;
}

void Writer::set_hidden(std::uint32_t local) {
  emit(Op::kSetLocal, local);
  emit(Op::kPop);
}

std::uint32_t Writer::capture(std::uint32_t outer_local) {
  const std::uint32_t inner = new_local();
  unit_.captures.push_back({outer_local, inner});
  return inner;
}

void Writer::set_parameters(std::size_t required, std::size_t optional, bool rest) {
  unit_.required = static_cast<std::uint32_t>(required);
  unit_.optional = static_cast<std::uint32_t>(optional);
  unit_.rest = rest;
  unit_.locals += unit_.required + unit_.optional + (rest ? 1 : 0);
}

void Writer::end_block() {
  for (const std::size_t exit : blocks_.back().exits) patch(exit);
  blocks_.pop_back();
}

bool Writer::leave_block(Term name) {
  for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) {
    if (block->name != name) continue;
    emit(Op::kSlide, block->height);
    block->exits.push_back(emit(Op::kJump));
    return true;
  }
  return false;
}

Unit Writer::finish(std::string name) {
  emit(Op::kReturn);
  unit_.name = std::move(name);
  return std::move(unit_);
}

}  // namespace skein::htn::lisp
