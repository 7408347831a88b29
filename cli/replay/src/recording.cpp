// SPDX-License-Identifier: Apache-2.0
#include "recording.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "skein/recording/run.hpp"

namespace skein::replay_tool {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Result<void, Failure> check(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return failure(file.string() + " is not there: not the folder of a run of this version");
  if (fs::file_size(file, error) > recording::kMostBytes)
    return failure(file.string() + " is greater than a gigabyte");
  return {};
}

Result<void, Failure> read_world(const fs::path& file, Json& world, Recording& recording) {
  if (auto good = check(file); !good) return good;
  std::ifstream in(file);
  world = Json::parse(in, nullptr, false);
  if (!world.is_object() || !world.contains("uavs") || !world["uavs"].is_array())
    return failure(file.string() + ": expected an object with a list `uavs`");
  for (const Json& uav : world["uavs"]) {
    if (!uav.is_object() || !uav.contains("name") || !uav["name"].is_string())
      return failure(file.string() + ": a UAV without a name");
    recording.uavs.push_back(uav["name"]);
  }
  return {};
}

Result<void, Failure> read_events(const fs::path& file, Recording& recording) {
  if (auto good = check(file); !good) return good;
  std::ifstream in(file, std::ios::binary);
  Diagnostics damaged;
  recording.records =
      recording::read_events({std::istreambuf_iterator<char>(in), {}}, file.string(), damaged);
  recording.unreadable = damaged.size();
  if (recording.records.empty()) return failure(file.string() + " has no line that can be read");
  return {};
}

}  // namespace

Result<Recording, Failure> read_recording(const fs::path& folder) {
  Recording recording;
  Json world;
  if (auto read = read_world(folder / "world.json", world, recording); !read)
    return tl::unexpected(read.error());
  if (auto read = read_events(folder / "events.jsonl", recording); !read)
    return tl::unexpected(read.error());
  world["replay"] = {{"until", recording.until().to_seconds()}};
  recording.world = world.dump(-1, ' ', false, Json::error_handler_t::replace);
  return recording;
}

}  // namespace skein::replay_tool
