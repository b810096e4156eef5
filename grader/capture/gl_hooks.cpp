#include "capture/gl_hooks.hpp"

#include "capture/channel_writer.hpp"
#include "capture/context.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string_view>
#include <unordered_map>

using ggrade::capture::GlFunction;

extern "C" {
// gl_entries.S
extern const char gg_glEntries[];
extern std::atomic<GlFunction> gg_glSlots[];
GlFunction gg_resolveSlot(std::uint32_t index);
}

namespace ggrade::capture {
namespace {

constexpr std::size_t kEntryBytes = 16;

#define GG_GL_NAME(index, name) #name,
constexpr const char* kNames[] = {
#include "gl_names.inc"
};
#undef GG_GL_NAME

std::uintptr_t returnZero() {
  return 0;
}

using Table = std::unordered_map<std::string_view, GlFunction>;

Table makeTable() {
  Table table;
  for (const std::span<const Hook> hooks :
       {glxHooks(), debugHooks(), errorHooks(), queryHooks(), windowBufferHooks(),
        shaderTimeHooks(), imageHooks(), drawHooks(), tapeHooks()}) {
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

/// The outermost hook of `name`, or null. A name that the context lacks has only hooks without a
/// `next`.
GlFunction hookedGlFunction(const char* name) {
  static const Table table = makeTable();
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

/// The hook or the context's function; null for a function that nobody serves.
GlFunction served(const char* name) {
  if (const GlFunction hook = hookedGlFunction(name)) return hook;
  return realGlFunction(name);
}

const char* const* findName(const char* name) {
  const auto less = [](const char* a, const char* b) { return std::strcmp(a, b) < 0; };
  const char* const* const found =
      std::lower_bound(std::begin(kNames), std::end(kNames), name, less);
  return found != std::end(kNames) && std::strcmp(*found, name) == 0 ? found : nullptr;
}

GlFunction entry(std::size_t index) {
  return reinterpret_cast<GlFunction>(const_cast<char*>(gg_glEntries) + kEntryBytes * index);
}

} // namespace

GlFunction realGlFunction(const char* name) {
  return contextLibrary().function(name);
}

int integer(unsigned int name) {
  static const auto getIntegerv = real<void (*)(unsigned int, int*)>("glGetIntegerv");
  int value = 0;
  getIntegerv(name, &value);
  return value;
}

GlFunction glFunction(const char* name) {
  if (const GlFunction function = served(name)) return function;
  const char* const* const found = findName(name);
  return found ? entry(static_cast<std::size_t>(found - kNames)) : nullptr;
}

} // namespace ggrade::capture

/// Called by an entry's first call. A function that nobody serves keeps its lazy stub, so that a
/// program that calls it is told, and carries on.
extern "C" GlFunction gg_resolveSlot(std::uint32_t index) {
  using namespace ggrade::capture;
  const char* const name = kNames[index];
  if (const GlFunction function = served(name)) {
    gg_glSlots[index].store(function, std::memory_order_relaxed);
    return function;
  }
  say("%s does not exist offscreen; the call did nothing and returned 0", name);
  return reinterpret_cast<GlFunction>(returnZero);
}
