// SPDX-License-Identifier: Apache-2.0
#include "language/typed_list.hpp"

namespace skein::htn {

namespace {

std::vector<Expression> read_type(const ReadContext& context, Expression type) {
  if (context.is_name(type)) return {type};
  std::vector<Expression> all = parts(type);
  const bool either = !all.empty() && context.head(type) == context.words.either;
  for (std::size_t at = 1; either && at < all.size(); ++at) {
    if (context.is_name(all[at])) continue;
    context.error(all[at], text_of(all[at]) + " is no type", "the name of a type");
    return {};
  }
  if (!either || all.size() < 2) {
    context.error(type, text_of(type) + " is no type", "a type or (either type…)");
    return {};
  }
  all.erase(all.begin());
  return all;
}

}  // namespace

std::vector<TypedName> read_typed_list(const ReadContext& context, Expression list, TypedNames kind,
                                       Expression from) {
  std::vector<TypedName> out;
  const bool variables = kind == TypedNames::kVariables;
  // One variable without parentheses is met in old domains.
  if (variables && !from && context.is_variable(list)) return {{list, {}}};
  if (!context.is_list(list) && !context.is_nil(list)) {
    context.error(list, text_of(list) + " is no list",
                  variables ? "a list of variables" : "a list of names");
    return out;
  }
  std::size_t typed = 0;  // names that have their type
  for (Expression at = from ? from : first(list); at; at = next(at)) {
    if (context.is_symbol(at) && (*at).atom == context.words.dash) {
      if (!next(at)) {
        context.error(at, "no type behind '-'", "a type or (either type…)");
        break;
      }
      if (typed == out.size()) context.error(at, "nothing before '-' to have a type");
      at = next(at);
      const std::vector<Expression> types = read_type(context, at);
      for (; typed < out.size(); ++typed) out[typed].types = types;
    } else if (variables ? context.is_variable(at) : context.is_name(at)) {
      out.push_back({at, {}});
    } else {
      context.error(at, text_of(at) + " in a list of " + (variables ? "variables" : "names"),
                    variables ? "a variable" : "a name");
    }
  }
  return out;
}

}  // namespace skein::htn
