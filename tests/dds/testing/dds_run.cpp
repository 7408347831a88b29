// SPDX-License-Identifier: Apache-2.0
#include "testing/dds_run.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>

namespace skein::testing {

namespace {

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;  // of a process that is gone no more can be read, which is no exception
  text << in.rdbuf();
  return text.str();
}

// The words of a process's command line; none if it is gone.
std::vector<std::string> command_of(pid_t pid) {
  const std::string text = read_text("/proc/" + std::to_string(pid) + "/cmdline");
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == '\0') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

std::string daemon_name(const std::vector<std::string>& command) {
  for (const char* option : {"--uav", "--node"}) {
    const auto named = std::find(command.begin(), command.end(), option);
    if (named != command.end() && named + 1 != command.end()) return *(named + 1);
  }
  const std::string program = fs::path(command[0]).filename().string();
  return program.rfind("skein-", 0) == 0 ? program.substr(6) : program;
}

std::set<std::string> shared_memory() {
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/dev/shm", ignored)) {
    const std::string name = entry.path().filename().string();
    for (const char* mark : {"fast", "skein", "sem.fast"}) {
      if (name.rfind(mark, 0) == 0) names.insert(name);
    }
  }
  return names;
}

// The files in shared memory that a living process has open or mapped.
std::set<std::string> used_shared_memory() {
  const std::string folder = "/dev/shm/";
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& process : fs::directory_iterator("/proc", ignored)) {
    std::error_code gone;
    for (const auto& open : fs::directory_iterator(process.path() / "fd", gone)) {
      const std::string file = fs::read_symlink(open.path(), gone).string();
      if (file.rfind(folder, 0) == 0) names.insert(file.substr(folder.size()));
    }
    std::ifstream maps(process.path() / "maps");
    for (std::string line; std::getline(maps, line);) {
      const std::size_t at = line.find(folder);
      if (at != std::string::npos) names.insert(line.substr(at + folder.size()));
    }
  }
  return names;
}

}  // namespace

bool holds_within(double seconds, const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    poll(nullptr, 0, 20);
  }
  return true;
}

