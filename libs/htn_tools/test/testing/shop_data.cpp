// SPDX-License-Identifier: Apache-2.0
#include "testing/shop_data.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <ostream>
#include <sstream>

namespace skein::htn::shop_data {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  cells.resize(9);
  return cells;
}

std::optional<std::string> toy_file(const std::string& domain) {
  static const std::map<std::string, std::string> files = {
      {"toy-apply-op", "apply-operator-bug"}, {"toy-assign-star", "test-assign-star"},
      {"toy-axiom-else", "axiom-else-bug"},   {"toy-basic", "basic-example"},
      {"toy-immediate", "test-immediate"},    {"toy-optimize", "optimize-example"},
      {"toy-ordering", "ordering-example"},   {"toy-plan-tree", "test-plan-tree"},
      {"toy-sort", "sort-example"},           {"toy-unbound", "unbound-example"}};
  const auto found = files.find(domain);
  if (found == files.end()) return {};
  return found->second + ".lisp";
}

// "ipc02-zeno-simpletime-easy" has the files of ipc02-zeno-simpletime but for hard-*, and so on.
std::vector<fs::path> files_of(const std::string& domain) {
  if (const auto toy = toy_file(domain)) return {folder() / "toy" / *toy};
  static const std::vector<std::pair<std::string, std::string>> parts = {
      {"-easy", "hard-"},
      {"-hard", "easy-"},
      {"-cleaned", "adlSat-pure"},
      {"-pure", "adlSat-cleaned"}};
  std::string name = domain;
  std::string unwanted = " ";
  for (const auto& [ending, other] : parts) {
    if (!domain.ends_with(ending)) continue;
    name.resize(domain.size() - ending.size());
    unwanted = other;
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder() / name)) {
    if (!entry.path().filename().string().starts_with(unwanted)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

const ProblemDefinition* find(const std::vector<ProblemDefinition>& problems,
                              const std::string& name) {
  for (const ProblemDefinition& problem : problems) {
    if (lower(problem.name) == lower(name)) return &problem;
  }
  for (const ProblemDefinition& problem : problems) {
    const std::string file = fs::path(problem.tasks.document->file).stem().string();
    if (file == name || file.ends_with('-' + name)) return &problem;  // "easy-pfile1"
  }
  return nullptr;
}

}  // namespace

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.domain << ' ' << row.problem << ' ' << row.which;
}

fs::path folder() {
  const char* given = std::getenv("SKEIN_SHARED_DATA");
  return given != nullptr ? fs::path(given) / "shop"
                          : fs::path(SKEIN_SOURCE_DIR) / "../shared/data/shop";
}

std::vector<Row> rows() {
  std::vector<Row> rows;
  std::ifstream file(folder() / "reference.csv");
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    rows.push_back({cells[0], cells[1], cells[2], cells[3], std::atof(cells[4].c_str()),
                    static_cast<std::size_t>(std::atoi(cells[8].c_str()))});
  }
  return rows;
}

std::unique_ptr<Loaded> load(const std::string& domain, const std::string& problem) {
  auto loaded = std::make_unique<Loaded>();
  const IncludeReader none = [](const std::string&, const std::string&) {
    return failure("no includes here");
  };
  for (const fs::path& file : files_of(domain)) {
    read_definitions({file.string(), text_of(file)}, loaded->store, none, loaded->definitions,
                     loaded->errors, loaded->warnings);
  }
  loaded->problem = find(loaded->definitions.problems, problem);
  return loaded;
}

Archive::Archive() {
  std::string name = (fs::temp_directory_path() / "skein-plans-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return;
  path_ = name;
  const fs::path archive = folder() / "plans.tar.xz";
  const std::string command = "tar -xf '" + archive.string() + "' -C '" + name + "'";
  if (fs::exists(archive)) std::ignore = std::system(command.c_str());
}

Archive::~Archive() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

std::optional<GivenPlan> Archive::plan(const std::string& domain, const std::string& problem,
                                       const std::string& which, TermStore& store) const {
  std::string name = problem + '.' + which + ".plan";
  std::replace(name.begin(), name.end(), '/', '_');
  const fs::path file = path_ / "plans" / domain / name;
  if (!fs::exists(file)) return {};
  Diagnostics errors;
  std::vector<GivenPlan> plans = read_plans(file.string(), text_of(file), store, errors);
  if (!errors.empty() || plans.size() != 1) return {};
  return std::move(plans.front());
}

}  // namespace skein::htn::shop_data
