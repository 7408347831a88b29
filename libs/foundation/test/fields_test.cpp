// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/fields.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace skein {
namespace {

struct Nothing {};
struct Point {
  double x = 0, y = 0;
  bool operator==(const Point&) const = default;
};
struct Thing {
  std::string name;
  std::optional<Point> at = {};
  std::vector<Point> way;
  std::map<std::string, double> figures = {};
  std::variant<int, Point, std::string> what;
  std::shared_ptr<const Point> shared;
  Point last;
  bool good = true;
};

struct Counter {
  template <class T>
  void operator()(const T& /*field*/) {
    ++fields;
  }
  std::size_t fields = 0;
};

template <class T>
std::size_t fields_of(const T& whole) {
  Counter counter;
  for_each_field(whole, counter);
  return counter.fields;
}

TEST(Fields, AreVisitedOnceEach) {
  EXPECT_EQ(fields_of(Nothing{}), 0U);
  EXPECT_EQ(fields_of(Point{}), 2U);
  EXPECT_EQ(fields_of(Thing{}), 8U);
}

TEST(Fields, ComeInTheirOrderWithTheirValues) {
  std::vector<double> seen;
  for_each_field(Point{3, 4}, [&](double value) { seen.push_back(value); });
  EXPECT_EQ(seen, (std::vector<double>{3, 4}));
}

}  // namespace
}  // namespace skein