DdsRun::DdsRun() : shared_memory_before_(shared_memory()) {
  std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(test.begin(), test.end(), '/', '-');
  folder_ = fs::temp_directory_path() / ("skein-dds-" + test + "-" + std::to_string(getpid()));
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

DdsRun::~DdsRun() {
  const bool failed = ::testing::Test::HasFailure();
  if (failed) std::fputs(output().c_str(), stderr);
  process_.reset();
  for (const Daemon& daemon : pids()) kill(daemon.pid, SIGKILL);
  if (failed) keep_for_inquiry();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

// What failed only under load may not fail again: its event log and those of its daemons are all
// that tells why.
void DdsRun::keep_for_inquiry() const {
  const fs::path kept = fs::path(kPrograms).parent_path() / "failed-runs" / folder_.filename();
  std::error_code error;
  fs::create_directories(kept.parent_path(), error);
  fs::copy(folder_, kept,
           fs::copy_options::recursive | fs::copy_options::copy_symlinks |
               fs::copy_options::overwrite_existing,
           error);
  const std::string said = error ? "not kept: " + error.message() : "kept: " + kept.string();
  std::fputs(("the run is " + said + "\n").c_str(), stderr);
}

void DdsRun::take_scenario(const std::string& name, const std::string& more) {
  const std::string comets = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/";
  std::ofstream(folder_ / "scenario.yaml") << read_text(comets + name + ".yaml") << more;
  change("model: models/", "model: " + comets + "models/");
  change("include: ../", "include: " + comets + "../");
}

void DdsRun::take_scenario_of(const std::string& name, const std::string& more) {
  const std::string scenarios = std::string(SKEIN_SOURCE_DIR) + "/scenarios/";
  const std::string text = read_text(scenarios + name + ".yaml");
  std::ofstream(folder_ / "scenario.yaml") << text << more;
  const std::string beside = (fs::path(scenarios + name).parent_path() / "models/").string();
  if (text.find("model: models/") != std::string::npos)
    change("model: models/", "model: " + beside);
  for (const char* key : {"model: ", "domain: ", "include: ", "interaction: "}) {
    const std::string above = std::string(key) + "../";
    if (text.find(above) != std::string::npos) change(above, key + scenarios);
  }
}

void DdsRun::change(const std::string& from, const std::string& to) {
  std::string text = read_text(folder_ / "scenario.yaml");
  ASSERT_NE(text.find(from), std::string::npos) << from;
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  std::ofstream(folder_ / "scenario.yaml") << text;
}

void DdsRun::start(const std::vector<std::string>& options) {
  std::vector<std::string> command{kPrograms + "/skein", "run",
                                   (folder_ / "scenario.yaml").string(), "--out", folder().string(),
                                   // The machine is shared: it may stand still for a second.
                                   "--allow-late", "1"};
  command.insert(command.end(), options.begin(), options.end());
  auto process = run_tool::Process::start(command, (folder_ / "output").string());
  ASSERT_TRUE(process.has_value()) << process.error().why;
  process_.emplace(std::move(*process));
}

std::string DdsRun::programs_with(const std::set<std::string>& scripted,
                                  const std::string& script) const {
  const fs::path folder = file("programs");
  fs::create_directories(folder);
  for (const char* name : {"skein-sim", "skein-ground", "skein-ddn"}) {
    if (!scripted.contains(name)) {
      fs::create_symlink(fs::path(kPrograms) / name, folder / name);
      continue;
    }
    std::ofstream(folder / name) << "#!/bin/sh\nprograms='" << kPrograms << "'\n" << script << "\n";
    fs::permissions(folder / name, fs::perms::owner_all);
  }
  return folder.string();
}

// A machine that stands still breaks every expectation of a run in real time: that is said first.
void DdsRun::expect_no_stall() const {
  const std::string text = output();
  const std::size_t at = text.find("the mission clock was not heard");
  if (at == std::string::npos) return;
  ADD_FAILURE() << "the machine stalled, the mission is not to blame: "
                << text.substr(at, text.find('\n', at) - at);
}

std::optional<run_tool::Process::Status> DdsRun::wait(double seconds) {
  const bool ended = holds_within(seconds, [&] { return process_->poll().has_value(); });
  EXPECT_TRUE(ended) << "the run goes on after " << seconds << " s";
  expect_no_stall();
  return process_->poll();
}

void DdsRun::wait_until(const std::string& what, const std::function<bool()>& condition,
                        double seconds) {
  bool ended = false;
  const bool held = holds_within(seconds, [&] {
    ended = process_->poll().has_value();
    return ended || condition();
  });
  ASSERT_TRUE(held) << "no " << what << " after " << seconds << " s";
  if (ended && !condition()) expect_no_stall();
  ASSERT_TRUE(!ended || condition()) << "the run ended before " << what;
}

void DdsRun::wait_for_output(const std::string& text, double seconds) {
  wait_until(
      "'" + text + "'", [&] { return output().find(text) != std::string::npos; }, seconds);
}

void DdsRun::kill_daemon(const std::string& name) {
  for (const Daemon& daemon : pids()) {
    if (daemon.name == name) kill(daemon.pid, SIGKILL);
  }
}

bool DdsRun::nothing_runs() {
  return holds_within(20, [&] { return pids().empty(); });
}

std::vector<std::string> DdsRun::left_in_shared_memory() const {
  const std::set<std::string> now = shared_memory();
  const std::set<std::string> used = used_shared_memory();  // by others: this run is over
  std::vector<std::string> left;
  for (const std::string& name : now) {
    const bool older = shared_memory_before_.contains(name);
    if (!older && !used.contains(name) && fs::exists(fs::path("/dev/shm") / name)) {
      left.push_back(name);
    }
  }
  return left;
}

std::string DdsRun::output() const { return read_text(folder_ / "output"); }

std::vector<journal::Record> DdsRun::records() const {
  std::vector<journal::Record> records;
  std::ifstream in(folder() / "events.jsonl");
  for (std::string line; std::getline(in, line);) {
    auto record = journal::parse_record(line);
    EXPECT_TRUE(record.has_value()) << line;
    if (record) records.push_back(std::move(*record));
  }
  return records;
}

std::size_t DdsRun::count(const std::string& kind, const std::string& key,
                          const std::string& value) const {
  const std::vector<journal::Record> all = records();
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const auto& record) {
    return record.kind() == kind && record.text(key) == value;
  }));
}

Answered DdsRun::skein(std::vector<std::string> words) {
  wait_for_output("the mission starts");
  const std::string said = output();
  const std::string before = "on DDS domain ";
  const std::size_t at = said.find(before);
  if (at == std::string::npos) return {-1, "no domain is said"};
  const std::string log = file("asked-" + std::to_string(++asked_)).string();
  words.insert(words.begin(), kPrograms + "/skein");
  words.insert(words.begin() + 2,
               {"--domain", std::to_string(std::stoi(said.substr(at + before.size())))});
  auto process = run_tool::Process::start(words, log);
  if (!process) return {-1, process.error().why};
  holds_within(60, [&] { return process->poll().has_value(); });
  std::ifstream in(log);
  const auto status = process->poll();
  return {status ? status->code : -1, {std::istreambuf_iterator<char>(in), {}}};
}

std::vector<DdsRun::Daemon> DdsRun::pids() const {
  const std::string scenario = (folder_ / "scenario.yaml").string();
  std::vector<Daemon> daemons;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto pid = static_cast<pid_t>(std::stol(name));
    const std::vector<std::string> command = command_of(pid);
    const bool ours = std::find(command.begin(), command.end(), scenario) != command.end();
    if (ours && !(process_ && pid == process_->pid())) {
      daemons.push_back({pid, daemon_name(command)});
    }
  }
  return daemons;
}

std::set<std::string> DdsRun::names_of(const std::vector<Daemon>& daemons) {
  std::set<std::string> names;
  for (const Daemon& daemon : daemons) names.insert(daemon.name);
  return names;
}

void expect_all_met(const std::string& scenario, const std::string& rate) {
  DdsRun run;
  run.take_scenario_of(scenario);

  run.start({"--rate", rate});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_EQ(run.count("mission", "state", "finished"), 1U);
  EXPECT_EQ(run.count("dropped", "kind", "dropped"), 0U);
  EXPECT_TRUE(run.nothing_runs());
}

}  // namespace skein::testing
