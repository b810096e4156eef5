#include "rubric/rubric.hpp"

#include "words/words.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

namespace ggrade::rubric {

using nlohmann::json;

namespace {

std::map<std::string, Judge>& judges() {
  static std::map<std::string, Judge> all;
  return all;
}

bool isAmong(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool looksAt(const ItemDeclaration& item, const SceneEvidence& scene) {
  if (item.scenes.empty()) return !scene.has("bonus");
  return std::any_of(item.scenes.begin(), item.scenes.end(),
                     [&](const std::string& tag) { return scene.has(tag); });
}

Verdict checked(const Judge& judge, const View& view) {
  Verdict verdict = judge(view);
  if (!std::isfinite(verdict.quality))
    throw std::runtime_error("the judge's quality is not finite in scene " + view.scene.name);
  verdict.quality = std::clamp(verdict.quality, 0.0, 1.0);
  return verdict;
}

/// One item as a GoogleTest test.
class ItemTest : public testing::Test {
public:
  ItemTest(ItemDeclaration item, const std::vector<ItemDeclaration>& items,
           const Evidence& evidence, Floors* floors, std::map<std::string, json>& results)
      : item_(std::move(item)), items_(items), evidence_(evidence), floors_(floors),
        results_(results) {}

  void TestBody() override {
    const Decision decision = decide(item_, items_, judgeOf(item_.id), evidence_, floors_);
    const bool keep = item_.kind == results::ItemKind::keep;
    json line = lineOf(item_, decision);
    line["outputs"] = outputsOf(item_, items_, decision, evidence_);
    const double points = line.at("earned");
    results_[item_.id] = line;
    RecordProperty("earned", fmt::format("{}", points));
    RecordProperty("points", fmt::format("{}", item_.points));
    EXPECT_GE(points, keep ? 0 : item_.points) << decision.message;
  }

private:
  ItemDeclaration item_;
  const std::vector<ItemDeclaration>& items_;
  const Evidence& evidence_;
  Floors* const floors_;
  std::map<std::string, json>& results_;
};

/// Appends the item's line as soon as it has been judged, so that a crash keeps what was earned.
class Writer : public testing::EmptyTestEventListener {
public:
  Writer(std::filesystem::path path, const std::map<std::string, json>& results)
      : path_(std::move(path)), results_(results) {}

  void OnTestEnd(const testing::TestInfo& test) override {
    const auto found = results_.find(std::string(test.test_suite_name()) + "." + test.name());
    if (found == results_.end()) return;
    if (!(std::ofstream(path_, std::ios::app) << found->second.dump() << std::endl)) lost_ = true;
  }
  /// Could a line not be written? Its item would count as never judged.
  bool lost() const { return lost_; }

private:
  bool lost_ = false;
  std::filesystem::path path_;
  const std::map<std::string, json>& results_;
};

/// The scene that `scene` is a change of, if the submission has drawn all of it.
const SceneEvidence* baseOf(const SceneEvidence& scene, const Evidence& evidence) {
  for (const SceneEvidence& other : evidence.scenes)
    if (!scene.like.empty() && other.name == scene.like && other.student.size() == other.frameCount)
      return &other;
  return nullptr;
}

/// Is something else lost with the frames of a scene that never came: what is gained there, or in
/// the scene that it is a change of, which didn't come either?
bool losesElsewhere(const SceneEvidence& scene, const std::vector<ItemDeclaration>& items,
                    const Evidence& evidence) {
  if (!scene.like.empty() && !baseOf(scene, evidence)) return true;
  return std::ranges::any_of(items, [&](const ItemDeclaration& item) {
    return item.kind != results::ItemKind::keep && looksAt(item, scene);
  });
}

} // namespace

bool add(const std::string& item, Judge judge) {
  return judges().emplace(item, std::move(judge)).second;
}

const Judge& judgeOf(const std::string& item) {
  const auto found = judges().find(item);
  if (found == judges().end())
    throw UsageError(fmt::format("rubric.cpp has no GGRADE_ITEM(\"{}\")", item));
  return found->second;
}

double pointsOf(results::ItemKind kind, double points, double credit) {
  const bool keep = kind == results::ItemKind::keep;
  return std::round((keep ? credit - 1 : credit) * points * 10) / 10;
}

json lineOf(const ItemDeclaration& item, const Decision& decision) {
  json credits = json::array();
  for (std::size_t i = 0; i < decision.credits.size(); ++i)
    credits.push_back({decision.credits[i].scene, decision.credits[i].credit,
                       decision.credits[i].isPublic, decision.messages[i]});
  return {{"id", item.id},
          {"earned", pointsOf(item.kind, item.points, decision.credit)},
          {"credit", decision.credit},
          {"message", decision.message},
          {"credits", credits}};
}

void warm(const ItemDeclaration& item, const Judge& judge, const Evidence& evidence,
          Floors& floors) {
  for (const SceneEvidence& scene : evidence.scenes) {
    if (!looksAt(item, scene)) continue;
    checked(judge, {scene, scene.reference, scene.referenceTrace, nullptr});
    floors[{item.id, &scene}] =
        checked(judge, {scene, scene.stub, scene.stubTrace, nullptr}).quality;
  }
}

Decision decide(const ItemDeclaration& item, const std::vector<ItemDeclaration>& items,
                const Judge& judge, const Evidence& evidence, Floors* floors) {
  Floors own;
  Floors& known = floors ? *floors : own;
  const auto floorOf = [&](const SceneEvidence& scene) {
    const auto [entry, fresh] = known.try_emplace({item.id, &scene});
    if (fresh)
      entry->second = checked(judge, {scene, scene.stub, scene.stubTrace, nullptr}).quality;
    return entry->second;
  };
  const bool isKeep = item.kind == results::ItemKind::keep;
  // Where the stub is as good as the reference, the scene can't show the item.
  const auto shows = [&](const SceneEvidence& scene) { return isKeep || floorOf(scene) <= 0.99; };
  Decision decision;
  std::vector<const SceneEvidence*> scenes; // of each credit
  for (const SceneEvidence& scene : evidence.scenes) {
    if (!looksAt(item, scene)) continue;
    double credit = 0;
    std::string message;
    if (scene.student.size() < scene.frameCount) {
      // What never came is lost once: where others have it to lose, it harmed nothing.
      if (isKeep && losesElsewhere(scene, items, evidence)) continue;
      message = gg::say("{} of {} frames came", scene.student.size(), scene.frameCount);
    } else if (const auto odd = std::mismatch(scene.reference.begin(), scene.reference.end(),
                                              scene.student.begin(), sameSize);
               odd.first != scene.reference.end()) {
      message =
          gg::say("the window is {} instead of {}", odd.second->sizeText(), odd.first->sizeText());
    } else {
      const Verdict verdict =
          checked(judge, {scene, scene.student, scene.studentTrace, baseOf(scene, evidence)});
      message = verdict.message;
      credit = verdict.quality;
      if (!isKeep && credit < 1 && shows(scene))
        credit = std::clamp((credit - floorOf(scene)) / (1 - floorOf(scene)), 0.0, 1.0);
    }
    scenes.push_back(&scene);
    decision.credits.emplace_back(scene.name, credit, scene.isPublic);
    decision.messages.push_back(message);
  }
  // Nobody is asked about the stub where nothing was lost.
  if (std::ranges::any_of(decision.credits, [](const auto& one) { return one.credit < 1; }))
    for (std::size_t i = scenes.size(); i-- > 0;)
      if (!shows(*scenes[i])) {
        decision.credits.erase(decision.credits.begin() + std::ptrdiff_t(i));
        decision.messages.erase(decision.messages.begin() + std::ptrdiff_t(i));
      }
  if (const auto worst =
          std::ranges::min_element(decision.credits, {}, &results::SceneCredit::credit);
      worst != decision.credits.end())
    decision.message = fmt::format(
        "{}: {}", worst->scene, decision.messages[std::size_t(worst - decision.credits.begin())]);
  const bool any = !decision.credits.empty();
  decision.credit = results::creditOf(item.kind, decision.credits);
  if (!any && isKeep) {
    decision.message = gg::say("no scene has all its frames");
  } else if (!any && !evidence.again.empty()) {
    decision.credit = 0; // the first frames alone may not show it
  } else if (!any) {
    throw std::runtime_error("no scene can show " + item.id);
  }
  return decision;
}

int judgeItems(const Evidence& evidence, const std::vector<ItemDeclaration>& all, Floors* floors,
               const std::filesystem::path& resultsFile,
               const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"ggrade"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int argc = int(words.size());
  testing::InitGoogleTest(&argc, argv.data());
  if (argc > 1) throw UsageError(fmt::format("\"{}\" is not an argument of GoogleTest", argv[1]));

  std::vector<ItemDeclaration> items;
  for (const ItemDeclaration& item : all)
    if (evidence.again.empty() || isAmong(evidence.again, item.id)) items.push_back(item);
  std::map<std::string, json> results;
  for (const ItemDeclaration& item : items) {
    const std::size_t dot = item.id.find('.');
    testing::RegisterTest(item.id.substr(0, dot).c_str(), item.id.substr(dot + 1).c_str(), nullptr,
                          nullptr, __FILE__, __LINE__, [&, item]() -> ItemTest* {
                            return new ItemTest(item, all, evidence, floors, results);
                          });
  }
  if (!std::ofstream(resultsFile)) // so that it is there, however few items are asked for
    throw UsageError(fmt::format("can't write {}", resultsFile.string()));
  auto* const writer = new Writer(resultsFile, results);
  testing::UnitTest::GetInstance()->listeners().Append(writer);
  [[maybe_unused]] const int lostPoints = RUN_ALL_TESTS();
  // Lost points are no failure of the judge, so the result says nothing here; an item without a
  // result is, unless it was asked for.
  if (writer->lost())
    throw UsageError(fmt::format("can't write {}: is the disk full?", resultsFile.string()));
  const bool filtered = testing::GTEST_FLAG(filter) != "*";
  for (const ItemDeclaration& item : items)
    if (!results.count(item.id) && !filtered) return 1;
  return 0;
}

} // namespace ggrade::rubric
