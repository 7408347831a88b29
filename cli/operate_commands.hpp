// SPDX-License-Identifier: Apache-2.0
// The commands of operators: operate, status.
#pragma once

#include <functional>

namespace CLI {
class App;
}
namespace skein::operate_tool {
struct OperateOptions;
struct StatusOptions;
}  // namespace skein::operate_tool

namespace skein::cli {

/// `action` and `live` must outlive the parsing and the action.
void add_operate(CLI::App& app, std::function<int()>& action,
                 const std::function<int(const operate_tool::OperateOptions&)>& live);
void add_status(CLI::App& app, std::function<int()>& action,
                const std::function<int(const operate_tool::StatusOptions&)>& live);

}  // namespace skein::cli
