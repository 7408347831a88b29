// SPDX-License-Identifier: Apache-2.0
#include "lisp/machine.hpp"

#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::htn::lisp {

namespace {

constexpr std::size_t kStackLimit = std::size_t{1} << 18;
constexpr std::size_t kFrameLimit = 20'000;
constexpr int kNestingLimit = 100;
constexpr std::uint64_t kDefaultStepLimit = 5'000'000;

constexpr const char* kTooDeep = "too many calls inside each other, or too many arguments";

}  // namespace

Machine::Machine(Program& program) : program_(program), step_limit_(kDefaultStepLimit) {}

tl::expected<Term, LispError> Machine::evaluate(const Unit& unit, const SlotValue& slots) {
  start(slots);
  return finish(call_unit(unit, {}, kNil));
}

tl::expected<Term, LispError> Machine::apply(const Unit& function, Arguments arguments,
                                             const SlotValue& slots) {
  start(slots);
  const Outcome value = call_unit(function, {}, kNil);
  Outcome outcome = value ? call(*value, arguments) : value;
  if (!outcome && !where_) where_ = {function.document, function.code.front().place};
  return finish(std::move(outcome));
}

void Machine::start(const SlotValue& slots) {
  SKEIN_EXPECTS(frames_.empty());
  if (stack_.capacity() == 0) stack_.reserve(kStackLimit);  // many domains never evaluate anything
  slots_ = &slots;
  steps_ = 0;
  where_.reset();
}

// A function with boxes would outlive what it changes; no other value holds a kLocal.
tl::expected<Term, LispError> Machine::finish(Outcome outcome) {
  const bool escapes = outcome && (store().content(*outcome) & kHasLocal) != 0;
  stack_.clear();
  frames_.clear();
  boxes_.clear();
  nesting_ = 0;
  if (outcome && !escapes) return *outcome;
  std::string why = escapes ? "a function that changes variables cannot be a result"
                            : std::move(outcome.error().why);
  return tl::unexpected(LispError{std::move(why), where_.value_or(Expression{})});
}

bool Machine::fail(std::string why) {
  failure_ = std::move(why);
  return false;
}

bool Machine::charge(std::size_t steps) {
  steps_ += steps;
  return steps_ <= step_limit_;
}

// Runs until only `depth` frames are left; the value of the last one is on the stack.
bool Machine::run(std::size_t depth) {
  while (true) {
    Frame& frame = frames_.back();
    const Unit& unit = *frame.unit;
    const Instruction& instruction = unit.code[frame.pc];
    ++frame.pc;
    if (++steps_ > step_limit_ || !execute(instruction)) {
      if (steps_ > step_limit_) failure_ = kTooLong;
      if (!where_) where_ = {unit.document, instruction.place};
      return false;
    }
    if (frames_.size() == depth) return true;
  }
}

bool Machine::execute(const Instruction& instruction) {
  Frame& frame = frames_.back();
  switch (instruction.op) {
    case Op::kConstant:
      push(instruction.term);
      return true;
    case Op::kSlot:
      push((*slots_)(instruction.operand));
      return true;
    case Op::kLocal:
      push(local(instruction.operand));
      return true;
    case Op::kCall:
      return call_named(instruction.operand, instruction.count);
    case Op::kFuncall:
      return call_value(instruction.count);
    case Op::kReturn:
      leave();
      return true;
    case Op::kPop:
      stack_.pop_back();
      return true;
    case Op::kJump:
      frame.pc = instruction.operand;
      return true;
    case Op::kJumpIfNil:
      if (pop() == kNil) frame.pc = instruction.operand;
      return true;
    case Op::kJumpIfNilKeep:
    case Op::kJumpIfTrueKeep:
      if ((stack_.back() == kNil) == (instruction.op == Op::kJumpIfNilKeep)) {
        frame.pc = instruction.operand;
      } else {
        stack_.pop_back();
      }
      return true;
    case Op::kJumpIfGiven:
      if (frame.given > instruction.count) frame.pc = instruction.operand;
      return true;
    default:
      return execute_variable(instruction);
  }
}

