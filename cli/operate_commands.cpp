// SPDX-License-Identifier: Apache-2.0
#include "operate_commands.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "actions.hpp"
#include "argument_checks.hpp"
#include "network_options.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/operate_tool/operate.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

using Json = nlohmann::ordered_json;
using operate_tool::OperateOptions;
using operate_tool::StationOptions;
using operate_tool::StatusOptions;

constexpr const char* kOperateExamples = R"(
Examples:
  skein operate --domain 5 take marvin                    degree 1, in the hand of $USER
  skein operate --domain 5 go marvin 120,80 200,80 --altitude 50
  skein operate --domain 5 give-back marvin
  skein operate --domain 5 degree all 2
  skein operate --domain 5 mission survey.yaml            as after `mission:` in a scenario
  skein operate --domain 5 close tower 0,0 50,0 50,50 0,50 --ceiling 80
  skein operate --domain 5 --as bo ask marvin             whoever has it lets go, or keeps it
  echo '[{"finish": true}]' | skein operate --domain 5 do -
The same --number is one request however often it is given.
Exit codes: 0 all commands acknowledged, 1 refused or expired, 2 wrong options, 3 DDS refused,
4 no ground station answers.)";

constexpr const char* kStatusExamples = R"(
Examples:
  skein status --domain 5             what the ground station knows
  skein status --domain 5 --watch     again each second
  skein status --domain 5 --json
Exit codes: 0, 2 wrong options, 3 DDS refused, 4 no ground station is heard.)";

void add_station(CLI::App* command, StationOptions& station) {
  command->add_option("--domain", station.domain, "DDS domain id")
      ->check(CLI::Range(0, 100))
      ->envname("SKEIN_DOMAIN");
  add_network(command, station.network);
  command->add_option("--patience", station.patience, "Seconds for the ground station to be heard")
      ->check(positive_problem);
}

/// "120,80" or "120,80,60".
std::vector<double> point_of(const std::string& text) {
  std::vector<double> point;
  std::istringstream stream(text);
  for (std::string number; std::getline(stream, number, ',');) {
    point.push_back(std::stod(number));
  }
  return point;
}

std::string point_problem(const std::string& text) try {
  const auto size = point_of(text).size();
  const bool is_clean = text.find_first_not_of("0123456789.,-+e") == std::string::npos;
  return is_clean && (size == 2 || size == 3) ? "" : "expected X,Y or X,Y,Z, not '" + text + "'";
} catch (const std::exception&) {
  return "expected X,Y or X,Y,Z, not '" + text + "'";
}

Json points_of(const std::vector<std::string>& texts) {
  Json points = Json::array();
  for (const std::string& text : texts) points.push_back(point_of(text));
  return points;
}

/// What the sub-commands write: the request, made when one of them was given.
struct Words {
  std::string uav, name, text, to, file;
  std::vector<std::uint64_t> ids;
  std::vector<std::string> points;
  int degree = 0;
  std::uint64_t mission = 0, alarm = 0;
  double altitude = 0, floor = 0, ceiling = 0, from = 0, until = 0;
  bool interrupt = false, hold = false;
};

