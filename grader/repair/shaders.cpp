#include "repair/shaders.hpp"

#include "repair/glsl.hpp"

#include <algorithm>
#include <iterator>

namespace ggrade::repair {

std::vector<ShaderUnit> shaderUnits(const std::string& stage, const std::string& source,
                                    const std::string& reference) {
  std::vector<ShaderUnit> units;
  const auto add = [&](const std::string& name, const GlslText& own, const GlslText& wanted) {
    ShaderUnit& unit = units.emplace_back(name, own.words != wanted.words);
    if (!unit.differs) return;
    unit.source = source;
    unit.source.replace(own.begin, own.end - own.begin,
                        reference.substr(wanted.begin, wanted.end - wanted.begin));
    std::ranges::set_difference(wanted.lines, own.lines,
                                std::inserter(unit.lacks, unit.lacks.end()));
    unit.adds = !std::ranges::includes(wanted.lines, own.lines);
  };
  const auto functions = functionsOf(source), wanted = functionsOf(reference);
  ShaderUnit whole{"shader " + stage};
  whole.source = reference;
  whole.differs = restOf(source) != restOf(reference) || functions.size() != wanted.size();
  whole.adds =
      std::ranges::any_of(functions, [&](const auto& one) { return !wanted.contains(one.first); });
  for (const auto& [name, function] : wanted) {
    const auto own = functions.find(name);
    if (own == functions.end()) {
      whole.lacks.insert(function.lines.begin(), function.lines.end());
      continue;
    }
    const std::string place = name + " in " + stage;
    const auto steps = stepsOf(source, own->second);
    for (const auto& [todo, text] : stepsOf(reference, function))
      if (const auto step = steps.find(todo); step != steps.end())
        add("lines " + todo + " of " + place, step->second, text);
    add("function " + place, own->second, function);
    const ShaderUnit& unit = units.back();
    whole.differs |= unit.differs;
    whole.lacks.insert(unit.lacks.begin(), unit.lacks.end());
    whole.adds |= unit.adds;
  }
  units.push_back(std::move(whole));
  return units;
}

} // namespace ggrade::repair
