#include "capture/gl_hooks.hpp"

#include <string_view>
#include <unordered_map>

namespace ggrade::capture {
namespace {

using Table = std::unordered_map<std::string_view, GlFunction>;

Table makeTable() {
  Table table;
  for (const std::span<const Hook> hooks :
       {glxHooks(), debugHooks(), errorHooks(), queryHooks(), windowBufferHooks(),
        shaderTimeHooks(), imageHooks(), drawHooks()}) {
    for (const Hook& hook : hooks) {
      const auto earlier = table.find(hook.name);
      if (hook.setNext) {
        const GlFunction next =
            earlier != table.end() ? earlier->second : realGlFunction(hook.name);
        if (!next) continue;
        hook.setNext(next);
      }
      table[hook.name] = hook.function;
    }
  }
  return table;
}

} // namespace

GlFunction hookedGlFunction(const char* name) {
  static const Table table = makeTable();
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

} // namespace ggrade::capture
