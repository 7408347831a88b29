// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/lisp.hpp"

#include "lisp/compiler.hpp"
#include "lisp/machine.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::htn {

class Lisp::Implementation {
 public:
  Implementation(TermStore& store, const Functions& host,
                 const std::vector<FunctionDefinition>& defined)
      : program(store, host, defined), machine(program) {}

  using Part = void (lisp::Compiler::*)(NodeIndex);

  CodeIndex compile(Part part, Expression expression, const SlotOf& slot_of, Diagnostics& errors) {
    SKEIN_EXPECTS(expression.document != nullptr && expression);
    const std::size_t before = errors.size();
    lisp::Compiler compiler(program, *expression.document, slot_of, errors);
    (compiler.*part)(expression.node);
    lisp::Unit unit = compiler.finish({});
    program.compile_pending(errors);
    return errors.size() == before ? program.add_unit(std::move(unit)) : kNoCode;
  }

  const lisp::Unit& unit(CodeIndex code) {
    SKEIN_EXPECTS(code < program.unit_count());
    return program.unit(code);
  }

  lisp::Program program;
  lisp::Machine machine;
};

Lisp::Lisp(TermStore& store, const Functions& host, const std::vector<FunctionDefinition>& defined)
    : implementation_(std::make_unique<Implementation>(store, host, defined)) {}

Lisp::~Lisp() = default;

CodeIndex Lisp::compile(Expression expression, const SlotOf& slot_of, Diagnostics& errors) {
  return implementation_->compile(&lisp::Compiler::expression, expression, slot_of, errors);
}

CodeIndex Lisp::compile_call(Expression call, const SlotOf& slot_of, Diagnostics& errors) {
  return implementation_->compile(&lisp::Compiler::call, call, slot_of, errors);
}

CodeIndex Lisp::compile_template(Expression expression, const SlotOf& slot_of,
                                 Diagnostics& errors) {
  return implementation_->compile(&lisp::Compiler::task_template, expression, slot_of, errors);
}

CodeIndex Lisp::compile_function(Expression function, const SlotOf& slot_of, Diagnostics& errors) {
  return implementation_->compile(&lisp::Compiler::function, function, slot_of, errors);
}

void Lisp::begin() { implementation_->machine.begin(); }

void Lisp::limit_steps(std::uint64_t steps) { implementation_->machine.limit_steps(steps); }

tl::expected<Term, LispError> Lisp::evaluate(CodeIndex code, const SlotValue& slots) {
  return implementation_->machine.evaluate(implementation_->unit(code), slots);
}

tl::expected<Term, LispError> Lisp::apply(CodeIndex function, std::span<const Term> arguments,
                                          const SlotValue& slots) {
  return implementation_->machine.apply(implementation_->unit(function), arguments, slots);
}

}  // namespace skein::htn
