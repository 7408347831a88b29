// SPDX-License-Identifier: Apache-2.0
// What most of the project includes, compiled once (cmake/SkeinLibrary.cmake). Every source and
// header still names what it uses: the check of headers alone compiles without this.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <tl/expected.hpp>
