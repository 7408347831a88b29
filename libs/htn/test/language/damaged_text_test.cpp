// SPDX-License-Identifier: Apache-2.0
// Sound files with one fault put in: the fault is reported at its place, and everything that does
// not touch it is read as before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "testing/reader_fixture.hpp"

namespace skein::htn::damaged {
namespace {

using testing::ReaderFixture;

/// A domain of operators and methods, each on a line of its own; line 1 is the head.
class Lines {
 public:
  Lines() {
    lines_.emplace_back("(defdomain d (");
    const int count = *rc::gen::inRange(2, 7);
    for (int number = 0; number < count; ++number) {
      const std::string n = std::to_string(number);
      static constexpr std::array<const char*, 4> kShapes{
          "(:operator (!o# ?a) ((p ?a) (not (q ?a))) ((p ?a)) ((q ?a)) 2)",
          "(:method (t# ?a) first ((p ?a)) ((!o# ?a)) second () ())",
          "(:- (axiom# ?a) ((p ?a) (or (q ?a) (r ?a))))",
          "(:op (!o# ?a) :precond ((p ?a)) :add ((q (list-of (nested ?a)))) :cost 3)"};
      std::string item = kShapes.at(*rc::gen::inRange<std::size_t>(0, kShapes.size()));
      for (std::size_t at = item.find('#'); at != std::string::npos; at = item.find('#'))
        item.replace(at, 1, n);
      lines_.push_back(item);
    }
    lines_.emplace_back("))");
  }

  std::size_t items() const { return lines_.size() - 2; }
  /// A line of an item [lines from 1].
  std::size_t drawn_line() const { return 2 + *rc::gen::inRange<std::size_t>(0, items()); }
  std::string& line(std::size_t number) { return lines_.at(number - 1); }
  std::string text() const {
    std::string out;
    for (const std::string& line : lines_) out += line + "\n";
    return out;
  }
  /// Places of a character in a line.
  std::vector<std::size_t> places(std::size_t number, char wanted) const {
    std::vector<std::size_t> found;
    const std::string& text = lines_.at(number - 1);
    for (std::size_t at = 0; at < text.size(); ++at)
      if (text[at] == wanted) found.push_back(at);
    return found;
  }

