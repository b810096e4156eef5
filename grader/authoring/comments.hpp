#pragma once
/// \file
/// Comments of a solution's files in Japanese, for kits whose readers prefer it.
///
/// They stand in the solution's folder, in `comments.ja.json`: what a comment says in English, with
/// single spaces, and its lines in Japanese.
///
///     "Pass \"mirror\": what is seen from below the floor, into a texture.": [
///       "パス\"mirror\"：床の下から見えるものを、テクスチャに描画する。"
///     ]
///
/// Code stays as it is, byte for byte. What was changed in English and not in this table stays
/// English, and is told.

#include "assignment/assignment.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::authoring {

/// What stands after `//` in lines that follow each other, in the same column and with the same
/// mark; the first may stand after code. A mark of a solution's block is none.
struct Comment {
  std::size_t line, count; ///< its first line, from 0, and how many
  std::size_t column;      ///< of `//` in each, in bytes
  std::string mark;        ///< `//`, `///` or `///<`
  std::string text;        ///< white space is put into single spaces
};

std::vector<Comment> commentsIn(std::string_view source);

/// Lines in Japanese, by a comment's text.
using Translations = std::map<std::string, std::vector<std::string>>;

/// Those of a solution; none if it has no table. Throws UsageError, naming the file.
Translations translationsIn(const std::filesystem::path& solutions);

/// The source with the comments that have a translation in Japanese.
std::string translated(std::string_view source, const Translations& translations);

/// A sentence for every comment that lacks its translation, with file and line, and for every
/// translation that lacks its comment. Nothing of an assignment without a table.
std::vector<std::string> outOfStep(const Assignment& assignment,
                                   const std::filesystem::path& solutions);

} // namespace ggrade::authoring
