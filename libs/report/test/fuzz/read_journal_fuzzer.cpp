// SPDX-License-Identifier: Apache-2.0
// Any bytes as an event log and as a run description: read or refused, and a page of what was read.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "skein/report/report.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::istringstream in(text);
  const skein::report::SalvagedJournal read = skein::report::salvage_journal(in, "fuzz");
  if (read.journal.unreadable > read.errors.size()) std::abort();
  const auto info = skein::report::run_info_from_json(text, "fuzz");
  const skein::report::RunInfo run = info ? *info : skein::report::RunInfo{};
  if (skein::report::html_report(run, read.journal).find("</html>") == std::string::npos) {
    std::abort();
  }
  skein::report::junit(run, read.journal);
  skein::report::summary_json(run, read.journal);
  return 0;
}
