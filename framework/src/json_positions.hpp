#pragma once
/// \file
/// JSON read with the line of every value.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gg/declarations.hpp>

namespace gg::detail {

/// A JSON value as far as a scene can use it.
struct JsonValue {
  enum class Kind { null, boolean, number, text, numbers, mixedArray, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string text = {};
  std::vector<double> numbers = {}; ///< an array of nothing but numbers
  std::string shown = {};           ///< as it is written, for messages; cut when long
};

/// A value and where it stands.
struct JsonEntry {
  std::string path; ///< dotted
  int line;         ///< from 1
  JsonValue value;
};

/// All values in the order of the file: every object (but the outermost) comes before what it
/// holds. Throws SceneError, as `name:line: what`, for text that is not JSON, not UTF-8, nested too
/// deeply, not an object at its outermost, or that has a key twice.
std::vector<JsonEntry> readJson(std::string_view text, const std::string& name);

/// The value in the type that the declaration wants; nothing if it isn't allowed there.
std::optional<SceneValue> convert(const KeyDeclaration& key, const JsonValue& value);

/// The text between quotes, cut when long.
std::string inQuotes(std::string_view text);

} // namespace gg::detail