bool Machine::execute_variable(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::kInstance:
      push(instance(instruction.term));
      break;
    case Op::kBoxed:
      push(boxes_[local(instruction.operand).index()]);
      break;
    case Op::kGlobal:
      return push_global(instruction);
    case Op::kSetGlobal:
      global_at(instruction.operand).value = stack_.back();
      break;
    case Op::kSetLocal:
      local(instruction.operand) = stack_.back();
      break;
    case Op::kSetBoxed:
      boxes_[local(instruction.operand).index()] = stack_.back();
      break;
    case Op::kBox:
      local(instruction.operand) = new_box(pop());
      break;
    case Op::kBoxLocal:
      local(instruction.operand) = new_box(local(instruction.operand));
      break;
    case Op::kSlide: {
      const Term value = pop();
      const Frame& frame = frames_.back();
      stack_.resize(frame.base + frame.unit->locals + instruction.operand);
      push(value);
      break;
    }
    case Op::kList:
      push(take_list(instruction.count, kNil));
      break;
    case Op::kListStar: {
      const Term tail = pop();
      push(take_list(instruction.count - 1, tail));
      break;
    }
    case Op::kClosure:
      push(closure(instruction.operand));
      break;
    default:
      SKEIN_ENSURES(false);
  }
  return true;
}

Machine::Global& Machine::global_at(std::uint32_t index) {
  if (globals_.size() <= index) globals_.resize(program_.globals().size());
  return globals_[index];
}

// Its first value is worked out when it is first asked for; one without a value is a symbol like
// any other.
bool Machine::push_global(const Instruction& instruction) {
  const std::uint32_t index = instruction.operand;
  const Term name = instruction.term;
  const auto& first = program_.globals()[index].first_value;
  if (!global_at(index).value && !global_at(index).begun && first) {
    global_at(index).begun = true;
    const Outcome value = call_unit(program_.unit(*first), {}, kNil);
    if (!value) return fail(value.error().why);
    if (!global_at(index).value) global_at(index).value = *value;
  }
  push(global_at(index).value.value_or(name));
  return true;
}

void Machine::begin() {
  globals_.clear();
  tables_.clear();
  arrays_.clear();
}

bool Machine::call_named(std::uint32_t index, std::uint32_t count) {
  const Callable& callable = program_.callable(index);
  if (callable.builtin == nullptr && callable.host == nullptr) {
    SKEIN_ENSURES(callable.unit != nullptr);
    return enter(*callable.unit, count, kNil);
  }
  Outcome outcome = call_directly(callable, top(count));
  if (!outcome) return fail(std::move(outcome.error().why));
  stack_.resize(stack_.size() - count);
  push(*outcome);
  return true;
}

bool Machine::call_value(std::uint32_t count) {
  const auto found = target(stack_[stack_.size() - count - 1]);
  if (!found) return fail(found.error().why);
  if (found->unit != nullptr) {
    if (!enter(*found->unit, count, found->captured)) return false;
    // The function value stays below the frame: the frame takes its place as well.
    Frame& frame = frames_.back();
    stack_.erase(stack_.begin() + frame.base - 1);
    --frame.base;
    return true;
  }
  Outcome outcome = call_directly(*found->callable, top(count));
  if (!outcome) return fail(std::move(outcome.error().why));
  stack_.resize(stack_.size() - count - 1);
  push(*outcome);
  return true;
}

// Built-in functions and those of the host.
Outcome Machine::call_directly(const Callable& callable, Arguments arguments) {
  if (callable.host != nullptr) {
    if (arguments.size() < callable.host->least_arguments ||
        arguments.size() > callable.host->most_arguments) {
      return failure("'" + callable.name + "' takes " +
                     count_text(callable.host->least_arguments, callable.host->most_arguments));
    }
    return callable.host->function(store(), arguments);
  }
  const Builtin& builtin = *callable.builtin;
  if (arguments.size() < builtin.least || arguments.size() > builtin.most) {
    return failure("'" + callable.name + "' takes " + count_text(builtin.least, builtin.most));
  }
  Outcome outcome = builtin.function(*this, arguments);
  if (!outcome && !builtin.own_words) outcome.error().why.insert(0, "'" + callable.name + "': ");
  return outcome;
}

Outcome Machine::call_unit(const Unit& unit, Arguments arguments, Term captured) {
  if (stack_.size() + arguments.size() > kStackLimit) return failure(kTooDeep);
  const std::size_t depth = frames_.size();
  for (const Term argument : arguments) push(argument);
  if (!enter(unit, static_cast<std::uint32_t>(arguments.size()), captured) || !run(depth)) {
    return failure(std::move(failure_));
  }
  return pop();
}

Outcome Machine::call(Term function, Arguments arguments) {
  if (!charge(1)) return failure(kTooLong);
  const auto found = target(function);
  if (!found) return tl::unexpected(found.error());
  if (nesting_ >= kNestingLimit) return failure(kTooDeep);
  ++nesting_;
  Outcome outcome = found->unit != nullptr ? call_unit(*found->unit, arguments, found->captured)
                                           : call_directly(*found->callable, arguments);
  --nesting_;
  return outcome;
}

