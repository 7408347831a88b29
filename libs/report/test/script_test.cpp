// SPDX-License-Identifier: Apache-2.0
// The page's script in a real browser, where there is one: no error, the cursor moves the markers,
// a drag zooms, a layer hides.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "builders.hpp"
#include "skein/report/report.hpp"
#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

namespace fs = std::filesystem;

// A browser that does not start says nothing about the script.
constexpr const char* kNoBrowser = "the browser did not start";

class Script : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "no chromium";
    const char* test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    directory_ = fs::path(::testing::TempDir()) /
                 ("skein_report_" + std::to_string(::getpid()) + "_" + test);
    fs::create_directories(directory_);
  }
  void TearDown() override {
    if (!directory_.empty()) fs::remove_all(directory_);
  }

  // What `probe` (the body of a function) returns inside the page of the synthetic mission.
  std::string result_of(const std::string& probe) {
    const RunInfo info = testing::comets_info();
    std::string html = html_report(info, testing::salvage(testing::comets_journal()).journal);
    // Before the page's own script, so that its errors are caught too.
    const std::string trap =
        "<script>window.onerror = (m) => { document.title = 'error: ' + m; };</script>";
    html.insert(html.find("<body>"), trap);
    html.insert(html.rfind("</body>"),
                "<script>if (!document.title.startsWith('error')) document.title = 'result: ' + "
                "(() => {" +
                    probe + "})();</script>");
    std::ofstream(directory_ / "page.html", std::ios::binary) << html;
    const std::string command =
        "timeout 35 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage "
        "--window-size=1280,2400 --user-data-dir='" +
        (directory_ / "profile").string() + "' --dump-dom 'file://" +
        (directory_ / "page.html").string() + "' > '" + (directory_ / "dom.html").string() +
        "' 2>/dev/null";
    if (std::system(command.c_str()) != 0) return kNoBrowser;
    std::ostringstream dom;
    dom << std::ifstream(directory_ / "dom.html").rdbuf();
    const std::string text = dom.str();
    const std::size_t begin = text.find("<title>") + 7;
    return text.substr(begin, text.find("</title>") - begin);
  }

  fs::path directory_;
};

constexpr const char* kMouse = R"(
  const svg = document.getElementById("timeline"), box = svg.getBoundingClientRect();
  const at = (share) => box.left + (132 + share * 1086) * box.width / 1232;
  const mouse = (name, share) => (name === "pointerup" ? window : svg).dispatchEvent(
    new PointerEvent(name, { clientX: at(share), clientY: box.top + 150, bubbles: true, button: 0 }));
)";

TEST_F(Script, TheCursorMovesClockTableAndMarkers) {
  const std::string result = result_of(std::string(kMouse) + R"(
    const marker = document.querySelector("#map .live"), before = marker.getAttribute("transform");
    mouse("pointermove", 0.6001);
    return [document.getElementById("clock").textContent,
            document.querySelector("#live-table .task").textContent,
            document.getElementById("live-phase").textContent,
            marker.getAttribute("transform") !== before].join("; ");
  )");

  if (result == kNoBrowser) GTEST_SKIP() << result;
  EXPECT_EQ(result, "result: 15:00; 12 wait, 13 takeshot; Monitoring; true");
}

TEST_F(Script, ADragZoomsAndAllComesBack) {
  const std::string result = result_of(std::string(kMouse) + R"(
    const bar = svg.querySelector(".bar .running"), width = () => Number(bar.getAttribute("width"));
    const whole = width();
    mouse("pointerdown", 0.2); mouse("pointermove", 0.3); mouse("pointermove", 0.4); mouse("pointerup", 0.4);
    const zoomed = width() / whole;
    document.getElementById("zoom-all").click();
    return [zoomed.toFixed(2), (width() / whole).toFixed(2)].join("; ");
  )");

  if (result == kNoBrowser) GTEST_SKIP() << result;
  EXPECT_EQ(result, "result: 5.00; 1.00");
}

TEST_F(Script, ALayerHides) {
  const std::string result = result_of(R"(
    const shown = () => getComputedStyle(document.querySelector("#timeline .messages")).display;
    const before = shown();
    document.querySelector("[data-layer=messages]").click();
    return before + "; " + shown();
  )");

  if (result == kNoBrowser) GTEST_SKIP() << result;
  EXPECT_EQ(result, "result: inline; none");
}

}  // namespace
}  // namespace skein::report
