// SPDX-License-Identifier: Apache-2.0
// What the compiler of Lisp terms makes and the machine runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/functions.hpp"

namespace skein::htn::lisp {

class Machine;

using Arguments = std::span<const Term>;
using Outcome = Result<Term, Failure>;

/// A function of the language. Its failures do not repeat its name, unless `own_words`.
struct Builtin {
  using Function = Outcome (*)(Machine&, Arguments);
  std::string_view name;
  std::size_t least = 0;
  std::size_t most = 0;
  Function function = nullptr;
  bool own_words = false;
};
inline constexpr std::size_t kAnyCount = std::numeric_limits<std::size_t>::max();

/// Instructions of a stack machine. A frame has numbered locals; values are pushed above them.
enum class Op : std::uint8_t {
  kConstant,        ///< push `term`
  kInstance,        ///< push `term` with its slots replaced by their values
  kSlot,            ///< push the value of slot `operand`
  kLocal,           ///< push local `operand`
  kBoxed,           ///< push what the box in local `operand` holds
  kSetLocal,        ///< local `operand` = top, which stays
  kSetBoxed,        ///< box in local `operand` = top, which stays
  kBox,             ///< local `operand` = a new box that holds the popped top
  kBoxLocal,        ///< local `operand` = a new box that holds what it held
  kGlobal,          ///< push global variable `operand`; if it has no value, the symbol `term`
  kSetGlobal,       ///< global variable `operand` = top, which stays
  kPop,             ///< drop the top
  kSlide,           ///< drop what lies between height `operand` of the frame and the top
  kJump,            ///< to `operand`
  kJumpIfNil,       ///< pops
  kJumpIfNilKeep,   ///< jumps with the top; else pops it
  kJumpIfTrueKeep,  ///< jumps with the top; else pops it
  kJumpIfGiven,     ///< to `operand` when the call gave more than `count` arguments
  kList,            ///< `count` values become a list
  kListStar,        ///< `count` values become a list, the last is its tail
  kCall,            ///< function `operand` with `count` arguments
  kFuncall,         ///< the function below `count` arguments
  kClosure,         ///< function made of unit `operand` and the locals it captures
  kReturn
};

struct Instruction {
  Op op = Op::kReturn;
  std::uint32_t operand = 0;
  std::uint32_t count = 0;
  Term term;
  NodeIndex place = kNoNode;  ///< in the document of the unit
};

/// A local of the surrounding frame that a lambda uses, and its place in the lambda's frame.
struct Capture {
  std::uint32_t outer = 0;
  std::uint32_t inner = 0;
};

/// Code of one expression, function or lambda.
struct Unit {
  std::string name;
  const Document* document = nullptr;
  std::vector<Instruction> code;
  std::vector<Capture> captures;
  std::uint32_t required = 0;  ///< parameters are the first locals: required, optional, rest
  std::uint32_t optional = 0;
  bool rest = false;
  bool broken = false;  ///< could not be compiled
  std::uint32_t locals = 0;
  std::uint32_t height = 0;  ///< most values above the locals

  std::size_t least_arguments() const { return required; }
  std::size_t most_arguments() const { return rest ? kAnyCount : std::size_t{required} + optional; }
};

/// Something that can be called by name: exactly one pointer is set.
struct Callable {
  std::string name;
  const Builtin* builtin = nullptr;
  const Functions::Entry* host = nullptr;
  const FunctionDefinition* definition = nullptr;
  Unit* unit = nullptr;  ///< of a definition, once it is compiled
};

struct ArgumentCount {
  std::size_t least = 0;
  std::size_t most = 0;
};
/// As the parameter list of a function of the files says; anything when that is malformed.
ArgumentCount argument_count(const TermStore& store, const FunctionDefinition& definition);

/// "2 arguments", "1 to 3 arguments", "at least 1 argument".
std::string count_text(std::size_t least, std::size_t most);

}  // namespace skein::htn::lisp
