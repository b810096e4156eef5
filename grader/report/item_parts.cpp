#include "report/page_parts.hpp"

#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::report {

using gg::say;

namespace {

struct ItemLook {
  std::string_view state, sign, word; // the word in the reader's language
};

ItemLook lookOf(const Item& item) {
  const bool bonus = item.kind == ItemKind::bonus;
  switch (standing(item)) {
  case Standing::full:
    return {bonus ? "extra" : "full", "✓",
            item.kind == ItemKind::keep ? gg::words("kept") : gg::words("full points")};
  case Standing::part:
    return {bonus ? "extra" : "part", "◐", gg::words("some points")};
  case Standing::none:
    return bonus ? ItemLook{"unjudged", "○", gg::words("bonus not earned")}
                 : ItemLook{"none", "✗", gg::words("no points")};
  case Standing::unjudged:
    break;
  }
  return {"unjudged", "–", gg::words("not judged")};
}

Data tagsOf(const Item& item) {
  Data tags = makeList();
  const auto add = [&](const std::string& word, const char* state) {
    Data tag;
    tag["tag"] = Data(word);
    tag["tagState"] = Data(state);
    tags << tag;
  };
  if (item.kind == ItemKind::bonus) add(say("bonus"), "extra");
  if (item.kind == ItemKind::keep)
    add(say("must stay right, up to −{}", number(item.points)), "plain");
  if (item.beyondLecture) add(say("beyond the lecture"), "plain");
  return tags;
}

Data creditsOf(const Result& result, const Item& item) {
  Data credits = makeList();
  for (const auto& [scene, credit] : item.credits) {
    Data entry;
    entry["scene"] = line(scene);
    entry["credit"] = Data(percent(credit));
    entry["creditState"] = Data(std::string(creditState(credit)));
    entry["sceneAnchor"] = optional(sceneAnchor(result, scene));
    credits << entry;
  }
  return credits;
}

} // namespace

Data itemOf(const Result& result, std::size_t index) {
  const Item& item = result.items[index];
  const ItemLook look = lookOf(item);
  const double reached = item.points > 0 ? 1 - lost(item) / item.points : 0;
  const bool isLost = item.judged && lost(item) > 0;
  Data data, tags = tagsOf(item);
  data["anchor"] = Data(fmt::format("item-{}", index));
  data["state"] = Data(std::string(look.state));
  data["sign"] = Data(std::string(look.sign));
  data["stateWord"] = Data(std::string(look.word));
  data["title"] = line(item.title.empty() ? item.id : item.title);
  data["looksAt"] = line(item.looksAt);
  data["hasTags"] = Data(tags.is_non_empty_list());
  data["tags"] = std::move(tags);
  data["points"] = Data(pointsText(item));
  data["share"] = item.judged ? Data(number(std::clamp(reached, 0.0, 1.0) * 100, 1)) : Data(false);
  data["message"] = line(item.message);
  data["carried"] = optional(carriedText(item));
  data["where"] = line(item.where);
  data["cause"] = line(item.cause);
  data["step"] = line(item.step);
  data["hasCredits"] = Data(isLost && item.kind != ItemKind::bonus && !item.credits.empty());
  data["credits"] = creditsOf(result, item);
  return data;
}

Data findingOf(const Result& result, const Item& item) {
  Data data;
  data["loss"] = Data(number(lost(item)));
  data["anchor"] = Data(fmt::format("item-{}", &item - result.items.data()));
  data["title"] = line(item.title.empty() ? item.id : item.title);
  const std::string message = sanitizeLine(item.message, 180);
  data["message"] = optional(message);
  const Scene* scene = worstScene(result, item);
  data["scene"] = scene ? line(scene->name) : Data(false);
  data["sceneAnchor"] = Data(scene ? sceneAnchor(result, scene->name) : "");
  data["sceneState"] = Data("none");
  return data;
}

} // namespace ggrade::report
