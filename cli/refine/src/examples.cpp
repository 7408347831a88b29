// SPDX-License-Identifier: Apache-2.0
#include "examples.hpp"

#include <array>
#include <utility>

namespace skein::refine_tool {
namespace {

using Texts = std::pair<std::string_view, std::string_view>;

constexpr std::string_view kWorld = R"(  "world": {
    "origin": {"latitude": 40.1094, "longitude": -8.2361, "altitude": 200},
    "terrain": {
      "west": -1000, "south": -1000, "east": 1000, "north": 1000, "cell": 20,
      "hills": [
        {"at": [-150, 150], "height": 160, "radius": 520},
        {"at": [520, -420], "height": 120, "radius": 420},
        {"at": [450, 600], "height": 90, "radius": 380}
      ]
    },
    "wind": {"toward": 0.6, "speed": 2, "gusts": 0.5},
    "airspace": {"floor": 0, "ceiling": 260, "voxel": 20},
    "no_fly": {"village": {"polygon": [[80, -620], [330, -620], [330, -250], [80, -250]]}},
    "zones": {"forest": [[-850, -300], [-250, -800], [50, -700], [-100, -150], [-700, 100]]},
    "places": {"pad": [-850, -850, 30], "lookout": [650, 850, 120], "east": [700, -100, 120]},
    "ground": {
      "cell": 40,
      "risk": {"base": 0.1, "peaks": [{"at": [-400, -350], "risk": 0.9, "radius": 300}]}
    },
    "radio": {"range": 1800, "line_of_sight": true, "latency": 0.02, "loss": 0.01}
  },
)";

constexpr std::string_view kHelicopter = R"({
    "model": "helicopter", "kind": "helicopter", "hovers": true,
    "speed": {"cruise": 10, "max": 15}, "climb_rate": 4, "descent_rate": 3, "acceleration": 2,
    "yaw_rate": 1, "ceiling": 150, "position_precision": 1, "wind_drift": 0.2,
    "energy": {"capacity": 5e6, "hover": 1000, "cruise": 1200, "climb": 500, "reserve": 0.1},
    "sensors": {
      "camera": {
        "aperture": 0.4, "pitch": -0.6, "gimballed": true, "range": 400, "period": 1,
        "position_spread": 3, "cost": 0.02,
        "quality": {"best_distance": 140, "at_range": 0.3, "incidence_power": 0.2},
        "sees": {"smoke": {"probability": 0.9, "confidence": 0.8}}
      }
    }
  })";

constexpr std::string_view kPlane = R"({
    "model": "plane", "kind": "fixed-wing", "hovers": false,
    "speed": {"min": 10, "cruise": 16, "max": 24}, "climb_rate": 3, "descent_rate": 4,
    "acceleration": 2, "min_turn_radius": 40, "orbit_radius": 60, "ceiling": 400,
    "position_precision": 2, "wind_drift": 0.5,
    "energy": {"capacity": 4e6, "hover": 300, "cruise": 450, "climb": 300, "reserve": 0.1},
    "sensors": {
      "mapping": {
        "aperture": 0.5, "pitch": -1.5708, "range": 300, "period": 1, "position_spread": 5,
        "sees": {"fire": {"probability": 0.7, "confidence": 0.7}}
      }
    }
  })";

/// What each asks; @H and @P stand for the vehicles.
constexpr std::array<Texts, 10> kQuestions = {{
    {"path", R"(  "vehicle": @P,
  "from": {"at": "pad", "height": 60}, "to": "east", "heading_from": 0.5,
  "clearance": 20,
  "contact": {"with": {"at": "pad", "height": 10}, "relays": [[-150, 150, 230]]}
)"},
    {"tour", R"(  "vehicle": @H,
  "start": "pad", "end": "pad", "clearance": 20,
  "stops": {
    "smoke": {"at": [-320, -420], "height": 60},
    "ridge": [-150, 150, 200],
    "east": "east",
    "lookout": "lookout",
    "forest": {"area": "forest", "swath": 90, "altitude": 60},
    "gate": {"entry": [-800, 500, 80], "exit": [-600, 800, 80], "inside": 45}
  }
)"},
    {"coverage", R"(  "vehicle": @P,
  "area": "forest", "device": "mapping", "altitude": 80,
  "holes": [[[-500, -400], [-400, -480], [-350, -380], [-450, -300]]],
  "start": "pad", "end": "pad"
)"},
    {"partition",
     R"(  "area": [[-900, -500], [-300, -900], [0, -800], [60, -200], [-500, 50], [-850, -100]],
  "mode": "balanced",
  "members": {
    "plane": {"vehicle": @P, "start": [-850, -850], "device": "mapping", "altitude": 100},
    "heli-1": {"vehicle": @H, "start": [-900, -200], "swath": 40, "altitude": 50},
    "heli-2": {"vehicle": @H, "start": [0, -850], "swath": 60, "altitude": 60, "speed": 8}
  }
)"},
    {"patrol", R"(  "vehicle": @H,
  "zone": "forest", "start": "pad", "altitude": 60, "footprint": 60, "duration": 2400
)"},
    {"viewpoint", R"(  "vehicle": @H,
  "device": "camera", "target": {"at": [-260, -60], "height": 1},
  "nearest": 140, "farthest": 350, "count": 3, "least_angle": 1.4,
  "from": [-420, -260, 120], "cost_of_way": 0.0004,
  "constraints": {"not from the north": {"sector": [2.4, -0.3]}}
)"},
    {"viewshed",
     R"(  "from": {"at": [-260, -60], "height": 80}, "height": 2, "range": 1500, "area": "forest"
)"},
    {"relay", R"(  "vehicle": @H,
  "a": {"at": "pad", "height": 5}, "b": [600, 700, 100], "most": 3, "least_margin": 1
)"},
    {"evaluate", R"(  "vehicle": @H,
  "way": ["pad", [-400, -500, 60], [200, -400, 60], [500, 100, 60], "lookout"], "clearance": 20
)"},
    {"insertion", R"(  "vehicle": @H,
  "start": "pad", "end": "pad", "clearance": 20,
  "plan": [
    {"at": {"at": [-320, -420], "height": 60}, "duration": 60},
    {"from": [500, 100, 120], "to": [700, 300, 120], "duration": 90}
  ],
  "task": {"at": "lookout", "duration": 30}
)"},
}};

void replace_all(std::string& text, std::string_view mark, std::string_view by) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
    text.replace(at, mark.size(), by);
}

}  // namespace

std::string example_of(std::string_view service) {
  for (const auto& [name, question] : kQuestions) {
    if (name != service) continue;
    std::string text = "{\n  \"service\": \"" + std::string(name) + "\",\n" + std::string(kWorld) +
                       std::string(question) + "}\n";
    replace_all(text, "@H", kHelicopter);
    replace_all(text, "@P", kPlane);
    return text;
  }
  return {};
}

}  // namespace skein::refine_tool
