// SPDX-License-Identifier: Apache-2.0
// Whatever an autopilot says, and whatever it is asked meanwhile, the bridge goes on: what it tells
// of the vehicle is finite, each frame it sends is whole, and it answers for tasks that it was
// given only.
//
// The bytes are what happens, one after the other: a message of the autopilot with any payload,
// bytes of the link, time, tasks.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <span>

#include "skein/autopilot/bridge.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace {

using namespace skein;             // NOLINT(google-build-using-namespace): what is fuzzed
using namespace skein::autopilot;  // NOLINT(google-build-using-namespace)

void require(bool condition) {
  if (!condition) std::abort();
}

const BridgeConfig& config() {
  static const BridgeConfig kConfig = [] {
    const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/marvin.yaml";
    std::ifstream in(path);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    world::TerrainSpec ground;
    ground.west = ground.south = -1000;
    ground.east = ground.north = 1000;
    ground.base = 120;
    return BridgeConfig{.uav = "heliv",
                        .model = world::read_vehicle_model(text, path).value(),
                        .terrain = world::Terrain(ground),
                        .origin = {37.3, -6, 150}};
  }();
  return kConfig;
}

/// What is left of the input; zeros after its end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> all) : left_(all) {}
  bool done() const { return left_.empty(); }
  std::uint8_t one() {
    if (left_.empty()) return 0;
    const std::uint8_t byte = left_.front();
    left_ = left_.subspan(1);
    return byte;
  }
  mavlink::Bytes some(std::size_t most) {
    const auto taken = left_.first(std::min(most, left_.size()));
    left_ = left_.subspan(taken.size());
    return {taken.begin(), taken.end()};
  }

 private:
  std::span<const std::uint8_t> left_;
};

class Flight {
 public:
  explicit Flight(Bytes bytes) : bytes_(bytes), bridge_(config()) {}

  void fly() {
    while (!bytes_.done()) step();
  }

 private:
  void step() {
    switch (bytes_.one() % 8) {
      case 0:
        return pass();
      case 1:
        return give(Heard{bytes_.some(bytes_.one())});
      case 2:
        return give(dispatch());
      case 3:
        return give(functional::Request{functional::Verb::kInterrupt, a_task()});
      case 4:
        return give(ContactLost{bytes_.one() % 2 == 0, bytes_.one() % 2 == 0});
      default:
        return hear();
    }
  }
  void pass() {
    for (int left = 1 + bytes_.one(); left > 0; --left) now_ = now_ + Bridge::kPeriod;
    give(Tick{});
  }
  /// The messages that the bridge reads, with bytes that nobody has checked.
  void hear() {
    constexpr std::uint32_t kMessages[] = {0, 1, 30, 33, 75, 76, 77, 147, 245, 253};
    mavlink::Frame frame;
    frame.from = {1, 1};
    frame.sequence = sequence_++;
    frame.message = kMessages[bytes_.one() % std::size(kMessages)];
    frame.payload = bytes_.some(std::max<std::size_t>(1, bytes_.one() % 64));
    if (frame.payload.empty()) frame.payload = {0};
    give(Heard{mavlink::to_bytes(frame)});
  }
  functional::Request dispatch() {
    constexpr const char* kTypes[] = {"takeoff",  "goto",     "land",    "wait",
                                      "takeshot", "perceive", "monitor", "follow"};
    constexpr const char* kNames[] = {"altitude", "waypoints", "speed", "duration",
                                      "number",   "period",    "at",    "target"};
    functional::Request request{functional::Verb::kDispatch, a_task(), kTypes[bytes_.one() % 8]};
    given_.insert(request.id);
    for (int left = bytes_.one() % 4; left > 0; --left) {
      std::vector<double> numbers;
      const char* const name = kNames[bytes_.one() % 8];
      for (int count = bytes_.one() % 8; count > 0; --count)
        numbers.push_back((bytes_.one() - 64) * 4.0);
      request.parameters.add(name, std::move(numbers));
    }
    return request;
  }
  functional::TaskId a_task() { return functional::TaskId(1U + bytes_.one() % 8U); }

  void give(const Input& input) {
    if (const auto* request = std::get_if<functional::Request>(&input)) given_.insert(request->id);
    for (const Effect& effect : bridge_.handle(input, now_)) look_at(effect);
  }
  void look_at(const Effect& effect) {
    if (const auto* told = std::get_if<world::Telemetry>(&effect)) {
      require(told->state.position.allFinite() && told->state.velocity.allFinite());
      require(std::abs(told->state.heading) <= 3.1415926536);
      require(told->state.energy >= 0 && told->state.energy <= 1);
    } else if (const auto* status = std::get_if<functional::Status>(&effect)) {
      require(given_.contains(status->id));
      require(status->state != functional::TaskState::kAborted || !status->reason.empty());
    } else if (const auto* sent = std::get_if<Transmit>(&effect)) {
      mavlink::Parser parser;
      require(parser.take(sent->bytes).size() == 1);
    }
  }

  Bytes bytes_;
  Bridge bridge_;
  Duration now_;
  std::uint8_t sequence_ = 0;
  std::set<functional::TaskId> given_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Flight(Bytes({data, size})).fly();
  return 0;
}
