// SPDX-License-Identifier: Apache-2.0
// The page as a whole.
#include "page/assets.hpp"
#include "page/views.hpp"
#include "skein/report/report.hpp"

namespace skein::report {

namespace {

void write_head(Markup& out, const RunInfo& info) {
  out.open("head");
  out.leaf("meta", {{"charset", "utf-8"}});
  out.leaf("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  out.leaf("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  out.element("title", {}, info.scenario + " · Skein report");
  out.open("style").raw(kReportCss).close();
  out.close().line_break();
}

void write_controls(Markup& out) {
  out.open("div", {{"class", "controls needs-script"}});
  out.element("button", {{"id", "play"}, {"type", "button"}, {"aria-label", "Play"}}, "▶");
  out.leaf("input", {{"id", "seek"},
                     {"type", "range"},
                     {"min", "0"},
                     {"max", "1000"},
                     {"step", "any"},
                     {"aria-label", "Mission time"}});
  out.element("output", {{"id", "clock"}}, "0:00");
  out.open("select", {{"id", "speed"}, {"aria-label", "Replay speed"}});
  for (const char* speed : {"10", "30", "60", "120"}) {
    out.element("option", {{"value", speed}}, "× " + std::string(speed));
  }
  out.close();
  out.element("button", {{"id", "zoom-in"}, {"type", "button"}, {"title", "Zoom in"}}, "+");
  out.element("button", {{"id", "zoom-out"}, {"type", "button"}, {"title", "Zoom out"}}, "−");
  out.element("button", {{"id", "zoom-all"}, {"type", "button"}, {"title", "Whole run"}}, "all");
  for (const char* layer : {"messages", "syncs", "externals", "temporal", "flags", "scheduled"}) {
    out.open("label");
    out.leaf("input", {{"type", "checkbox"}, {"checked", "checked"}, {"data-layer", layer}});
    out.text(layer).close();
  }
  out.close().line_break();
}

void write_body(Markup& out, const Run& run) {
  const MapFrame frame = frame_map(run.info, run.story);
  out.open("main");
  write_header(out, run);
  out.open("div", {{"class", "columns"}});
  out.open("section", {{"class", "card map-card"}});
  write_map(out, run, frame);
  write_map_legend(out, run);
  out.close();
  out.open("div", {{"class", "side"}});
  write_expectations(out, run);
  write_live_table(out, run);
  write_event_list(out, run);
  out.close().close();
  out.open("section", {{"class", "card timeline-card"}});
  out.element("h2", {}, "Chronology");
  write_controls(out);
  write_timeline(out, run);
  write_timeline_legend(out);
  out.close();
  write_goal_table(out, run);
  write_auction_table(out, run);
  write_decision_table(out, run);
  write_negotiations(out, run);
  write_explained_tasks(out, run);
  write_uav_table(out, run);
  out.open("div", {{"class", "pair"}});
  write_message_table(out, run);
  write_link_table(out, run);
  out.close();
  out.element("footer", {},
              "Skein " + run.info.version +
                  ". Positions in metres east, north, up of the scenario's origin; "
                  "times are mission time.");
  out.close();
  out.open("script", {{"type", "application/json"}, {"id", "data"}});
  out.raw(page_data(run, frame)).close();
  out.open("script").raw(kReportJs).close();
}

void write_key(Markup& out, std::string_view icon, std::string_view text) {
  out.open("span", {{"class", "key"}});
  out.open("svg",
           {{"viewBox", "0 0 28 14"}, {"width", 28}, {"height", 14}, {"aria-hidden", "true"}});
  out.raw(icon).close().text(text).close();
}

}  // namespace

void write_timeline_legend(Markup& out) {
  out.open("div", {{"class", "legend"}});
  const std::pair<const char*, const char*> keys[] = {
      {"<g class='bar u0'><rect class='scheduled' y='1' width='28' height='12'/></g>", "scheduled"},
      {"<g class='bar u0'><rect class='started' y='1' width='28' height='12'/></g>", "started"},
      {"<g class='bar u0'><rect class='running' y='1' width='28' height='12'/></g>", "running"},
      {"<g class='bar u0'><rect class='aborting' y='1' width='28' height='12'/>"
       "<rect class='hatched' y='1' width='28' height='12'/></g>",
       "aborting"},
      {"<g class='bar u0'><rect class='running' y='1' width='22' height='12'/>"
       "<rect class='cap' x='21' y='0' width='2' height='14'/></g>",
       "ended"},
      {"<g class='bar u0'><rect class='running' y='1' width='20' height='12'/>"
       "<path class='cross' transform='translate(20 7)' d='M-4 -4L4 4M-4 4L4 -4'/></g>",
       "aborted"},
      {"<g class='bar u0'><rect class='promise' y='5' width='28' height='4'/>"
       "<rect class='certain' x='8' y='5' width='12' height='4'/></g>",
       "planned: may be, must be under way"},
      {"<g class='sync'><line x1='3' x2='25' y1='7' y2='7' marker-end='url(#sync-head)'/></g>",
       "synchronisation (pale: said again)"},
      {"<g class='message'><line x1='3' x2='25' y1='7' y2='7' "
       "marker-end='url(#message-head)'/></g>",
       "radio message"},
      {"<g class='temporal u0'><line x1='14' x2='14' y1='0' y2='14'/>"
       "<line class='heard' x1='14' x2='14' y1='10' y2='14'/></g>",
       "temporal message: what lies between one's meetings"},
      {"<g class='external u0'><line x1='3' x2='25' y1='2' y2='12'/></g>",
       "external arc: who comes, who goes on then; what lies between is its slack"},
      {"<g class='trouble' transform='translate(14 7)'><path d='M-3 -3L3 3M-3 3L3 -3'/></g>",
       "lost or expired"},
      {"<g class='link'><rect class='up' y='3' width='14' height='7'/>"
       "<rect class='down' x='14' y='3' width='14' height='7'/></g>",
       "link up, down"},
      {"<g class='link'><rect class='believed' y='6' width='14' height='2'/>"
       "<rect class='unbelieved' x='14' y='6' width='14' height='2'/></g>",
       "believed reachable, not"},
      {"<g class='link'><rect class='relayed' y='6' width='28' height='2'/></g>",
       "reachable past a relay"}};
  for (const auto& [icon, text] : keys) write_key(out, icon, text);
  out.close().line_break();
}

std::string html_report(const RunInfo& info, const Journal& journal) {
  Journal ordered = journal;
  sort_by_time(ordered);
  const Chronology story = tell(info, ordered);
  const Statistics figures = measure(story, ordered);
  const Deliberation plans = tell_deliberation(ordered);
  const Run run{info, ordered, story, figures, plans};
  Markup out;
  out.raw("<!DOCTYPE html>\n").open("html", {{"lang", "en"}});
  write_head(out, info);
  out.open("body");
  write_body(out, run);
  out.close().close().line_break();
  return out.take();
}

}  // namespace skein::report
