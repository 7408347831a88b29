// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

// An s-expression as printed, nested as deep as the size allows.
rc::Gen<std::string> expression(int depth) {
  const auto atom = rc::gen::element<std::string>("a", "?x", "nil", "12", "-3", "1/3", "0.5", "!op",
                                                  ":key", "\"text\"", "\"q\\\"\"", "()", "and");
  if (depth == 0) return atom;
  const auto list =
      rc::gen::map(rc::gen::container<std::vector<std::string>>(expression(depth - 1)),
                   [](const std::vector<std::string>& items) {
                     std::string out = "(";
                     for (const std::string& item : items) {
                       out += (out.size() > 1 ? " " : "") + item;
                     }
                     return out + ")";
                   });
  return rc::gen::oneOf(atom, list);
}

RC_GTEST_PROP(ReadDocument, GivesBackWhatWasPrinted, ()) {
  const std::string text = *expression(3);
  TermStore store;
  Diagnostics problems;
  const Document document = read_document("t", text, store, problems);

  RC_ASSERT(problems.empty());
  RC_ASSERT(document.top.size() == 1U);
  RC_ASSERT(testing::printed(document, document.top[0], store) == text);
}

RC_GTEST_PROP(ReadDocument, ReadsTheSameWhateverStandsBetweenTheTokens, ()) {
  const std::string text = *expression(3);
  std::string spread;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    spread += text[i];
    if (text[i] == '\\') {
      spread += text[++i];
    } else if (text[i] == '"') {
      quoted = !quoted;
    }
    const bool loose = text[i] == '(' || text[i] == ' ' || text[i] == ')';
    if (loose && !quoted) {
      spread += *rc::gen::element<std::string>("", " ", "\n", " ; c )\n", "#| ( |#", "#+x (y)\n");
    }
  }
  TermStore store;
  Diagnostics problems;
  const Document document = read_document("t", spread, store, problems);

  RC_ASSERT(problems.empty());
  RC_ASSERT(testing::printed(document, document.top.at(0), store) == text);
}

// Words of the language in any order: nothing may break, and every error has its place.
RC_GTEST_PROP(ReadDefinitions, SurvivesAnyText, ()) {
  const auto word = rc::gen::element<std::string>(
      "(", "(", "(", ")", ")", ")", "defdomain", "defproblem", "make-problem", "(:method (a ?x)",
      "(:operator (!o ?y)", ":op", ":-", "?x", "!o", "a", "and", "(not", "(forall (?x)", "setof",
      ":first", ":sort-by", ":task", ":immediate", ":unordered", "'", "`", ",", "#'", "#+", "#.",
      ".", "\"s\"", "nil", "12", "1/0", "(:action b", ":parameters", ":effect", "(:types c - d)",
      ":derived", "(:include x)", "\n", ";", "#|", "|#", "|", "\\", "\x01", "\xFF");
  std::string text = "(defdomain d (";
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(word)) {
    text += part + " ";
  }
  testing::ReaderFixture reader;
  reader.with_file("x.lisp", text).read(text);

  for (const Diagnostic& error : reader.errors.all()) {
    RC_ASSERT(!error.message.empty());
    RC_ASSERT(error.line > 0);
    RC_ASSERT(error.column > 0);
    RC_ASSERT(!underlined(error, text).empty());
  }
}

RC_GTEST_PROP(ReadDefinitions, SurvivesAnyBytes, (const std::string& bytes)) {
  testing::ReaderFixture reader;
  reader.read(bytes);
  RC_ASSERT(reader.definitions.documents.size() == 1U);
}

}  // namespace
}  // namespace skein::htn
