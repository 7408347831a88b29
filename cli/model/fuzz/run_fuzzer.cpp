// SPDX-License-Identifier: Apache-2.0
// Any bytes as a trace of a fixed automaton: no crash, the same output each time, each line ended.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "skein/model_tool/run_model.hpp"

namespace {

const std::string& automaton_file() {
  static const std::string file = [] {
    const std::string name = "/tmp/skein-model-fuzz-" + std::to_string(getpid()) + ".yaml";
    std::ofstream(name) << "{block: b, type: loop, scms: [s], exit: [[{message: stop}]], content: "
                           "[{task: t, type: goto}, {block: c, pre: [[{message: s violated}]], "
                           "content: [{action: a, modality: role-allocation}]}]}";
    return name;
  }();
  return file;
}

std::string play(const std::string& trace) {
  std::istringstream in(trace);
  std::ostringstream out, err;
  skein::model_tool::RunOptions options;
  options.automaton = automaton_file();
  options.until = skein::MissionTime::seconds(100);
  skein::model_tool::run_model(options, in, out, err);
  return out.str();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const std::string out = play(text);
  if (!out.empty() && out.back() != '\n') std::abort();
  if (play(text) != out) std::abort();
  return 0;
}
