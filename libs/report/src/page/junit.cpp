// SPDX-License-Identifier: Apache-2.0
#include "markup.hpp"
#include "skein/report/report.hpp"

namespace skein::report {

namespace {

void write_case(Markup& out, const RunInfo& info, const ExpectationRecord& e) {
  out.open("testcase", {{"classname", info.scenario}, {"name", e.name}});
  if (!e.passed) out.element("failure", {{"message", e.seen}}, e.seen);
  out.close().line_break();
}

}  // namespace

std::string junit(const RunInfo& info, const Journal& journal) {
  std::size_t failures = 0;
  for (const ExpectationRecord& e : journal.expectations) failures += e.passed ? 0 : 1;
  const bool none = journal.expectations.empty();
  const std::size_t tests = none ? 1 : journal.expectations.size();
  Markup out;
  out.raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  out.open("testsuites").line_break();
  out.open("testsuite", {{"name", info.scenario},
                         {"tests", tests},
                         {"failures", none ? std::size_t{1} : failures},
                         {"errors", 0},
                         {"skipped", 0},
                         {"time", short_number(info.wall_seconds, 3)}});
  out.line_break();
  for (const ExpectationRecord& e : journal.expectations) write_case(out, info, e);
  if (none) {
    write_case(out, info, {{}, "the run checks its expectations", false, "none was checked"});
  }
  out.close().line_break().close().line_break();
  return out.take();
}

}  // namespace skein::report
