// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/draw_model.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "automaton_picture.hpp"
#include "skein/interaction/describe.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "testing/random_automaton.hpp"
#include "testing/small_library.hpp"

namespace skein::interaction {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t n = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1))
    ++n;
  return n;
}

TEST(DrawModel, ShowsRolesConditionsExitsAndWhereScmsHold) {
  const auto library = testing::library_of(testing::small_library());
  ASSERT_TRUE(library);

  const std::string svg = draw_svg(*library);

  EXPECT_THAT(svg, AllOf(HasSubstr(">looking, variant pair<"), HasSubstr(">looker × 1<"),
                         HasSubstr(">helper × 1 to 3<"),
                         HasSubstr(">needs hovering, camera: visible, endurance ≥ 900<"),
                         HasSubstr("when message &#39;ring violated&#39;"),
                         HasSubstr("spot := between(target, home)")));
  EXPECT_THAT(svg,
              HasSubstr("ring: distance to what &gt; 25 m, distance to what &lt; 50 m, azimuth "
                        "from what (0 to base) = 0 rad ± 0.1"));
  EXPECT_EQ(count(svg, ">ring<"), 2U) << "where it holds, and what it says";
  EXPECT_EQ(count(svg, "marker-end="), 1U) << "both sides of a correspondence are one arrow";
}

TEST(DrawModel, WordsAreEscaped) {
  const auto automaton = read_automaton(
      "{block: b, exit: [[{message: \"<a> & b\"}]], content: [{task: t, type: goto}]}", "a");
  ASSERT_TRUE(automaton);

  EXPECT_THAT(draw_svg(*automaton, "x < y"),
              AllOf(HasSubstr("&lt;a&gt; &amp; b"), HasSubstr("x &lt; y")));
}

// In any picture: what is inside lies inside, what is beside lies beside.
TEST(AutomatonPicture, BoxesAreInsideWhatIsAroundThemAndNeverOverlap) {
  const std::map<std::string, const char*> colours;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Automaton automaton = testing::RandomAutomaton(seed).make();
    AutomatonPicture picture(automaton, colours);
    SvgCanvas canvas;
    picture.draw(canvas, 10, 20);

    for (ComponelIndex i = 1; i < automaton.size(); ++i) {
      const auto& box = picture.box(i);
      const auto& around = picture.box(automaton[i].parent);
      ASSERT_GE(box.x, around.x);
      ASSERT_GE(box.y, around.y);
      ASSERT_LE(box.x + box.width, around.x + around.width);
      ASSERT_LE(box.y + box.height, around.y + around.height);
      for (const ComponelIndex other : automaton[automaton[i].parent].block()->content) {
        if (other <= i) continue;
        ASSERT_LE(box.y + box.height, picture.box(other).y) << "in document order";
      }
    }
  }
}

TEST(Describe, SaysConditionsInWords) {
  const auto automaton = read_automaton(R"(
block: b
type: loop
exit: [[{componel: t, state: over, not: true}, {message: go, effect: continue}],
       [{time: 5, since: "t:running", is: not-yet-passed, modality: optional}]]
content: [{task: t, type: goto}])",
                                        "a");
  ASSERT_TRUE(automaton);

  EXPECT_THAT(describe((*automaton)[0].block()->exit, *automaton),
              ElementsAre("not t over or message 'go' (begins anew)",
                          "and before 5 s after t running if it can"));
}

}  // namespace
}  // namespace skein::interaction
