// SPDX-License-Identifier: Apache-2.0
#include "interaction/joint.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "skein/foundation/joined.hpp"
#include "skein/interaction/role_fit.hpp"

namespace skein::decision_node {

namespace {

using interaction::ParameterType;

constexpr std::string_view kEveryOther = "R*";

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

Result<Argument, Failure> argument_of(const interaction::Parameter& wanted,
                                      const executive::Parameter* given) {
  const auto refuse = [&](const std::string& why) {
    return failure("parameter '" + wanted.name + "' " + why);
  };
  if (given == nullptr) return refuse("is missing");
  switch (wanted.type) {
    case ParameterType::kTime:
    case ParameterType::kNumber:
      if (given->numbers.size() != 1) return refuse("is not a number");
      return Argument(given->numbers[0]);
    case ParameterType::kUavList:
      return Argument(words_of(given->text));
    case ParameterType::kObj:
    case ParameterType::kPoint:
      if (!given->text.empty()) return Argument(given->text);
      if (given->numbers.size() != 3) return refuse("is no place");
      return Argument(
          interaction::Position{given->numbers[0], given->numbers[1], given->numbers[2]});
    case ParameterType::kText:
      break;
  }
  return Argument(given->text);
}

std::string text_of(const executive::Parameter& parameter) {
  if (!parameter.text.empty()) return parameter.text;
  std::string text;
  for (const double number : parameter.numbers) {
    std::ostringstream one;
    one << number;
    text += (text.empty() ? "" : ",") + one.str();
  }
  return text;
}

// The members as the model's parameter of type UAVlist has them.
std::vector<std::string> members_of(const Joint& joint) {
  for (const interaction::Parameter& one : joint.variant->parameters) {
    if (one.type == ParameterType::kUavList) {
      return std::get<std::vector<std::string>>(joint.arguments.at(one.name));
    }
  }
  return {};
}

std::string problem_of_members(const std::vector<std::string>& members, const std::string& self,
                               const std::vector<std::string>& team) {
  if (std::find(members.begin(), members.end(), self) == members.end()) {
    return "'" + self + "' is not among its members";
  }
  for (const std::string& one : members) {
    if (one != self && std::find(team.begin(), team.end(), one) == team.end()) {
      return "no UAV '" + one + "'";
    }
  }
  if (std::adjacent_find(members.begin(), members.end()) != members.end()) {
    return "a member is named twice";
  }
  return "";
}

Result<Arguments, Failure> read_arguments(const interaction::Variant& variant,
                                          const executive::Parameters& given) {
  Arguments arguments;
  for (const interaction::Parameter& wanted : variant.parameters) {
    auto argument = argument_of(wanted, given.find(wanted.name));
    if (!argument) return tl::unexpected(argument.error());
    arguments.emplace(wanted.name, std::move(*argument));
  }
  return arguments;
}

std::string subject_of(const Joint& joint, const executive::Parameters& given) {
  std::vector<std::string> texts;
  for (const interaction::Parameter& one : joint.variant->parameters) {
    if (one.type != ParameterType::kUavList) texts.push_back(text_of(*given.find(one.name)));
  }
  return joint.model + "(" + joined(texts, " ") + ") of " + joined(joint.members, ", ");
}

}  // namespace

Result<Joint, Failure> joint_of(const mission::ElementaryTask& task,
                                const std::shared_ptr<const interaction::Library>& library,
                                const std::string& self, const std::vector<std::string>& team) {
  if (library == nullptr) return failure("the scenario has no interaction models");
  Joint joint;
  joint.task = task.id;
  joint.library = library;
  joint.model = task.type.substr(executive::kJointPrefix.size());
  const auto model = library->models.find(joint.model);
  if (model == library->models.end()) return failure("no interaction model '" + joint.model + "'");
  joint.hash = hash_of(*library, joint.model);
  // All variants take the same parameters.
  joint.variant = &model->second.variants.front();
  auto arguments = read_arguments(*joint.variant, task.parameters);
  if (!arguments) return tl::unexpected(arguments.error());
  joint.arguments = std::move(*arguments);
  joint.members = members_of(joint);
  std::sort(joint.members.begin(), joint.members.end());
  if (std::string why = problem_of_members(joint.members, self, team); !why.empty()) {
    return failure(std::move(why));
  }
  joint.variant = variant_for(model->second, joint.members.size());
  if (joint.variant == nullptr) {
    return failure("no variant of '" + joint.model + "' for " +
                   std::to_string(joint.members.size()) + " UAVs");
  }
  joint.subject = subject_of(joint, task.parameters);
  return joint;
}

namespace {

executive::Parameter parameter_of(const std::string& name, const mission::Argument& argument) {
  executive::Parameter parameter{name, "", {}};
  if (const auto* text = std::get_if<std::string>(&argument)) parameter.text = *text;
  if (const auto* number = std::get_if<double>(&argument)) parameter.numbers = {*number};
  if (const auto* at = std::get_if<world::Vector3>(&argument)) {
    parameter.numbers = {at->x(), at->y(), at->z()};
  }
  if (const auto* names = std::get_if<std::vector<std::string>>(&argument)) {
    parameter.text = joined(*names, " ");
  }
  return parameter;
}

}  // namespace

mission::ElementaryTask as_planned(const mission::HighLevelTask& task,
                                   const interaction::Library& library) {
  mission::ElementaryTask result;
  result.id = executive::TaskId(task.id.value());
  result.type = std::string(executive::kJointPrefix) + task.name;
  result.time = task.time;
  const auto model = library.models.find(task.name);
  if (model == library.models.end()) return result;
  const interaction::Parameters& wanted = model->second.variants.front().parameters;
  for (std::size_t i = 0; i < std::min(wanted.size(), task.arguments.size()); ++i) {
    result.parameters.add(parameter_of(wanted[i].name, task.arguments[i]));
  }
  return result;
}

std::optional<std::string> difference(const Joint& joint, const std::string& other_subject) {
  const std::string before = joint.model + "(", after = ") of " + joined(joint.members, ", ");
  const auto values = [&](const std::string& subject) -> std::vector<std::string> {
    const bool is_alike = subject.starts_with(before) && subject.ends_with(after) &&
                          subject.size() > before.size() + after.size();
    if (!is_alike) return {};
    return words_of(subject.substr(before.size(), subject.size() - before.size() - after.size()));
  };
  const std::vector<std::string> mine = values(joint.subject), theirs = values(other_subject);
  if (mine.empty() || mine.size() != theirs.size() || mine.front() != theirs.front())
    return std::nullopt;
  std::vector<std::string> different;
  std::size_t i = 0;
  for (const interaction::Parameter& one : joint.variant->parameters) {
    if (one.type == ParameterType::kUavList || i == mine.size()) continue;
    if (mine[i] != theirs[i]) different.push_back(one.name + " " + theirs[i] + ", not " + mine[i]);
    ++i;
  }
  return different.empty() ? std::nullopt : std::optional(joined(different, "; "));
}

std::vector<std::string> Joint::others(const std::string& self) const {
  std::vector<std::string> others = members;
  std::erase(others, self);
  return others;
}

interaction::JointTaskStatus status_of(const Joint& joint, const std::string& uav) {
  interaction::JointTaskStatus status;
  status.uav = uav;
  status.subject = joint.subject;
  status.task = joint.task.value();
  status.model = joint.model;
  status.variant = joint.variant->name;
  status.hash = joint.hash;
  return status;
}

std::optional<Joint> among(const Joint& joint, const std::vector<std::string>& members) {
  const interaction::Variant* variant =
      variant_for(joint.library->models.at(joint.model), members.size());
  if (variant == nullptr) return std::nullopt;
  Joint fewer = joint;
  fewer.variant = variant;
  fewer.members = members;
  for (const interaction::Parameter& one : variant->parameters)
    if (one.type == ParameterType::kUavList) fewer.arguments.insert_or_assign(one.name, members);
  return fewer;
}

std::map<std::string, double> numbers_of(const Arguments& arguments) {
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : arguments)
    if (const auto* number = std::get_if<double>(&value)) numbers[name] = *number;
  return numbers;
}

