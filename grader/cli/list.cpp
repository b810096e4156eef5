#include "cli/commands.hpp"

#include "assignment/assignment.hpp"
#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

namespace ggrade::cli {

using gg::say;

namespace {

double points(const Part& part, results::ItemKind kind) {
  double sum = 0;
  for (const ItemDeclaration& item : part.items)
    if (item.kind == kind) sum += item.points;
  return sum;
}

void list(bool asJson) {
  nlohmann::json all = nlohmann::json::array();
  for (const Assignment& assignment : loadAssignments(assignmentsFolder())) {
    nlohmann::json parts = nlohmann::json::array();
    for (const Part& part : assignment.parts)
      parts.push_back({{"id", part.id},
                       {"title", part.title},
                       {"points", points(part, results::ItemKind::gain)},
                       {"bonus", points(part, results::ItemKind::bonus)},
                       {"todos", part.todos.size()}});
    all.push_back({{"id", assignment.id},
                   {"title", assignment.title},
                   {"files", assignment.files},
                   {"files_optional", assignment.optionalFiles},
                   {"parts", parts}});
  }
  if (asJson) {
    std::cout << all.dump(2) << '\n';
    return;
  }
  for (const auto& assignment : all) {
    fmt::print("{}  {}\n", assignment["id"].get<std::string>(),
               assignment["title"].get<std::string>());
    for (const auto& part : assignment["parts"]) {
      const int todos = part["todos"].get<int>();
      const std::string worth =
          say("{} points + {} bonus, {}", part["points"].get<double>(), part["bonus"].get<double>(),
              todos == 1 ? say("1 TODO") : say("{} TODOs", todos));
      if (part["id"] == assignment["id"]) // its name and title stand above
        fmt::print("  {}\n", worth);
      else
        fmt::print("  {:<14} {}  {}\n", part["id"].get<std::string>(), worth,
                   part["title"].get<std::string>());
    }
    const auto joined = [&](const char* names) {
      return fmt::format("{}", fmt::join(assignment[names].get<std::vector<std::string>>(), " "));
    };
    fmt::print("  {}\n  {}\n", say("edit: {}", joined("files")),
               say("may add: {}", joined("files_optional")));
  }
}

} // namespace

void addList(CLI::App& app) {
  auto* command =
      app.add_subcommand("list", say("The assignments, their points and editable files"));
  sayHelp(*command);
  auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, say("Print JSON on stdout"));
  command->footer(say("Example:\n  ggrade list"));
  command->callback([asJson] { list(*asJson); });
}

} // namespace ggrade::cli