 private:
  std::vector<std::string> lines_;
};

std::size_t count(const ReaderFixture& reader) {
  if (reader.definitions.domains.empty()) return 0;
  const DomainDefinition& domain = reader.domain();
  return domain.operators.size() + domain.methods.size() + domain.axioms.size();
}

Diagnostic only_error(const ReaderFixture& reader, const std::string& text) {
  RC_LOG() << text << reader.error_text();
  RC_ASSERT(reader.errors.all().size() == 1U);
  return reader.errors.all().front();
}

RC_GTEST_PROP(DamagedText, IsReadWholeWithoutDamage, ()) {
  const Lines lines;
  ReaderFixture reader;
  reader.read(lines.text());

  RC_LOG() << reader.error_text();
  RC_ASSERT(reader.errors.empty());
  RC_ASSERT(count(reader) == lines.items());
}

RC_GTEST_PROP(DamagedText, AnItemWithoutItsLastParenthesisIsNamed, ()) {
  Lines lines;
  const std::size_t damaged = lines.drawn_line();
  RC_PRE(damaged < lines.items() + 1);  // what follows shows where it belongs
  lines.line(damaged).pop_back();
  ReaderFixture reader;
  reader.read(lines.text());

  const Diagnostic error = only_error(reader, lines.text());
  RC_ASSERT(error.line == static_cast<int>(damaged));
  RC_ASSERT(error.column == 1);
}

RC_GTEST_PROP(DamagedText, AParenthesisTooManyIsFoundInItsLineOrWhereTheFileEnds, ()) {
  Lines lines;
  const std::size_t damaged = lines.drawn_line();
  lines.line(damaged) += ")";
  ReaderFixture reader;
  reader.read(lines.text());

  RC_LOG() << lines.text() << reader.error_text();
  RC_ASSERT(!reader.errors.empty());
  const Diagnostic& error = reader.errors.all().front();
  RC_ASSERT(error.line >= static_cast<int>(damaged));
  RC_ASSERT(error.line <= static_cast<int>(lines.items()) + 2);
}

RC_GTEST_PROP(DamagedText, AnUnknownKeywordLeavesOutItsItemOnly, ()) {
  Lines lines;
  const std::size_t damaged = lines.drawn_line();
  lines.line(damaged).replace(1, 2, ":zz");  // "(:o…", "(:m…", "(:-"
  ReaderFixture reader;
  reader.read(lines.text());

  const Diagnostic error = only_error(reader, lines.text());
  RC_ASSERT(error.file == "test.lisp");
  RC_ASSERT(error.line == static_cast<int>(damaged));
  RC_ASSERT(error.column == 1 || error.column == 2);
  RC_ASSERT(count(reader) == 0U || count(reader) == lines.items() - 1);
}

RC_GTEST_PROP(DamagedText, ANumberThatCannotBeIsReportedAtItsFirstCharacter, ()) {
  Lines lines;
  const std::size_t damaged = lines.drawn_line();
  const std::vector<std::size_t> variables = lines.places(damaged, '?');
  const std::size_t at = variables.at(*rc::gen::inRange<std::size_t>(0, variables.size()));
  const auto number = *rc::gen::element<std::string>("1/0", "99999999999999999999", "1e999",
                                                     "-12345678901234567890");
  lines.line(damaged).replace(at, 2, number);
  ReaderFixture reader;
  reader.read(lines.text());

  RC_LOG() << lines.text() << reader.error_text();
  RC_ASSERT(!reader.errors.empty());
  const Diagnostic& error = reader.errors.all().front();
  RC_ASSERT(error.line == static_cast<int>(damaged));
  RC_ASSERT(error.column == static_cast<int>(at) + 1);
  RC_ASSERT(error.message.find(number) != std::string::npos);
}

RC_GTEST_PROP(DamagedText, ColumnsAreCharactersWhateverTheirBytes, ()) {
  Lines lines;
  const std::size_t damaged = lines.drawn_line();
  const auto before = *rc::gen::element<std::string>("#|é|#", "#|漢字|#", "#|😀|#", "#|ab|#");
  const std::map<std::string, int> characters{
      {"#|é|#", 5}, {"#|漢字|#", 6}, {"#|😀|#", 5}, {"#|ab|#", 6}};
  lines.line(damaged) = before + lines.line(damaged);
  const std::size_t at = lines.places(damaged, '?').front();
  lines.line(damaged).replace(at, 2, "1/0");
  ReaderFixture reader;
  reader.read(lines.text());

  RC_LOG() << lines.text() << reader.error_text();
  RC_ASSERT(!reader.errors.empty());
  const int bytes_more = static_cast<int>(before.size()) - characters.at(before);
  RC_ASSERT(reader.errors.all().front().column == static_cast<int>(at) + 1 - bytes_more);
}

RC_GTEST_PROP(DamagedText, AnUnclosedStringOrCommentIsReportedWhereItBegins, ()) {
  Lines lines;
  const std::size_t damaged = lines.drawn_line();
  const auto opening = *rc::gen::element<std::string>("\"", "#|", "|");
  const std::vector<std::size_t> spaces = lines.places(damaged, ' ');
  const std::size_t at = spaces.at(*rc::gen::inRange<std::size_t>(0, spaces.size()));
  lines.line(damaged).replace(at, 1, " " + opening);
  ReaderFixture reader;
  reader.read(lines.text());

  RC_LOG() << lines.text() << reader.error_text();
  const auto& errors = reader.errors.all();
  const bool found = std::any_of(errors.begin(), errors.end(), [&](const Diagnostic& error) {
    return error.line == static_cast<int>(damaged) && error.column == static_cast<int>(at) + 2;
  });
  RC_ASSERT(found);
}

RC_GTEST_PROP(DamagedText, EachOfSeveralFaultsHasItsLine, ()) {
  Lines lines;
  std::set<int> damaged;
  for (std::size_t number = 2; number < lines.items() + 2; ++number) {
    if (*rc::gen::arbitrary<bool>()) continue;
    const std::size_t at = lines.places(number, '?').back();
    lines.line(number).replace(at, 2, "1/0");
    damaged.insert(static_cast<int>(number));
  }
  ReaderFixture reader;
  reader.read(lines.text());

  std::set<int> reported;
  for (const Diagnostic& error : reader.errors.all()) reported.insert(error.line);
  RC_LOG() << lines.text() << reader.error_text();
  RC_ASSERT(reported == damaged);
}

}  // namespace
}  // namespace skein::htn::damaged
