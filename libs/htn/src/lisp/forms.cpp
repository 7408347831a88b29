// SPDX-License-Identifier: Apache-2.0
#include "lisp/forms.hpp"

#include <map>

namespace skein::htn::lisp {

namespace {

template <class Forms>
Forms forms_of(void (Forms::*)(NodeIndex, Parts), Compiler& compiler) {
  return Forms(compiler);
}

/// A method of a class of forms as a plain function.
template <auto kForm>
void with(Compiler& compiler, NodeIndex form, Parts parts) {
  (forms_of(kForm, compiler).*kForm)(form, parts);
}

}  // namespace

const Form* find_form(std::string_view name) {
  static const std::map<std::string_view, Form> kForms{
      {"and", {&with<&ControlForms::and_form>, 0, kAnyCount}},
      {"backquote", {&with<&DataForms::backquote_form>, 1, 1}},
      {"block", {&with<&ControlForms::block_form>, 1, kAnyCount}},
      {"call", {&with<&DataForms::call_form>, 1, kAnyCount}},
      {"case", {&with<&ControlForms::case_form>, 1, kAnyCount}},
      {"cond", {&with<&ControlForms::cond_form>, 0, kAnyCount}},
      {"declare", {&with<&ControlForms::declare_form>, 0, kAnyCount}},
      {"decf", {&with<&PlaceForms::increment_form>, 1, 2}},
      {"destructuring-bind", {&with<&BindingForms::destructuring_form>, 2, kAnyCount}},
      {"do", {&with<&BindingForms::do_form>, 2, kAnyCount}},
      {"do*", {&with<&BindingForms::do_form>, 2, kAnyCount}},
      {"dolist", {&with<&BindingForms::dolist_form>, 1, kAnyCount}},
      {"dotimes", {&with<&BindingForms::dotimes_form>, 1, kAnyCount}},
      {"ecase", {&with<&ControlForms::case_form>, 1, kAnyCount}},
      {"eval", {&with<&DataForms::eval_form>, 1, 1}},
      {"funcall", {&with<&DataForms::funcall_form>, 1, kAnyCount}},
      {"function", {&with<&DataForms::function_form>, 1, 1}},
      {"if", {&with<&ControlForms::if_form>, 2, 3}},
      {"incf", {&with<&PlaceForms::increment_form>, 1, 2}},
      {"lambda", {&with<&DataForms::lambda_form>, 1, kAnyCount}},
      {"let", {&with<&BindingForms::let_form>, 1, kAnyCount}},
      {"let*", {&with<&BindingForms::let_star_form>, 1, kAnyCount}},
      {"or", {&with<&ControlForms::or_form>, 0, kAnyCount}},
      {"pop", {&with<&PlaceForms::pop_form>, 1, 1}},
      {"prog1", {&with<&ControlForms::prog1_form>, 1, kAnyCount}},
      {"progn", {&with<&ControlForms::progn_form>, 0, kAnyCount}},
      {"push", {&with<&PlaceForms::push_form>, 2, 2}},
      {"pushnew", {&with<&PlaceForms::push_form>, 2, 2}},
      {"quote", {&with<&DataForms::quote_form>, 1, 1}},
      {"return", {&with<&ControlForms::return_form>, 0, 1}},
      {"return-from", {&with<&ControlForms::return_from_form>, 1, 2}},
      {"setf", {&with<&PlaceForms::set_form>, 0, kAnyCount}},
      {"setq", {&with<&PlaceForms::set_form>, 0, kAnyCount}},
      {"the", {&with<&ControlForms::the_form>, 2, 2}},
      {"unless", {&with<&ControlForms::when_form>, 1, kAnyCount}},
      {"when", {&with<&ControlForms::when_form>, 1, kAnyCount}},
  };
  const auto at = kForms.find(name);
  return at == kForms.end() ? nullptr : &at->second;
}

std::vector<std::string> form_names() {
  return {"and",    "case",    "cond",        "destructuring-bind",
          "dolist", "dotimes", "eval",        "if",
          "incf",   "lambda",  "let",         "let*",
          "or",     "prog1",   "progn",       "push",
          "do",     "quote",   "return-from", "return",
          "setq",   "unless",  "when",        "funcall",
          "decf"};
}

}  // namespace skein::htn::lisp
