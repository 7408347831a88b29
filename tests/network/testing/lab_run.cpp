// SPDX-License-Identifier: Apache-2.0
#include "testing/lab_run.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

namespace skein::testing {

namespace {

std::string text_in(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;  // of a process that is gone no more can be read, which is no exception
  text << in.rdbuf();
  return text.str();
}

bool holds_within(double seconds, const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    poll(nullptr, 0, 50);
  }
  return true;
}

}  // namespace

LabRun::LabRun()
    : folder_(fs::temp_directory_path() /
              ("skein-lab-" + std::to_string(getpid()) + "-" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

LabRun::~LabRun() {
  if (::testing::Test::HasFailure()) std::fputs(output().c_str(), stderr);
  process_.reset();
  std::error_code ignored;
  if (std::getenv("SKEIN_KEEP_LAB") == nullptr) fs::remove_all(folder_, ignored);
}

void LabRun::start(const std::string& scenario, const std::string& faults,
                   const std::vector<std::string>& options) {
  std::vector<std::string> command{SKEIN_SOURCE_DIR "/scripts/radio-lab",
                                   SKEIN_SOURCE_DIR "/scenarios/" + scenario + ".yaml",
                                   "--build",
                                   SKEIN_BINARY_DIR,
                                   "--out",
                                   out().string()};
  if (!faults.empty()) {
    const std::string script = SKEIN_SOURCE_DIR "/tests/network/faults/" + faults + ".yaml";
    command.insert(command.end(), {"--fault", script});
  }
  command.insert(command.end(), options.begin(), options.end());
  auto process = run_tool::Process::start(command, (folder_ / "output").string());
  ASSERT_TRUE(process.has_value()) << process.error().why;
  process_.emplace(std::move(*process));
}

std::optional<int> LabRun::wait(double seconds) {
  if (!holds_within(seconds, [&] { return process_->poll().has_value(); })) return std::nullopt;
  return process_->poll()->code;
}

bool LabRun::says(const std::string& text, double seconds) {
  return holds_within(seconds,
                      [&] {
                        return output().find(text) != std::string::npos ||
                               process_->poll().has_value();
                      }) &&
         output().find(text) != std::string::npos;
}

void LabRun::kill() {
  process_->send(SIGKILL);
  (void)wait(10);
}

bool LabRun::ends_within(double seconds) const {
  return holds_within(seconds, [&] { return processes().empty(); });
}

std::string LabRun::output() const { return text_in(folder_ / "output"); }

std::vector<journal::Record> LabRun::records() const {
  std::vector<journal::Record> records;
  std::ifstream in(out() / "events.jsonl");
  for (std::string line; std::getline(in, line);) {
    auto record = journal::parse_record(line);
    EXPECT_TRUE(record.has_value()) << line;
    if (record) records.push_back(std::move(*record));
  }
  return records;
}

Carried LabRun::carried() const {
  Carried sum;
  const auto air = nlohmann::json::parse(text_in(out() / "air.json"), nullptr, false);
  EXPECT_FALSE(air.is_discarded()) << "no air.json";
  if (air.is_discarded()) return sum;
  for (const auto& one : air["channels"]) {
    sum.carried += one["carried"].get<double>();
    sum.bytes += one["bytes"].get<double>();
    sum.lost += one["lost"].get<double>();
    sum.cut += one["cut"].get<double>();
    sum.overflowed += one["overflowed"].get<double>();
    sum.pieces += one["pieces"].get<double>();
  }
  return sum;
}

std::vector<pid_t> LabRun::processes() const {
  std::vector<pid_t> found;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator("/proc", gone)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const bool ours = text_in(entry.path() / "cmdline").find(folder_.string()) != std::string::npos;
    const auto pid = static_cast<pid_t>(std::stol(name));
    if (ours && pid != getpid()) found.push_back(pid);
  }
  return found;
}

}  // namespace skein::testing