// A function of the files that only its quoted name leads to is compiled now.
Result<Machine::Target, Failure> Machine::target(Term function) {
  Target found;
  const bool with_values = function.is(TermKind::kPair);
  const auto unit = program_.unit_of(with_values ? store().car(function) : function);
  if (unit) {
    found.unit = &program_.unit(*unit);
    if (with_values) found.captured = store().cdr(function);
    return found;
  }
  const auto index =
      function.is(TermKind::kSymbol) && function != kNil ? program_.find(function) : std::nullopt;
  if (!index) return failure(store().to_text(function) + " is not a function");
  found.callable = &program_.callable(*index);
  if (found.callable->definition != nullptr && found.callable->unit == nullptr) {
    Diagnostics errors;
    program_.want(*index);
    program_.compile_pending(errors);
    if (!errors.empty()) return failure(to_text(errors.all().front()));
  }
  found.unit = found.callable->unit;
  return found;
}

bool Machine::is_function(Term term) {
  return program_.unit_of(term.is(TermKind::kPair) ? store().car(term) : term).has_value();
}

bool Machine::enter(const Unit& unit, std::uint32_t count, Term captured) {
  if (unit.broken) return fail("function '" + unit.name + "' has errors");
  if (count < unit.least_arguments() || count > unit.most_arguments()) {
    return fail("'" + unit.name + "' takes " +
                count_text(unit.least_arguments(), unit.most_arguments()) + ", got " +
                std::to_string(count));
  }
  if (frames_.size() >= kFrameLimit ||
      stack_.size() + unit.locals + unit.height + 1 > kStackLimit) {
    return fail(kTooDeep);
  }
  const auto base = static_cast<std::uint32_t>(stack_.size() - count);
  place_arguments(unit, count);
  stack_.resize(base + unit.locals);
  for (const Capture& capture : unit.captures) {
    stack_[base + capture.inner] = store().car(captured);
    captured = store().cdr(captured);
  }
  frames_.push_back({&unit, 0, base, count});
  return true;
}

// What is not given is nil; what is more than the named parameters becomes the list of the rest.
void Machine::place_arguments(const Unit& unit, std::uint32_t count) {
  const std::uint32_t named = unit.required + unit.optional;
  if (!unit.rest) return;
  const Term rest = count > named ? take_list(count - named, kNil) : kNil;
  for (std::uint32_t missing = count; missing < named; ++missing) push(kNil);
  push(rest);
}

void Machine::leave() {
  const Term result = pop();
  stack_.resize(frames_.back().base);
  frames_.pop_back();
  push(result);
}

Term Machine::take_list(std::uint32_t count, Term tail) {
  const Term list = store().list(top(count), tail);
  stack_.resize(stack_.size() - count);
  return list;
}

Term Machine::new_box(Term value) {
  const Term box(TermKind::kLocal, static_cast<std::uint32_t>(boxes_.size()));
  boxes_.push_back(value);
  return box;
}

Term Machine::closure(std::uint32_t index) {
  const Unit& unit = program_.unit(index);
  const Term object = program_.function_object(index);
  if (unit.captures.empty()) return object;
  Term values = kNil;
  for (auto at = unit.captures.rbegin(); at != unit.captures.rend(); ++at) {
    values = store().pair(local(at->outer), values);
  }
  return store().pair(object, values);
}

// An explicit stack, as terms may be deep: the finished items of each list that is open.
Term Machine::instance(Term pattern) {
  struct Open {
    std::vector<Term> items;
    Term rest;
  };
  std::vector<Open> open;
  Term done;
  const auto slots_inside = [&](Term term) { return (store().content(term) & kHasSlot) != 0; };
  while (true) {
    if (pattern.is(TermKind::kPair) && slots_inside(pattern)) {
      open.push_back({{}, store().cdr(pattern)});
      pattern = store().car(pattern);
      continue;
    }
    done = pattern.is(TermKind::kSlot) ? (*slots_)(pattern.index()) : pattern;
    while (!open.empty()) {
      Open& last = open.back();
      last.items.push_back(done);
      if (last.rest.is(TermKind::kPair) && slots_inside(last.rest)) break;
      const Term tail = last.rest.is(TermKind::kSlot) ? (*slots_)(last.rest.index()) : last.rest;
      done = store().list(last.items, tail);
      open.pop_back();
    }
    if (open.empty()) return done;
    pattern = store().car(open.back().rest);
    open.back().rest = store().cdr(open.back().rest);
  }
}

}  // namespace skein::htn::lisp
