#include "report/terminal.hpp"

#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <vector>

namespace ggrade::report {

using gg::say;

namespace {

constexpr std::string_view kBold = "\x1B[1m", kDim = "\x1B[2m", kGreen = "\x1B[32m",
                           kYellow = "\x1B[33m", kRed = "\x1B[31m", kPlain = "";

std::string paint(const TerminalStyle& style, std::string_view colour, std::string_view text) {
  if (!style.colour || colour.empty()) return std::string(text);
  return fmt::format("{}{}\x1B[0m", colour, text);
}

std::string padLeft(const std::string& text, std::size_t width) {
  const std::size_t used = displayWidth(text);
  return std::string(width > used ? width - used : 0, ' ') + text;
}

// Cut to `width` columns with an ellipsis, or filled up with spaces.
std::string fit(const std::string& text, std::size_t width) {
  const std::size_t used = displayWidth(text);
  if (used <= width) return text + std::string(width - used, ' ');
  std::string cut;
  std::size_t columns = 0;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    while (end < text.size() && (text[end] & 0xC0) == 0x80) ++end;
    const std::string letter = text.substr(i, end - i);
    if (columns + displayWidth(letter) > width - 1) break;
    columns += displayWidth(letter);
    cut += letter;
    i = end;
  }
  return cut + "…" + std::string(width - 1 - columns, ' ');
}

bool isWide(std::string_view letter) {
  return displayWidth(letter) == 2;
}

// Where a line may end besides at spaces, which Japanese has none of: at wide characters, but not
// before those that begin no line, or after those that end none.
bool mayBreak(std::string_view before, std::string_view after) {
  constexpr std::string_view kNeverFirst =
      "、。，．：？！）」』】ーぁぃぅぇぉっゃゅょァィゥェォッャュョ";
  constexpr std::string_view kNeverLast = "(（「『【";
  if (!before.empty() && kNeverLast.find(before) != kNeverLast.npos) return false;
  if (isWide(after)) return kNeverFirst.find(after) == kNeverFirst.npos;
  return isWide(before) && std::isalnum(static_cast<unsigned char>(after[0])) != 0;
}

struct Piece {
  std::string text;
  bool afterSpace = false;
};

std::vector<Piece> piecesOf(const std::string& text) {
  std::vector<Piece> pieces;
  bool space = true;
  std::string last;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    while (end < text.size() && (text[end] & 0xC0) == 0x80) ++end;
    const std::string letter = text.substr(i, end - i);
    i = end;
    if (letter == " ") {
      space = true;
      continue;
    }
    if (space || mayBreak(last, letter))
      pieces.push_back({letter, space && !pieces.empty()});
    else
      pieces.back().text += letter;
    space = false;
    last = letter;
  }
  return pieces;
}

