// SPDX-License-Identifier: Apache-2.0
#include "skein/batch_tool/batch.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>
#include <set>

#include "csv.hpp"
#include "row.hpp"
#include "series.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/run_tool/interrupt_guard.hpp"
#include "skein/workers/seeds.hpp"
#include "sweep.hpp"

namespace skein::batch_tool {

namespace {

namespace fs = std::filesystem;
using run_tool::InterruptGuard;

constexpr std::uint64_t kMostRuns = 10'000'000;

std::string text_of_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "confirmed-3-17": the third combination, seed 17.
std::string folder_name(const Case& what, std::size_t combination, std::size_t of) {
  return what.scenario + (of > 1 ? "-" + std::to_string(combination + 1) : "") + "-" +
         std::to_string(what.seed);
}

class Batch {
 public:
  Batch(const BatchOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err) {}

  int run() {
    if (!read()) return kExitBadInput;
    if (!prepare()) return kExitSystem;
    const InterruptGuard guard;
    workers::do_apart(
        [this] { return next(); }, options_.limits,
        [this](std::uint64_t number, const workers::Outcome& outcome) { take(number, outcome); });
    end_progress();
    return finish();
  }

 private:
  // ---- what is played ----

  bool read() {
    const auto seeds = workers::seeds_of(options_.seeds);
    if (!seeds) err_ << "--seeds: '" << options_.seeds << "', expected A..B, as in 1..300\n";
    const auto sweeps = read_sweeps(options_.sets);
    if (!sweeps) err_ << to_text(sweeps.error());
    if (!seeds || !sweeps) return false;
    seeds_ = *seeds;
    combinations_ = combinations(*sweeps);
    bool good = true;
    std::set<std::string> names;
    for (const std::string& file : options_.scenarios) good = read_scenario(file, names) && good;
    const std::uint64_t each = seeds_.second - seeds_.first;
    if (good && each >= kMostRuns / std::max<std::size_t>(1, bases_.size())) {
      err_ << "--seeds: more than " << kMostRuns << " runs\n";
      return false;
    }
    all_ = (each + 1) * bases_.size();
    return good;
  }

  /// With every combination: what is wrong is told before anything is played.
  bool read_scenario(const std::string& file, std::set<std::string>& names) {
    const std::string text = text_of_file(file);
    bool good = true;
    for (const Combination& combination : combinations_) {
      Case base{fs::path(file).stem().string(), file, "", combination, seeds_.first, ""};
      const auto changed = with_values(text, combination);
      if (!changed && !combination.empty()) {
        err_ << file << ": --set " << changed.error().why << '\n';
        good = false;
        continue;
      }
      base.text = changed ? *changed : text;
      const auto scenario = scenario_of(base, options_.degrees);
      if (!scenario) {
        if (!combination.empty()) err_ << "with " << to_text(combination) << ":\n";
        err_ << to_text(scenario.error());
        good = false;
        continue;
      }
      base.scenario = scenario->name;
      bases_.push_back(std::move(base));
    }
    if (good && !names.insert(bases_.back().scenario).second) {
      err_ << file << ": another scenario is called '" << bases_.back().scenario << "' too\n";
      good = false;
    }
    return good;
  }

  bool prepare() {
    std::error_code error;
    fs::create_directories(options_.out, error);
    if (error) err_ << "cannot create " << options_.out << ": " << error.message() << '\n';
    return !error;
  }

  /// In the order scenario, combination, seed.
  Case case_of(std::uint64_t number) const {
    const std::uint64_t each = seeds_.second - seeds_.first + 1;
    Case what = bases_.at(number / each);
    what.seed = seeds_.first + number % each;
    const std::size_t combination = number / each % combinations_.size();
    if (options_.keep)
      what.folder =
          (fs::path(options_.out) / folder_name(what, combination, combinations_.size())).string();
    return what;
  }

  std::optional<workers::Work> next() {
    if (given_ == all_ || InterruptGuard::interrupted()) return std::nullopt;
    return [this, what = case_of(given_++)] { return to_json(play_case(what, options_.degrees)); };
  }

  void take(std::uint64_t number, const workers::Outcome& outcome) {
    auto row = row_from_json(outcome.said);
    if (!row) {
      const Case what = case_of(number);
      row.emplace();
      row->scenario = what.scenario;
      row->combination = what.combination;
      row->seed = what.seed;
      row->outcome = outcome.end == workers::Outcome::End::kHung ? "hung" : "died";
      row->reason = outcome.why;
    }
    bad_ += row->good() ? 0 : 1;
    rows_.emplace(number, std::move(*row));
    show_progress();
  }

  // ---- what is told ----

  void show_progress() {
    if (options_.quiet || options_.json) return;
    const std::uint64_t played = rows_.size();
    if (!options_.on_terminal && played % 50 != 0) return;
    const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - began_;
    const double left =
        so_far.count() / static_cast<double>(played) * static_cast<double>(all_ - played);
    err_ << (options_.on_terminal ? "\r" : "") << played << " of " << all_ << " runs, " << bad_
         << " not as expected, " << static_cast<long>(left + 0.5) << " s left  "
         << (options_.on_terminal ? "" : "\n") << std::flush;
  }

  void end_progress() {
    if (options_.on_terminal && !options_.quiet && !options_.json) err_ << '\n';
  }

  bool write(const fs::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    if (!out) err_ << "cannot write " << path.string() << '\n';
    return static_cast<bool>(out);
  }

  bool interrupted() const {
    return InterruptGuard::interrupted() ||
           std::any_of(rows_.begin(), rows_.end(),
                       [](const auto& one) { return one.second.outcome == "interrupted"; });
  }

  int finish() {
    std::vector<Row> rows;
    for (auto& [number, row] : rows_)
      if (row.outcome != "interrupted") rows.push_back(std::move(row));
    const bool early = interrupted();
    const std::vector<Series> series = series_of(rows);
    const fs::path folder(options_.out);
    const fs::path csv = options_.csv.empty() ? folder / "runs.csv" : fs::path(options_.csv);
    bool written = write(csv, to_csv(rows));
    const std::string summary = summary_json(series);
    written = write(folder / "summary.json", summary) && written;
    written = write(folder / "summary.svg", summary_svg(series)) && written;
    if (options_.json) {
      out_ << summary;
    } else {
      print(out_, series, 5);
      if (early) out_ << "interrupted after " << rows.size() << " of " << all_ << " runs\n";
      out_ << "runs: " << csv.string() << "; picture: " << (folder / "summary.svg").string()
           << '\n';
    }
    if (early) return kExitInterrupted;
    if (!written || std::any_of(rows.begin(), rows.end(),
                                [](const Row& row) { return row.outcome == "unwritten"; }))
      return kExitSystem;
    return bad_ == 0 ? kExitOk : kExitNegative;
  }

  const BatchOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::pair<std::uint64_t, std::uint64_t> seeds_;
  std::vector<Combination> combinations_;
  std::vector<Case> bases_;  ///< every scenario with every combination
  std::uint64_t given_ = 0, all_ = 0, bad_ = 0;
  std::map<std::uint64_t, Row> rows_;  ///< by number
};

}  // namespace

int batch(const BatchOptions& options, std::ostream& out, std::ostream& err) {
  return Batch(options, out, err).run();
}

}  // namespace skein::batch_tool