Arguments arguments_of(const Joint& joint, const std::string& role) {
  Arguments result;
  const auto table = joint.variant->table.parameters.find(role);
  if (table == joint.variant->table.parameters.end()) return result;
  for (const auto& [own, of_model] : table->second) {
    result.emplace(own, joint.arguments.at(of_model));
  }
  return result;
}

Result<Argument, Failure> value_of(const config::Value& expression, const Arguments& scope) {
  using Kind = config::Value::Kind;
  if (expression.kind == Kind::kScalar) {
    const std::string& text = expression.scalar;
    if (expression.quoted) return Argument(text);
    if (const auto known = scope.find(text); known != scope.end()) return known->second;
    double number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec == std::errc() && read.ptr == text.data() + text.size()) return Argument(number);
    return failure("'" + text + "' has no value");
  }
  interaction::Position position{};
  std::vector<std::string> names;
  for (const config::Value& item : expression.items) {
    if (names.size() < 3) {
      std::from_chars(item.scalar.data(), item.scalar.data() + item.scalar.size(),
                      position[names.size()]);
    }
    names.push_back(item.scalar);
  }
  double first = 0;
  const bool numbers =
      names.size() == 3 &&
      std::from_chars(names[0].data(), names[0].data() + names[0].size(), first).ec == std::errc();
  return numbers ? Argument(position) : Argument(names);
}

