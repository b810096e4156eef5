#include "check/hints.hpp"

#include "report/write_file.hpp"

#include <algorithm>

namespace ggrade::check {

using nlohmann::json;

Level lastLevel(const Checked& checked) {
  if (!checked.isPuzzle || checked.cause.empty()) return Level::where;
  return checked.hint.empty() ? Level::look : Level::why;
}

std::string lookOf(const Checked& checked) {
  std::string text = checked.cause;
  for (const std::string& title : checked.titles) text += "\n- " + title;
  return text;
}

std::string identityOf(const Checked& checked) {
  if (lastLevel(checked) == Level::where) return {};
  std::string todo;
  for (const Row& row : checked.rows)
    if (todo.empty() && row.state != State::done && row.state != State::notBegun) todo = row.todo;
  return todo + '\n' + lookOf(checked);
}

Told::Told(std::filesystem::path file) : file_(std::move(file)), told_(json::object()) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file_, none)) return;
  const json kept = json::parse(readFile(file_), nullptr, false);
  if (kept.is_object()) told_ = kept;
}

Level Told::of(const std::string& part, const Checked& checked) const {
  const json& one = told_.contains(part) ? told_.at(part) : json();
  if (!one.is_object() || one.value("fault", json()) != json(identityOf(checked)))
    return Level::where;
  const json level = one.value("level", json());
  if (!level.is_number_integer()) return Level::where;
  return Level(std::clamp(level.get<int>(), int(Level::where), int(lastLevel(checked))));
}

void Told::tellMore(const std::string& part, const Checked& checked) {
  const int level = std::min(int(of(part, checked)) + 1, int(lastLevel(checked)));
  told_[part] = {{"fault", identityOf(checked)}, {"level", level}};
  save();
}

void Told::settle(const std::string& part, const Checked& checked) {
  if (!checked.drawn || !allRight(checked.rows) || !told_.contains(part)) return;
  told_.erase(part);
  save();
}

void Told::save() const {
  report::makeFolder(file_.parent_path());
  report::writeFile(file_, told_.dump(1) + '\n');
}

} // namespace ggrade::check
