// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <utility>

#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::functional {

namespace {

using config::Reader;

std::vector<std::string> read_names(const Reader& reader) {
  std::vector<std::string> names;
  std::set<std::string> met;
  if (!reader.present()) return names;
  for (const Reader& item : reader.items()) {
    names.push_back(item.text());
    if (!met.insert(names.back()).second) item.error("'" + names.back() + "' is there twice");
  }
  return names;
}

std::vector<Ending> read_endings(const Reader& reader) {
  std::vector<Ending> ends;
  for (const Reader& item : reader.items()) {
    ends.push_back(static_cast<Ending>(item.choice({"by-itself", "by-order", "by-stop"})));
  }
  if (reader.is_sequence() && ends.empty()) reader.error("it never ends", "at least one way to end");
  return ends;
}

// The devices are named by parameters, so they are parameters too.
void check_devices(const Reader& reader, const TaskType& type) {
  for (const std::string& device : type.devices) {
    if (!type.takes(device)) reader.error("'" + device + "' is none of its parameters");
  }
}

TaskType read_type(const std::string& name, const Reader& reader) {
  reader.keys({"parameters", "motion", "leaves", "devices", "radio", "carried-out-by", "ends"});
  TaskType type;
  type.name = name;
  if (reader.optional("parameters").present()) {
    type.parameters = read_names(reader.optional("parameters"));
  }
  type.motion = static_cast<Motion>(reader.optional("motion").choice({"none", "keeps", "moves"}));
  const Reader leaves = reader.optional("leaves");
  type.leaves = static_cast<Leaves>(leaves.choice({"as-it-was", "in-the-air", "on-the-ground"}));
  if (type.leaves != Leaves::kAsItWas && type.motion != Motion::kMoves) {
    leaves.error("only what moves the vehicle leaves it elsewhere", "motion: moves");
  }
  type.devices = read_names(reader.optional("devices"));
  check_devices(reader.optional("devices"), type);
  type.radio = reader.optional("radio").boolean();
  type.by = static_cast<CarriedOutBy>(reader.optional("carried-out-by")
                                          .choice({"functional-layer", "executive", "interaction"}));
  type.ends = read_endings(reader.required("ends"));
  return type;
}

}  // namespace

Result<TaskTypes, Diagnostics> read_task_types(std::string_view text, const std::string& file) {
  const auto value = config::parse_yaml(text, file);
  if (!value) return tl::unexpected<Diagnostics>(value.error());
  Diagnostics problems;
  const Reader root(*value, file, problems);
  root.keys({"task-types"});
  TaskTypes types;
  for (const auto& [name, reader] : root.required("task-types").entries()) {
    if (name.empty() || name == "*") reader.error("a type has an empty name");
    types.declare(read_type(name, reader));
  }
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  return types;
}

}  // namespace skein::functional