// ---- spatial constraints ----

namespace {

std::vector<std::string> holders_of(const std::string& role, const Holders& holders) {
  std::vector<std::string> all;
  for (const auto& [uav, held] : holders) {
    if (held == role) all.push_back(uav);
  }
  return all;
}

bool is_role(const Joint& joint, const std::string& name) {
  const auto& roles = joint.variant->roles;
  return std::find(roles.begin(), roles.end(), name) != roles.end();
}

std::vector<std::string> names_of(const Joint& joint, const std::string& word,
                                  const Holders& holders, const std::string& self) {
  if (word == kEveryOther) {
    std::vector<std::string> others;
    for (const auto& [uav, role] : holders) {
      if (uav != self) others.push_back(uav);
    }
    return others;
  }
  if (is_role(joint, word)) return holders_of(word, holders);
  const auto argument = joint.arguments.find(word);
  if (argument == joint.arguments.end()) return {word};
  if (const auto* name = std::get_if<std::string>(&argument->second)) return {*name};
  return {word};
}

}  // namespace

interaction::ScmBinding binding_of(const Joint& joint, const interaction::ScmInstance& instance,
                                   const Holders& holders, const std::string& self) {
  interaction::ScmBinding binding;
  const interaction::Scm& scm = joint.library->scms.at(instance.scm);
  for (const interaction::Scm::Formal& formal : scm.parameters) {
    const interaction::Term& term = instance.arguments.at(formal.name);
    const auto* word = std::get_if<std::string>(&term);
    if (formal.place) {
      binding.places[formal.name] = names_of(joint, *word, holders, self);
    } else if (word == nullptr) {
      binding.numbers[formal.name] = std::get<double>(term);
    } else {
      binding.numbers[formal.name] = std::get<double>(joint.arguments.at(*word));
    }
  }
  return binding;
}

bool is_about_places(const Joint& joint, const interaction::ScmInstance& instance) {
  return std::none_of(instance.arguments.begin(), instance.arguments.end(), [&](const auto& one) {
    const auto* word = std::get_if<std::string>(&one.second);
    return word != nullptr && (*word == kEveryOther || is_role(joint, *word));
  });
}

bool outweigh(const Holders& theirs, const Holders& mine) {
  const auto without = [](Holders all, const Holders& others) {
    for (const auto& [uav, role] : others) all.erase(uav);
    return all;
  };
  const Holders apart = without(mine, theirs);
  Holders others = without(theirs, mine);
  if (others.empty()) others = theirs;  // whom they have lost is not yet aware of it
  if (apart.empty() || others.size() != apart.size()) return others.size() > apart.size();
  return others.begin()->first < apart.begin()->first;
}

}  // namespace skein::decision_node
