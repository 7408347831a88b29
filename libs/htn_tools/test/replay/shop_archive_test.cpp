// SPDX-License-Identifier: Apache-2.0
// Every plan that SHOP3 gave for the shared problems is valid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "skein/htn_tools/validator.hpp"
#include "test_cases.hpp"
#include "testing/brute_force_planner.hpp"

namespace skein::htn {
namespace {

namespace fs = std::filesystem;

fs::path shared_data() {
  const char* given = std::getenv("SKEIN_SHARED_DATA");
  if (given != nullptr) return fs::path(given) / "shop";
  return fs::path(SKEIN_SOURCE_DIR) / "../shared/data/shop";
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A directory of this test that goes when the test ends.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (fs::temp_directory_path() / "skein-shop-XXXXXX").string();
    path_ = ::mkdtemp(name.data()) == nullptr ? fs::path() : fs::path(name);
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Domain and problem files of one folder of plans, and what they define.
struct Loaded {
  TermStore store;
  Definitions definitions;
};

// "ipc02-zeno-simpletime-easy" has the files easy-* of folder ipc02-zeno-simpletime, and so on.
std::vector<fs::path> files_of(const std::string& plans) {
  static const std::map<std::string, std::string> toys = {
      {"toy-apply-op", "apply-operator-bug"}, {"toy-assign-star", "test-assign-star"},
      {"toy-axiom-else", "axiom-else-bug"},   {"toy-basic", "basic-example"},
      {"toy-immediate", "test-immediate"},    {"toy-optimize", "optimize-example"},
      {"toy-ordering", "ordering-example"},   {"toy-plan-tree", "test-plan-tree"},
      {"toy-sort", "sort-example"},           {"toy-unbound", "unbound-example"}};
  const auto toy = toys.find(plans);
  if (toy != toys.end()) return {shared_data() / "toy" / (toy->second + ".lisp")};
  std::string folder = plans;
  std::string unwanted;
  const auto strip = [&](const std::string& ending, const std::string& other) {
    if (!folder.ends_with(ending)) return;
    folder.resize(folder.size() - ending.size());
    unwanted = other;
  };
  strip("-easy", "hard-");
  strip("-hard", "easy-");
  strip("-cleaned", "adlSat-pure");
  strip("-pure", "adlSat-cleaned");
  std::vector<fs::path> out;
  for (const fs::directory_entry& entry : fs::directory_iterator(shared_data() / folder)) {
    const std::string name = entry.path().filename().string();
    if (unwanted.empty() || !name.starts_with(unwanted)) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// The problem that a plan is of: by its name, or else by that of its file.
const ProblemDefinition* problem_of(const Definitions& definitions, const std::string& name) {
  for (const ProblemDefinition& problem : definitions.problems) {
    if (lower(problem.name) == lower(name)) return &problem;
  }
  for (const ProblemDefinition& problem : definitions.problems) {
    const fs::path file(problem.tasks.document->file);
    if (lower(file.stem().string()) == lower(name)) return &problem;
  }
  return nullptr;
}

void load(const std::string& plans, Loaded& loaded) {
  Diagnostics errors;
  Diagnostics warnings;
  const IncludeReader none = [](const std::string&, const std::string&) {
    return failure("no includes here");
  };
  for (const fs::path& file : files_of(plans)) {
    read_definitions({file.string(), read_file(file)}, loaded.store, none, loaded.definitions,
                     errors, warnings);
  }
}

TEST(Validator, AcceptsEveryPlanOfTheSharedArchive) {
  const fs::path archive = shared_data() / "plans.tar.xz";
  if (!fs::exists(archive)) GTEST_SKIP() << "no shared data at " << archive;
  const TemporaryDirectory temporary;
  const std::string command =
      "tar -xf '" + archive.string() + "' -C '" + temporary.path().string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(temporary.path() / "plans")) {
    folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  std::size_t checked = 0;

  for (const fs::path& folder : folders) {
    Loaded loaded;
    load(folder.filename().string(), loaded);
    ASSERT_FALSE(loaded.definitions.domains.empty()) << folder;
    Diagnostics errors;
    const Validator validator(loaded.definitions.domains.front(), loaded.definitions.functions,
                              Functions{}, loaded.store, errors);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string file = entry.path().filename().string();
      const ProblemDefinition* problem =
          problem_of(loaded.definitions, file.substr(0, file.find('.')));
      ASSERT_NE(problem, nullptr) << entry.path();
      const auto plans = read_plans(file, read_file(entry.path()), loaded.store, errors);
      ASSERT_EQ(plans.size(), 1U);
      const Validation validation = validator.validate(*problem, plans[0]);
      EXPECT_FALSE(validation.fault.has_value()) << entry.path() << ": " << to_text(validation);
      ++checked;
    }
  }

  EXPECT_GT(checked, 150U);
}

// The oracle is right where SHOP3 can be asked: it tries exactly as many goals as SHOP3 did.
TEST(BruteForce, CountsStepsExpansionsAndInferencesAsShop3) {
  if (!fs::exists(shared_data() / "reference.csv")) GTEST_SKIP() << "no " << shared_data();
  const std::vector<std::string> folders{"rovers-strips", "logistics",     "toy-assign-star",
                                         "toy-ordering",  "toy-plan-tree", "toy-unbound"};
  std::istringstream rows(read_file(shared_data() / "reference.csv"));
  std::string row;
  const std::size_t largest = testing::cases<std::size_t>(60, 450);
  std::size_t checked = 0;

  while (std::getline(rows, row)) {
    std::istringstream fields(row);
    std::vector<std::string> field(9);
    for (std::string& one : field) std::getline(fields, one, ',');
    const bool wanted = std::find(folders.begin(), folders.end(), field[0]) != folders.end();
    if (!wanted || field[3] == "none" || std::strtoul(field[5].c_str(), nullptr, 10) > largest)
      continue;
    Loaded loaded;
    load(field[0], loaded);
    const ProblemDefinition* problem = problem_of(loaded.definitions, field[1]);
    ASSERT_NE(problem, nullptr) << row;
    oracle::OracleLimits limits{10'000, 10'000, 1'000'000, field[2] == "first", true};
    const oracle::OracleOutcome outcome =
        oracle::brute_force(loaded.definitions.domains.front(), loaded.definitions.functions,
                            *problem, loaded.store, limits);

    ASSERT_FALSE(outcome.plans.empty()) << row;
    EXPECT_EQ(std::to_string(outcome.plans[0].steps.size()), field[3]) << row;
    EXPECT_EQ(std::to_string(outcome.expansions), field[5]) << row;
    EXPECT_EQ(std::to_string(outcome.inferences), field[6]) << row;
    EXPECT_EQ(std::to_string(outcome.plans.size()), field[8]) << row;
    ++checked;
  }

  EXPECT_GE(checked, testing::cases(20U, 25U));
}

}  // namespace
}  // namespace skein::htn
