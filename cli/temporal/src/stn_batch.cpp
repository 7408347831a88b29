// SPDX-License-Identifier: Apache-2.0
// `skein stn check --batch` and `skein stn dc --batch`: one question about every file of a folder.
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>
#include <ostream>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_analysis.hpp"
#include "stn_file.hpp"
#include "stn_report.hpp"

namespace skein::temporal_tool {

namespace {

namespace fs = std::filesystem;

struct FileAnswer {
  std::string name;
  std::size_t nodes = 0;
  std::size_t requirements = 0;
  std::size_t contingent = 0;
  std::optional<bool> yes;  ///< nothing: it could not be read or asked
  std::string errors;       ///< why; also warnings
  double seconds = 0;
};

struct Times {
  std::size_t files = 0;
  double least = 0;
  double median = 0;
  double mean = 0;
  double most = 0;
  double total = 0;
};

Times times_of(std::vector<double> seconds) {
  Times times;
  times.files = seconds.size();
  if (seconds.empty()) return times;
  std::sort(seconds.begin(), seconds.end());
  const std::size_t middle = seconds.size() / 2;
  times.least = seconds.front();
  times.most = seconds.back();
  times.median =
      seconds.size() % 2 == 1 ? seconds[middle] : (seconds[middle - 1] + seconds[middle]) / 2;
  times.total = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  times.mean = times.total / static_cast<double>(seconds.size());
  return times;
}

// In the order of their names; nothing when the folder cannot be read.
std::optional<std::vector<fs::path>> files_in(const std::string& folder) {
  std::error_code failed;
  fs::directory_iterator entries(folder, failed);
  if (failed) return std::nullopt;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries) {
    if (entry.is_regular_file(failed)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Result<bool, Failure> answer_of(StnQuestion question, const temporal::Stnu& network) {
  if (question == StnQuestion::kConsistent) {
    const Result<Consistency, Failure> answer = analyse_consistency(network);
    if (!answer) return tl::unexpected(answer.error());
    return answer->consistent;
  }
  const Result<Controllability, Failure> answer = analyse_controllability(network);
  if (!answer) return tl::unexpected(answer.error());
  return answer->controllable;
}

FileAnswer ask(const StnBatchOptions& options, const fs::path& file) {
  FileAnswer answer;
  answer.name = file.filename().string();
  StnOptions common = options.common;
  common.file = file.string();
  std::istringstream nothing;
  std::ostringstream errors;
  if (const std::optional<temporal::ReadNetwork> read = load_network(common, nothing, errors)) {
    answer.nodes = read->network.nodes.size();
    answer.requirements = read->network.arcs.size();
    answer.contingent = read->network.contingent.size();
    const double begin = common.now ? common.now() : 0;
    const Result<bool, Failure> yes = answer_of(options.question, read->network);
    answer.seconds = (common.now ? common.now() : 0) - begin;
    if (yes) answer.yes = *yes;
    if (!yes) errors << common.file << ": " << yes.error().why << '\n';
  }
  answer.errors = errors.str();
  return answer;
}

/// The answers, counted.
struct Summary {
  std::size_t yes = 0;
  std::size_t no = 0;
  std::size_t unreadable = 0;
  Times all, of_yes, of_no;
};

Summary summary_of(const std::vector<FileAnswer>& answers) {
  Summary summary;
  std::vector<double> all, of_yes, of_no;
  for (const FileAnswer& answer : answers) {
    if (!answer.yes) {
      ++summary.unreadable;
      continue;
    }
    all.push_back(answer.seconds);
    (*answer.yes ? of_yes : of_no).push_back(answer.seconds);
  }
  summary.yes = of_yes.size();
  summary.no = of_no.size();
  summary.all = times_of(all);
  summary.of_yes = times_of(of_yes);
  summary.of_no = times_of(of_no);
  return summary;
}

const char* word_for(StnQuestion question, bool yes) {
  if (question == StnQuestion::kConsistent) return yes ? "consistent" : "inconsistent";
  return yes ? "controllable" : "not controllable";
}

void write_text(const StnBatchOptions& options, const std::vector<FileAnswer>& answers,
                const Summary& summary, std::ostream& out) {
  const Paint paint(options.common.colour);
  std::vector<std::vector<std::string>> rows{
      {"file", "nodes", "requirements", "contingent", "time", "answer"}};
  for (const FileAnswer& answer : answers) {
    if (!answer.yes) {
      rows.push_back({answer.name, "", "", "", "", paint.bad("cannot be used")});
      continue;
    }
    const std::string word = word_for(options.question, *answer.yes);
    rows.push_back({answer.name, std::to_string(answer.nodes), std::to_string(answer.requirements),
                    std::to_string(answer.contingent), duration_text(answer.seconds),
                    *answer.yes ? paint.good(word) : paint.bad(word)});
  }
  out << table_text(rows, "") << '\n';
  rows = {{"", "files", "least", "median", "mean", "most", "total"}};
  const auto add = [&](const std::string& name, const Times& times) {
    rows.push_back({name, std::to_string(times.files), duration_text(times.least),
                    duration_text(times.median), duration_text(times.mean),
                    duration_text(times.most), duration_text(times.total)});
  };
  add("all", summary.all);
  add(word_for(options.question, true), summary.of_yes);
  add(word_for(options.question, false), summary.of_no);
  out << table_text(rows, "");
  if (summary.unreadable > 0) out << summary.unreadable << " cannot be used\n";
}

std::string seconds_json(double seconds) {
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(6);
  text << seconds;
  return text.str();
}

std::string times_json(const Times& times) {
  return "{\"files\": " + std::to_string(times.files) +
         ", \"least\": " + seconds_json(times.least) +
         ", \"median\": " + seconds_json(times.median) + ", \"mean\": " + seconds_json(times.mean) +
         ", \"most\": " + seconds_json(times.most) + ", \"total\": " + seconds_json(times.total) +
         "}";
}

std::string file_json(StnQuestion question, const FileAnswer& answer) {
  std::string text = "{\"file\": " + json_text(answer.name);
  if (!answer.yes) return text + ", \"error\": " + json_text(answer.errors) + "}";
  text += ", \"nodes\": " + std::to_string(answer.nodes) +
          ", \"requirements\": " + std::to_string(answer.requirements) +
          ", \"contingent\": " + std::to_string(answer.contingent);
  text += question == StnQuestion::kConsistent ? ", \"consistent\": " : ", \"controllable\": ";
  return text + (*answer.yes ? "true" : "false") +
         ", \"seconds\": " + seconds_json(answer.seconds) + "}";
}

void write_json(const StnBatchOptions& options, const std::vector<FileAnswer>& answers,
                const Summary& summary, std::ostream& out) {
  out << "{\"files\": [";
  for (std::size_t i = 0; i < answers.size(); ++i) {
    out << (i == 0 ? "\n  " : ",\n  ") << file_json(options.question, answers[i]);
  }
  out << "],\n \"yes\": " << summary.yes << ", \"no\": " << summary.no
      << ", \"unusable\": " << summary.unreadable
      << ",\n \"seconds\": {\"all\": " << times_json(summary.all)
      << ", \"yes\": " << times_json(summary.of_yes) << ", \"no\": " << times_json(summary.of_no)
      << "}}\n";
}

}  // namespace

int check_stn_batch(const StnBatchOptions& options, std::ostream& out, std::ostream& err) {
  const std::optional<std::vector<fs::path>> files = files_in(options.folder);
  if (!files || files->empty()) {
    err << options.folder << ": " << (files ? "has no files" : "cannot be read as a folder")
        << '\n';
    return kExitBadInput;
  }
  std::vector<FileAnswer> answers;
  for (const fs::path& file : *files) {
    answers.push_back(ask(options, file));
    err << answers.back().errors;
  }
  const Summary summary = summary_of(answers);
  if (options.common.json) {
    write_json(options, answers, summary, out);
  } else {
    write_text(options, answers, summary, out);
  }
  if (summary.unreadable > 0) return kExitBadInput;
  return summary.no > 0 ? kExitNegative : kExitOk;
}

}  // namespace skein::temporal_tool
