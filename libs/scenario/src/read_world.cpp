// SPDX-License-Identifier: Apache-2.0
// The parts of a scenario about the vehicles and the faults.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "reading.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace skein::scenario {

namespace {

using config::Range;
using config::Reader;

constexpr Range kFraction{0, 1, ""};

void read_model(const Reader& reader, const std::string& folder, Diagnostics& diagnostics,
                UavSpec& uav) {
  uav.model_file = reader.text();
  if (uav.model_file.empty()) return;
  const std::string path = (std::filesystem::path(folder) / uav.model_file).string();
  const auto text = read_text_of(reader, "model file", path);
  if (!text) return;
  auto model = world::read_vehicle_model(*text, path);
  if (!model) {
    diagnostics.append(model.error());
  } else {
    uav.model = std::move(*model);
  }
}

void read_contact_loss(const Reader& reader, ContactLoss& loss) {
  if (!reader.keys({"policy", "after"})) return;
  loss.policy = static_cast<ContactLoss::Policy>(
      reader.required("policy").choice({"continue", "hold", "return"}));
  loss.after = read_seconds(reader.optional("after"), Duration::seconds(60));
}

bool usable_name(const std::string& name) {
  constexpr const char* kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  return !name.empty() && name.size() <= 32 &&
         name.find_first_not_of(kAllowed) == std::string::npos && name != "ground" &&
         name != "sim" && name != "runner" && name != "operator";
}

/// The name of the node that plays a UAV's vehicle: no UAV's.
std::string read_functional(const Reader& reader, const Reader& uavs) {
  if (!reader.present()) return "";
  const std::string name = reader.text();
  const bool is_uav = uavs.optional(name).present();
  if (name != "sim" && (!usable_name(name) || is_uav)) {
    reader.error(
        "'" + name + "' cannot be a functional layer's name",
        "sim, or 1 to 32 letters, digits, '-' or '_', and no UAV's, ground, runner or operator");
  }
  return name == "sim" ? "" : name;
}

}  // namespace

std::optional<std::string> read_text_of(const Reader& reader, const char* what,
                                        const std::string& path) {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (std::filesystem::is_regular_file(path, error) && in) {
    return std::string((std::istreambuf_iterator<char>(in)), {});
  }
  reader.error(std::string(what) + " '" + path + "' cannot be read");
  return std::nullopt;
}

void at_most_one_of(const Reader& reader, std::initializer_list<const char*> keys) {
  const char* first = nullptr;
  for (const char* key : keys) {
    if (!reader.optional(key).present()) continue;
    if (first != nullptr) {
      reader.optional(key).error(std::string("'") + key + "' beside '" + first + "'",
                                 "one of the two");
      return;
    }
    first = key;
  }
}

Duration read_seconds(const Reader& reader, Duration otherwise) {
  if (!reader.present()) return otherwise;
  return Duration::seconds(reader.number(0, {0, 1e7, "s"}));
}

void read_uavs(const Reader& reader, const std::string& folder, Diagnostics& diagnostics,
               std::vector<UavSpec>& uavs) {
  for (const auto& [name, uav] : entries_of(reader)) {
    UavSpec spec;
    spec.name = name;
    if (!usable_name(name)) {
      uav.error("'" + name + "' cannot be a UAV's name",
                "1 to 32 letters, digits, '-' or '_', and none of ground, sim, runner");
    }
    if (!uav.keys({"model", "abilities", "start", "heading", "energy", "degree", "contact_loss",
                   "functional"})) {
      continue;
    }
    read_model(uav.required("model"), folder, diagnostics, spec);
    world::read_abilities(uav.optional("abilities"), spec.model);
    spec.start = read_point_2d(uav.required("start"));
    spec.heading = uav.optional("heading").number(0, {-7, 7, "rad"});
    spec.energy = uav.optional("energy").number(1, kFraction);
    spec.degree = static_cast<int>(
        uav.optional("degree").integer(3, mission::kLeastDegree, mission::kGreatestDegree));
    if (spec.model.pilot) spec.contact_loss.policy = ContactLoss::Policy::kHold;
    read_contact_loss(uav.optional("contact_loss"), spec.contact_loss);
    spec.functional = read_functional(uav.optional("functional"), reader);
    uavs.push_back(std::move(spec));
  }
  if (uavs.empty() && reader.is_map()) reader.error("no UAV");
}

namespace {

void read_fault(const Reader& fault, const Names& names, FaultSpec& faults) {
  const MissionTime at = read_instant(fault.required("at"));
  const auto uav = [&](const Reader& of) { return of.name_among(names.uavs, "a UAV"); };
  if (const Reader kill = fault.optional("kill"); kill.present()) {
    KillSpec spec{at, kill.name_among(names.daemons, "a UAV, ground or sim"), std::nullopt,
                  fault.optional("forgets").boolean()};
    const Reader restart = fault.optional("restart_after");
    if (restart.present()) spec.restart_after = read_seconds(restart);
    faults.kills.push_back(std::move(spec));
  } else if (const Reader engine = fault.optional("engine"); engine.present()) {
    faults.breaks.push_back({at, uav(engine), ""});
  } else if (const Reader sensor = fault.optional("sensor"); sensor.present()) {
    sensor.keys({"uav", "device"});
    faults.breaks.push_back({at, uav(sensor.required("uav")), sensor.required("device").text()});
  } else if (const Reader slow = fault.optional("slow"); slow.present()) {
    slow.keys({"uav", "factor", "for"});
    faults.slows.push_back({at, uav(slow.required("uav")),
                            slow.required("factor").number(1, {1, 100, "times slower"}),
                            read_seconds(slow.required("for"))});
  } else if (const Reader abort = fault.optional("abort"); abort.present()) {
    abort.keys({"uav", "type", "for"});
    const auto types =
        functional::TaskTypes::shipped().names(functional::CarriedOutBy::kFunctionalLayer);
    faults.aborts.push_back({at, uav(abort.required("uav")),
                             abort.required("type").name_among(types, "a type of tasks"),
                             read_seconds(abort.optional("for"))});
  } else if (const Reader energy = fault.optional("energy"); energy.present()) {
    energy.keys({"uav", "left"});
    faults.energies.push_back(
        {at, uav(energy.required("uav")), energy.required("left").number(0, kFraction)});
  } else {
    fault.error("a fault of no kind", "one of kill, engine, sensor, slow, abort, energy, random");
  }
}

void read_random_faults(const Reader& random, RandomFaults& faults) {
  random.keys({"cuts_per_hour", "mean_cut", "kills_per_hour", "mean_dead"});
  faults = {random.optional("cuts_per_hour").number(0, {0, 1000, ""}),
            random.optional("mean_cut").number(20, {1, 3600, "s"}),
            random.optional("kills_per_hour").number(0, {0, 100, ""}),
            random.optional("mean_dead").number(5, {1, 3600, "s"})};
}

}  // namespace

void read_faults(const Reader& reader, const Names& names, FaultSpec& faults) {
  for (const Reader& fault : items_of(reader)) {
    fault.keys({"at", "kill", "restart_after", "forgets", "engine", "sensor", "slow", "abort",
                "energy", "random"});
    at_most_one_of(fault, {"kill", "engine", "sensor", "slow", "abort", "energy", "random"});
    if (const Reader random = fault.optional("random"); random.present()) {
      read_random_faults(random, faults.random);
    } else {
      read_fault(fault, names, faults);
    }
  }
}

}  // namespace skein::scenario