std::string file_text(const std::string& name) {
  if (name == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::ifstream file(name, std::ios::binary);
  if (!file) throw CLI::FileError::Missing(name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Adds sub-commands of `operate`; each makes the request.
class Verbs {
 public:
  Verbs(CLI::App& operate, OperateOptions& options) : operate_(operate), options_(options) {}

  void add_all() {
    add_hands();
    add_tasks();
    add_world();
    add_rest();
  }

 private:
  template <class Make>
  CLI::App* verb(const char* name, const char* help, const Make& make) {
    CLI::App* one = operate_.add_subcommand(name, help);
    one->callback([this, make] { options_.request = make(*words_); });
    return one;
  }
  template <class Fill>
  CLI::App* of_uav(const char* name, const char* help, const char* key, const Fill& fill) {
    CLI::App* one = verb(name, help, [key, fill](const Words& words) {
      Json what{{"uav", words.uav}};
      fill(words, what);
      return Json::array({{{key, std::move(what)}}}).dump();
    });
    one->add_option("uav", words_->uav, "Its name, or all")->required();
    return one;
  }

  void add_hands() {
    const auto nothing = [](const Words&, Json&) {};
    CLI::App* take = of_uav("take", "Take a UAV in hand: degree 1", "take_in_hand",
                            [](const Words& words, Json& what) {
                              if (words.interrupt) what["interrupt"] = true;
                            });
    take->add_flag("--interrupt", words_->interrupt, "What runs is interrupted");
    of_uav("give-back", "Give it back: the degree that it had", "give_back", nothing);
    of_uav("ask", "Ask who has it in hand to let go", "ask", nothing);
    of_uav("keep", "Keep it though another asks", "keep", nothing);
    CLI::App* let_go = of_uav("let-go", "Let go of it; its degree stays", "let_go",
                              [](const Words& words, Json& what) {
                                if (!words.to.empty()) what["to"] = words.to;
                              });
    let_go->add_option("--to", words_->to, "Operator who has it then");
    CLI::App* degree = of_uav("degree", "Change its degree of autonomy", "degree",
                              [](const Words& words, Json& what) {
                                what["to"] = words.degree;
                                if (words.interrupt) what["interrupt"] = true;
                                if (words.hold) what["resume"] = false;
                              });
    degree->add_option("to", words_->degree, "1 to 5")->required()->check(CLI::Range(1, 5));
    degree->add_flag("--interrupt", words_->interrupt, "What runs is interrupted");
    degree->add_flag("--hold", words_->hold, "Up to 4: what was handed over stays handed over");
  }

  void add_tasks() {
    CLI::App* abort =
        of_uav("abort", "Abort tasks, or all", "abort", [](const Words& words, Json& what) {
          if (!words.ids.empty()) what["tasks"] = words.ids;
        });
    abort->add_option("tasks", words_->ids, "Their ids; none: all");
    CLI::App* cancel = of_uav("cancel", "Cancel high-level tasks, or all", "cancel",
                              [](const Words& words, Json& what) {
                                if (words.mission != 0) {
                                  what["mission"] = words.mission;
                                } else if (words.ids.empty()) {
                                  what["goals"] = "all";
                                } else {
                                  what["goals"] = words.ids;
                                }
                              });
    CLI::Option* goals = cancel->add_option("goals", words_->ids, "Their ids; none: all");
    cancel->add_option("--mission", words_->mission, "Those of a unit mission")->excludes(goals);
    CLI::App* go = of_uav("go", "A UAV in hand flies there at once", "go",
                          [go_height = &go_height_](const Words& words, Json& what) {
                            what["to"] = points_of(words.points);
                            if ((*go_height)->count() > 0) what["altitude"] = words.altitude;
                          });
    go->add_option("points", words_->points, "X,Y or X,Y,Z [m]")->required()->check(point_problem);
    go_height_ = go->add_option("--altitude", words_->altitude, "Over the ground [m]");
    verb("mission", "Give a mission", [](const Words& words) { return file_text(words.file); })
        ->add_option("file", words_->file, "YAML, as after `mission:` in a scenario; -: input")
        ->required();
    of_uav("resume", "Start the plan that a UAV handed over", "resume_plan",
           [](const Words& words, Json& what) {
             if (!words.ids.empty()) what["without"] = words.ids;
           })
        ->add_option("--without", words_->ids, "Tasks that are discarded");
    of_uav("drop", "Discard the plan that a UAV handed over", "drop_plan",
           [](const Words&, Json&) {});
  }

  void add_world() {
    CLI::App* close = operate_.add_subcommand("close", "Close a volume of air");
    close->add_option("name", words_->name, "Of the volume")->required();
    close->add_option("corners", words_->points, "X,Y [m], three or more")
        ->required()
        ->check(point_problem);
    const auto bound = [&](const char* name, double& value, const char* help) {
      return std::pair(name + 2, std::pair(close->add_option(name, value, help), &value));
    };
    const std::vector bounds{bound("--floor", words_->floor, "[m]"),
                             bound("--ceiling", words_->ceiling, "[m]"),
                             bound("--from", words_->from, "Mission time [s]"),
                             bound("--until", words_->until, "Mission time [s]")};
    close->callback([this, bounds] {
      Json what{{"name", words_->name}, {"polygon", points_of(words_->points)}};
      for (const auto& [name, one] : bounds) {
        if (one.first->count() > 0) what[name] = *one.second;
      }
      options_.request = Json::array({{{"close_air", std::move(what)}}}).dump();
    });
    verb("open", "Open a volume of air again",
         [](const Words& words) {
           return Json::array({{{"open_air", {{"name", words.name}}}}}).dump();
         })
        ->add_option("name", words_->name, "Of the volume")
        ->required();
    CLI::App* judge = verb("judge", "Confirm or infirm an alarm", [](const Words& words) {
      const Json what{{"alarm", words.alarm}, {"as", words.text}};
      return Json::array({{{"judge_alarm", what}}}).dump();
    });
    judge->add_option("alarm", words_->alarm, "Its number")->required();
    judge->add_option("as", words_->text, "confirmed or infirmed")
        ->required()
        ->check(CLI::IsMember({"confirmed", "infirmed"}));
  }

  void add_rest() {
    verb("answer", "Answer what the script waits for",
         [](const Words& words) {
           return Json::array({{{"answer", words.text}}}).dump();
         })
        ->add_option("text", words_->text, "As the script has it")
        ->required();
    verb("finish", "End the mission", [](const Words&) {
      return Json::array({{{"finish", true}}}).dump();
    });
    verb("do", "Any actions of a script", [](const Words& words) { return file_text(words.file); })
        ->add_option("file", words_->file, "YAML or JSON; -: standard input")
        ->required();
  }

  CLI::App& operate_;
  OperateOptions& options_;
  std::shared_ptr<Words> words_ = std::make_shared<Words>();
  CLI::Option* go_height_ = nullptr;
};

}  // namespace

void add_operate(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<OperateOptions>();
  CLI::App* operate = app.add_subcommand("operate", "Be an operator of a running mission");
  operate->fallthrough();
  operate->require_subcommand(1);
  add_station(operate, options->station);
  operate->add_option("--as", options->who, "Name of the operator (default: SKEIN_OPERATOR, USER)");
  operate->add_option("--number", options->number,
                      "Of the request: it is done once (default: from the clock)");
  operate->add_flag("!--no-wait", options->wait, "Only until it is accepted or refused");
  operate->add_option("--limit", options->limit, "Seconds to wait for the commands' ends")
      ->check(positive_problem);
  operate->add_flag("--json", options->json, "The last answer as one JSON object");
  operate->footer(kOperateExamples);
  auto verbs = std::make_shared<Verbs>(*operate, *options);
  verbs->add_all();
  operate->callback([options, verbs, &action, &actions] {
    action = [options, &actions] { return actions.carry_out(*options); };
  });
}

void add_status(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* status = app.add_subcommand("status", "What the ground station of a mission knows");
  add_station(status, options->station);
  status->add_flag("--watch", options->watch, "Again each second");
  status->add_flag("--json", options->json, "One JSON document; with --watch one a line");
  status->footer(kStatusExamples);
  when_chosen(status, options, action, actions);
}

}  // namespace skein::cli