// Words of `text` in lines of at most `width` columns, each after `indent` spaces. A word that is
// too long stands on a line of its own.
std::string wrap(const std::string& text, std::size_t indent, std::size_t width) {
  std::string out, line;
  const auto flush = [&] {
    if (!line.empty()) out += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  for (const Piece& piece : piecesOf(text)) {
    const std::size_t gap = piece.afterSpace ? 1 : 0;
    if (!line.empty() && indent + displayWidth(line) + gap + displayWidth(piece.text) > width)
      flush();
    line += (line.empty() || !piece.afterSpace ? "" : " ") + piece.text;
  }
  flush();
  return out;
}

struct Mark {
  std::string_view sign, colour;
};

Mark markOf(const results::Item& item) {
  const bool bonus = item.kind == results::ItemKind::bonus;
  switch (standing(item)) {
  case Standing::full:
    return {"✓", kGreen};
  case Standing::part:
    return {"~", kYellow};
  case Standing::none:
    return bonus ? Mark{"·", kDim} : Mark{"✗", kRed};
  case Standing::unjudged:
    return {"?", kDim};
  }
  return {"?", kDim};
}

std::string scoreText(const Summary& result) {
  if (result.outcome == results::Outcome::notGradable) return say("no score");
  std::string text = fmt::format("{} / {}", number(result.score), number(result.maxScore));
  if (result.bonus > 0) text += say(" + {} bonus", number(result.bonus));
  return text;
}

std::string_view scoreColour(const Summary& result) {
  const std::string_view state = stateOf(result);
  return state == "full" ? kGreen : state == "part" ? kYellow : kRed;
}

std::string itemLines(const results::Item& item, const TerminalStyle& style, std::size_t width) {
  const Mark mark = markOf(item);
  std::string title = sanitizeLine(item.title);
  if (item.kind == results::ItemKind::bonus) title = say("Bonus: {}", title);
  if (item.beyondLecture) title += say(" (beyond the lecture)");
  std::string text = fmt::format("{} {}  {}\n", paint(style, mark.colour, mark.sign),
                                 padLeft(pointsText(item), 12), fit(title, width - 16));
  while (text.size() > 1 && text[text.size() - 2] == ' ') text.erase(text.size() - 2, 1);
  constexpr std::size_t kIndent = 16;
  text += wrap(carriedText(item), kIndent, width);
  if (standing(item) == Standing::full || !item.judged) return text;
  text += wrap(sanitizeLine(item.message), kIndent, width);
  if (!item.where.empty()) text += wrap(say("where: {}", sanitizeLine(item.where)), kIndent, width);
  if (!item.cause.empty())
    text += wrap(say("likely: {}", sanitizeLine(item.cause)), kIndent, width);
  if (!item.step.empty())
    text += wrap(say("read again: {}", sanitizeLine(item.step)), kIndent, width);
  return text;
}

std::string diagnosisLines(const results::Diagnosis& diagnosis, std::size_t width) {
  std::string text = wrap(sanitizeLine(diagnosis.text, 800), 2, width);
  if (const std::string seen = whatIsWrong(diagnosis); !seen.empty())
    text += wrap(say("first wrong: {}", seen), 2, width);
  if (!diagnosis.step.empty())
    text += wrap(say("read again: {}", sanitizeLine(diagnosis.step)), 2, width);
  for (const std::string& line : diagnosis.beside) text += wrap(sanitizeLine(line), 2, width);
  return text;
}

std::string diagnosisHeading(const results::Result& result, const results::Diagnosis& diagnosis) {
  std::string text = result.diagnoses.size() > 1
                         ? say("Diagnosis of {}", sanitizeLine(diagnosis.part))
                         : say("Diagnosis");
  if (diagnosis.confidence > 0)
    text += say(" (confidence {}%)", number(diagnosis.confidence * 100, 0));
  return text;
}

} // namespace

std::string terminalTable(const results::Result& result, const TerminalStyle& style) {
  const std::size_t width = std::max<std::size_t>(style.width, 60);
  const Summary summary = summarize(result);
  std::string text =
      fmt::format("{}  {}  {}\n", paint(style, kBold, sanitizeLine(result.part)),
                  summary.submission, paint(style, scoreColour(summary), scoreText(summary)));
  text += wrap(fmt::format("{}: {}", name(result.outcome), headline(result)), 0, width);
  text += wrap(sanitizeLine(result.detail), 0, width);
  if (result.sandbox == "none")
    text += paint(style, kYellow, say("The program ran without a sandbox.")) + "\n";
  for (const results::Diagnosis& diagnosis : result.diagnoses)
    text += paint(style, kBold, diagnosisHeading(result, diagnosis)) + "\n" +
            diagnosisLines(diagnosis, width);
  text += "\n";
  for (const results::Item& item : result.items) text += itemLines(item, style, width);
  for (const std::string& file : result.unusedFiles)
    text += wrap(say("not used: {}", sanitizeLine(file)), 0, width);
  return text;
}

std::string terminalTable(std::span<const Summary> results, const TerminalStyle& style) {
  const std::size_t width = std::max<std::size_t>(style.width, 60);
  std::size_t names = displayWidth("submission"), scores = displayWidth("score");
  for (const Summary& result : results) {
    names = std::max(names, displayWidth(result.submission));
    scores = std::max(scores, displayWidth(scoreText(result)));
  }
  names = std::min(names, width / 3);
  constexpr std::size_t kOutcome = 13; // out_of_memory
  const std::size_t used = names + kOutcome + scores + 6;
  const std::size_t rest = width > used + 10 ? width - used : 10;
  std::string text = paint(style, kBold,
                           fit("submission", names) + "  " + fit("outcome", kOutcome) + "  " +
                               padLeft("score", scores) + "  why") +
                     "\n";
  for (const Summary& result : results) {
    const std::string reason = result.perfect          ? "complete"
                               : result.reason.empty() ? result.headline
                                                       : result.reason;
    std::string line = fit(result.submission, names) + "  " +
                       fit(std::string(name(result.outcome)), kOutcome) + "  " +
                       paint(style, scoreColour(result), padLeft(scoreText(result), scores));
    if (!reason.empty()) line += "  " + fit(reason, rest);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

} // namespace ggrade::report
