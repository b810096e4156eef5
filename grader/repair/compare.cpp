#include "repair/compare.hpp"

#include "repair/align.hpp"
#include "repair/own_value.hpp"
#include "repair/programs.hpp"
#include "repair/shaders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

namespace ggrade::repair {

using nlohmann::json;

namespace {

/// The reference's images are numbered from here on, unless they are the submission's.
constexpr std::uint64_t kReferenceImages = 1'000'000;

std::string textOf(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string pointer(std::initializer_list<std::string> keys) {
  json::json_pointer path;
  for (const std::string& key : keys) path.push_back(key);
  return path.to_string();
}

/// Calls `visit` with every value of this key, wherever it stands.
void forEach(json& value, const std::string& key, const std::function<void(json&)>& visit) {
  if (value.is_object()) {
    for (auto& [name, one] : value.items()) {
      if (name == key && one.is_number()) visit(one);
      forEach(one, key, visit);
    }
  } else if (value.is_array()) {
    for (json& one : value) forEach(one, key, visit);
  }
}

class Comparing {
public:
  Comparing(const tape::Tape& submission, const tape::Tape& reference, std::size_t before)
      : before_(before) {
    result_.tape.blobs = submission.blobs;
    reference_ = reference.commands;
    mergeBlobs(reference);
    json& commands = result_.tape.commands;
    const json& own = submission.commands;
    commands.push_back(own.at(0));
    // Every image of the reference can be named by a patch.
    for (json& command : reference_) {
      if (command.at("op") == "image")
        command["id"] = command["id"].get<std::uint64_t>() + kReferenceImages;
      forEach(command, "image", [](json& id) { id = id.get<std::uint64_t>() + kReferenceImages; });
    }
    programs_.addReferences(reference_);
    for (const json& command : reference_)
      if (command.at("op") == "draw")
        for (const char* what : {"uniforms", "blocks"})
          for (const auto& [name, value] : command.at(what).items()) given_.insert(value);
    std::set<json> defined;
    for (const json& command : reference_)
      if (command.at("op") == "image" && defined.insert(command["id"]).second)
        commands.push_back(command);
    // Nothing uses an image before it is defined first: so a patch may, if that comes first of all.
    json rest = json::array();
    defined.clear();
    for (std::size_t i = 1; i < own.size(); ++i)
      if (own[i].at("op") == "image" && defined.insert(own[i].at("id")).second)
        commands.push_back(own[i]);
      else
        rest.push_back(own[i]);
    commands.insert(commands.end(), rest.begin(), rest.end());
    programs_.addOwn(own);
    for (json& command : commands)
      if (command.at("op") != "image") command["before"] = json::object();
  }

  Comparison run() {
    pairs_ = align(result_.tape.commands, reference_);
    mapImages();
    std::map<std::size_t, std::size_t> ordinals; // of the submission's passes, by command
    for (const Pass& pass : passesOf(result_.tape.commands))
      for (const std::size_t command : pass.commands) ordinals[command] = pass.ordinal;
    for (const PassPair& pair : pairs_) {
      role_ = repair::roleOf(result_.tape.blobs, reference_, pair.other);
      order_.try_emplace(role_, pair.other.ordinal);
      const auto shared = std::ranges::find_if(
          pair.commands, [](const CommandPair& both) { return both.one && both.other; });
      first_ = std::nullopt;
      if (shared != pair.commands.end()) first_ = ordinals.at(*shared->one);
      isSeen_ = pair.other.frame >= before_;
      comparePass(pair);
    }
    for (auto& [unit, difference] : found_) {
      difference.isUnseen = !drawsOther_.contains(unit.role) &&
                            std::ranges::any_of(putIn_[unit], [&](const json& shaders) {
                              return !drawn_.contains({unit.role, shaders});
                            });
      auto& own = own_[unit];
      own.erase("");
      if (own.size() == 1) difference.own = *own.begin(); // several: of each pass another
      if (!difference.patch.empty()) result_.differences.push_back(std::move(difference));
    }
    std::ranges::stable_sort(result_.differences, {}, [this](const Difference& one) {
      return std::tuple(widthOf(one.unit.name), functionOf(one.unit.name).empty(),
                        order_.at(one.unit.role));
    });
    return std::move(result_);
  }

private:
  void mergeBlobs(const tape::Tape& reference) {
    std::map<std::vector<std::byte>, std::uint64_t> known;
    for (std::size_t i = 0; i < result_.tape.blobs.size(); ++i)
      known.emplace(result_.tape.blobs[i], i);
    std::vector<std::uint64_t> number;
    for (const auto& bytes : reference.blobs) {
      const auto [at, isNew] = known.emplace(bytes, result_.tape.blobs.size());
      if (isNew) result_.tape.blobs.push_back(bytes);
      number.push_back(at->second);
    }
    for (json& command : reference_)
      forEach(command, "blob", [&](json& one) { one = number.at(one.get<std::size_t>()); });
  }

  /// Images are the same that are attached at the same point of passes that do the same, that the
  /// same sampler reads there, or that hold the same texels from the start; the first that are, so
  /// that no two of the reference's become one.
  void mapImages() {
    std::map<std::uint64_t, std::uint64_t> same; // the reference's: the submission's
    const auto isTaken = [&](const json& own) {
      return std::ranges::any_of(same, [&](const auto& one) { return own == one.second; });
    };
    const auto pairUp = [&](const json& theirs, const json& own) {
      if (!isTaken(own)) same.try_emplace(theirs, own);
    };
    json& commands = result_.tape.commands;
    for (const PassPair& pair : pairs_)
      for (const CommandPair& both : pair.commands) {
        if (!both.one || !both.other || !reference_[*both.other].contains("target")) continue;
        const json &a = commands[*both.one].at("target"), &b = reference_[*both.other]["target"];
        if (a.contains("window") || b.contains("window")) continue;
        for (const auto& [point, one] : b.at("attachments").items())
          if (const json& own = a.at("attachments"); own.contains(point))
            pairUp(one.at("image"), own[point].at("image"));
      }
    // Or that the same sampler reads.
    for (const PassPair& pair : pairs_)
      for (const CommandPair& both : pair.commands) {
        if (!both.one || !both.other || reference_[*both.other].at("op") != "draw") continue;
        const json& own = commands[*both.one].at("textures");
        for (const auto& [name, all] : reference_[*both.other].at("textures").items()) {
          const json ownAll = own.value(name, json::array());
          for (std::size_t i = 0; i < std::min(all.size(), ownAll.size()); ++i)
            if (all[i].contains("image") && ownAll[i].contains("image"))
              pairUp(all[i]["image"], ownAll[i]["image"]);
        }
      }
    const auto definition = [](json command) {
      command.erase("id");
      command.erase("parameters");
      return command;
    };
    for (const json& theirs : reference_) {
      if (theirs.at("op") != "image" || same.contains(theirs.at("id"))) continue;
      for (const json& own : commands)
        if (own.at("op") == "image" && own.at("id").get<std::uint64_t>() < kReferenceImages &&
            !isTaken(own.at("id")) && definition(own) == definition(theirs)) {
          same.try_emplace(theirs.at("id"), own.at("id"));
          break;
        }
    }
    for (json& command : reference_)
      if (command.at("op") != "image")
        forEach(command, "image", [&](json& id) {
          if (const auto found = same.find(id); found != same.end()) id = found->second;
        });
    same_ = std::move(same);
  }

  void note(const std::string& unit) {
    if (first_ || isPutIn_) result_.compared[{role_, unit}].insert(shaders_);
  }

  void patch(const std::string& unit, const std::string& path, const json& value) {
    note(unit);
    const json* at = nullptr;
    const json::json_pointer where(path);
    if (result_.tape.commands.contains(where)) at = &result_.tape.commands.at(where);
    if (at && *at == value) return;
    Difference& difference = found_[{role_, unit}];
    difference.unit = {role_, unit};
    difference.shaders.insert(shaders_);
    if (first_ && isSeen_) difference.passes.insert(*first_);
    difference.patch.push_back({{"op", at ? "replace" : "add"}, {"path", path}, {"value", value}});
    if (at) own_[difference.unit].insert(ownValue(unit, where.back(), *at));
  }

  void compareState(std::size_t i, const json& theirs) {
    for (const auto& [key, value] : theirs.at("state").items()) {
      std::string unit = key;
      if (key.starts_with("stencil")) unit = "stencil";
      if (key.starts_with("polygonOffset")) unit = "polygonOffset";
      if (key.starts_with("depth") && key != "depthClamp") unit = "depth";
      if (key == "cull" || key == "cullFace" || key == "frontFace") unit = "culling";
      if (key == "scissor" || key == "scissorTest") unit = "scissor";
      const std::string path = pointer({std::to_string(i), "state", key});
      if (unit == "stencil")
        compareStencil(theirs, path, value);
      else
        patch(unit, path, value);
    }
  }

  /// One pass counts with one program and lights with another: each its own test and operations.
  void compareStencil(const json& theirs, const std::string& path, const json& value) {
    const std::string passes = role_;
    if (!shaders_.empty()) role_ = roleOf(theirs);
    if (value.is_object())
      for (const auto& [key, one] : value.items())
        patch(key == "fail" || key.starts_with("depth") ? "stencil operations" : "stencil",
              path + pointer({key}), one);
    else
      patch("stencil", path, value);
    role_ = passes;
  }

  /// Of a draw by itself.
  std::string roleOf(const json& draw) {
    const std::string role = drawRole(result_.tape.blobs, draw);
    order_.try_emplace(role, order_.at(role_));
    return role;
  }

  /// What a pass draws into: the window or not, which images at which points; how these are made,
  /// where they are drawn into first.
  void compareTarget(std::size_t i, const json& theirs) {
    const bool isWindow = result_.tape.commands[i].at("target").contains("window");
    const bool isSame = isWindow == theirs.at("target").contains("window");
    note("framebuffer");
    if (isSame) note("attachments");
    patch(isSame ? "attachments" : "framebuffer", pointer({std::to_string(i), "target"}),
          theirs["target"]);
    if (theirs["target"].contains("window")) return;
    for (const auto& [point, one] : theirs["target"].at("attachments").items())
      if (images_.insert(one.at("image")).second) compareImage(one["image"]);
  }

  void compareImage(const json& own) {
    const auto theirs =
        std::ranges::find_if(same_, [&](const auto& one) { return own == one.second; });
    if (theirs == same_.end()) return;
    const json* wanted = nullptr;
    for (const json& command : reference_)
      if (command.at("op") == "image" && command.at("id") == theirs->first) wanted = &command;
    json& commands = result_.tape.commands;
    for (std::size_t i = 0; wanted && i < commands.size(); ++i) {
      if (commands[i].at("op") != "image" || commands[i].at("id") != own) continue;
      json value = *wanted;
      value["id"] = own;
      note("storage");
      if (withoutData(commands[i]) != withoutData(value))
        patch("storage", pointer({std::to_string(i)}), value);
    }
  }

  static json withoutData(json image) {
    if (image.contains("levels"))
      for (json& level : image["levels"]) level.erase("data");
    image.erase("immutable");
    image.erase("parameters");
    return image;
  }

  /// \param at where the submission's draw stands
  void compareProgram(const std::string& at, const json& own, const json& theirs) {
    const json &stages = own.at("program").at("stages"),
               &wanted = theirs.at("program").at("stages");
    if (stages.size() != wanted.size()) return;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (stages[k].at("stage") != wanted[k].at("stage")) return;
      const std::size_t a = stages[k].at("blob"), b = wanted[k].at("blob");
      const std::string stage = wanted[k].at("stage");
      const std::string path = at + pointer({"program", "stages", std::to_string(k), "blob"});
      for (ShaderUnit& unit :
           shaderUnits(stage, textOf(result_.tape.blobs.at(a)), textOf(result_.tape.blobs.at(b)))) {
        note(unit.name);
        if (!unit.differs) continue;
        patch(unit.name, path, blobOf(unit.source));
        Difference& difference = found_[{role_, unit.name}];
        difference.lacks.merge(unit.lacks);
        difference.adds |= unit.adds;
        giveInputs(unit.name, at, own, theirs);
      }
    }
  }

  /// What the reference's shaders are given and the submission's have no use for.
  void giveInputs(const std::string& unit, const std::string& at, const json& own,
                  const json& theirs) {
    for (const char* key : {"uniforms", "textures", "blocks", "attributes"})
      for (const auto& [name, value] : theirs.at(key).items())
        if (!own.at(key).contains(name)) patch(unit, at + pointer({key, name}), value);
  }

  std::uint64_t blobOf(const std::string& text) {
    const auto [found, isNew] = made_.try_emplace(text, result_.tape.blobs.size());
    if (isNew) {
      const auto bytes = std::as_bytes(std::span(text));
      result_.tape.blobs.emplace_back(bytes.begin(), bytes.end());
    }
    return found->second;
  }

  void compareDraw(std::size_t i, const json& theirs) {
    const json own = result_.tape.commands[i]; // patches are looked up in the commands as they are
    const std::string at = pointer({std::to_string(i)});
    note("program");
    if (programs_.isForSomethingElse(own.at("program"), theirs.at("program"))) {
      for (const char* key : {"program", "uniforms", "textures", "blocks", "attributes"})
        patch("program", at + pointer({key}), theirs.at(key));
      return;
    }
    compareProgram(at, own, theirs);
    note("mesh");
    const bool isSameMesh = meshOf(own) == meshOf(theirs);
    if (!isSameMesh)
      for (const char* key :
           {"attributes", "indices", "mode", "calls", "instances", "baseInstance"})
        if (theirs.contains(key)) patch("mesh", at + pointer({key}), theirs[key]);
    for (const std::string what : {"uniform", "block", "attribute"})
      for (const auto& [name, value] : theirs.at(what + 's').items())
        if (own.at(what + 's').contains(name) && (isSameMesh || what != "attribute"))
          patch(what + ' ' + name, at + pointer({what + 's', name}), value);
    for (const std::string what : {"uniform", "block"})
      for (const auto& [name, value] : own.at(what + 's').items())
        if (const auto found = found_.find({role_, what + ' ' + name});
            found != found_.end() && isTelling(value))
          found->second.isAnothers = given_.contains(value);
    for (const auto& [name, all] : theirs.at("textures").items())
      if (own.at("textures").contains(name))
        compareTextures(name, own, all, at + pointer({"textures", name}));
  }

  /// A matrix but the unit matrix, or a block: no two are equal by chance.
  static bool isTelling(const json& value) {
    if (!value.contains("values")) return true;
    const json& values = value["values"];
    if (values.size() < 9) return false;
    const std::size_t side = values.size() == 9 ? 3 : 4;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != (i % (side + 1) == 0 ? 1 : 0)) return true;
    return false;
  }

  /// Which textures a sampler reads, and how these are sampled.
  /// \param draw the submission's
  void compareTextures(const std::string& name, const json& draw, const json& theirs,
                       const std::string& path) {
    const auto imagesOf = [](const json& all) {
      json images = json::array();
      for (const json& one : all) images.push_back({one.at("target"), one.value("image", json())});
      return images;
    };
    const json& own = draw.at("textures").at(name);
    note("texture " + name);
    if (imagesOf(own) != imagesOf(theirs)) {
      patch("texture " + name, path, theirs);
      own_[{role_, "texture " + name}].insert(ownTexture(own, draw.at("target")));
    }
    for (std::size_t i = 0; i < std::min(own.size(), theirs.size()); ++i)
      for (const auto& [key, value] : theirs[i].items())
        if (key != "target" && key != "image" && key != "unit")
          patch("sampler " + name, path + pointer({std::to_string(i), key}), value);
  }

  void compareClear(std::size_t i, const json& theirs) {
    if (theirs.at("op") == "clear") {
      for (const std::string what : {"color", "depth", "stencil"})
        for (const std::string& key : {what + 's', what})
          patch("clear " + what, pointer({std::to_string(i), key}), theirs.at(key));
      return;
    }
    for (const auto& [key, value] : theirs.items())
      if (key != "state" && key != "target" && key != "op")
        patch(theirs["op"] == "clearBuffer" ? "clear" : "copy", pointer({std::to_string(i), key}),
              value);
  }

  void comparePass(const PassPair& pair) {
    bool onlyClears = true; // of what one of the two has alone
    for (const CommandPair& both : pair.commands) {
      const json& command = both.other ? reference_[*both.other] : result_.tape.commands[*both.one];
      if (!both.one || !both.other) {
        onlyClears = onlyClears && command.at("op") == "clear";
        if (!both.other && command.at("op") == "draw") drawsOther_.insert(role_);
        continue;
      }
      shaders_ = shadersOf(result_.tape.blobs, command);
      const std::size_t i = *both.one;
      if (command.contains("target")) compareTarget(i, command);
      if (command.contains("state") && command["state"].contains("viewport"))
        compareState(i, command);
      if (command.at("op") == "draw") {
        compareDraw(i, command);
        drawn_.insert({role_, command.at("program").at("stages")});
      } else {
        compareClear(i, command);
      }
    }
    shaders_.clear();
    for (const char* unit : {"draws", "clear"}) note(unit);
    for (const CommandPair& both : pair.commands) {
      const std::string unit = onlyClears ? "clear" : "draws";
      if (!both.one && both.before)
        putIn(unit, *both.before, *both.other);
      else if (!both.other)
        patch(unit, pointer({std::to_string(*both.one), "skip"}), true);
    }
  }

  /// A command of the reference's, before one of the submission's: a draw with the submission's
  /// shaders where it has them.
  void putIn(const std::string& unit, std::size_t before, std::size_t other) {
    const json& theirs = reference_[other];
    json own = theirs;
    own["skip"] = true;
    const std::string at = pointer({std::to_string(before), "before", fmt::format("{:06}", other)});
    const bool isDraw = theirs.at("op") == "draw";
    const json* program = isDraw ? programs_.likest(theirs.at("program")) : nullptr;
    if (program) own["program"] = *program;
    result_.tape.commands[json::json_pointer(at)] = own;
    patch(unit, at + "/skip", false);
    if (!isDraw) return;
    putIn_[{role_, unit}].insert(theirs.at("program").at("stages"));
    if (!program) return;
    isPutIn_ = true;
    shaders_ = shadersOf(result_.tape.blobs, theirs);
    compareProgram(at, own, theirs);
    shaders_.clear();
    isPutIn_ = false;
  }

  Comparison result_;
  json reference_;
  std::vector<PassPair> pairs_;
  std::map<std::uint64_t, std::uint64_t> same_;
  Programs programs_{result_.tape.blobs};
  std::string role_;                 ///< of the pass that is being compared
  std::optional<std::size_t> first_; ///< its ordinal in the submission
  bool isSeen_ = true;               ///< is it of a frame that is looked at?
  const std::size_t before_;         ///< frames that nobody looks at
  std::string shaders_;              ///< of the draw that is being compared
  bool isPutIn_ = false;             ///< which the submission hasn't got
  std::map<Unit, Difference> found_;
  std::map<Unit, std::set<std::string>> own_;    ///< what the submission has, in words
  std::set<json> given_;                         ///< uniforms and blocks of the reference's draws
  std::set<std::pair<std::string, json>> drawn_; ///< roles, and the shaders that both draw with
  std::set<std::string> drawsOther_;         ///< roles in which the submission has draws of its own
  std::map<Unit, std::set<json>> putIn_;     ///< the shaders of draws that lack
  std::map<std::string, std::size_t> order_; ///< of roles, by their first pass
  std::map<std::string, std::uint64_t> made_;
  std::set<json> images_; ///< that were compared
};

} // namespace

int widthOf(const std::string& unit) {
  if (unit.starts_with("shader ")) return 2;
  static const std::set<std::string> kWider = {"attachments", "storage", "framebuffer",
                                               "draws",       "program", "mesh"};
  return kWider.contains(unit) ? 1 : 0;
}

bool isState(const std::string& unit) {
  return widthOf(unit) == 0 &&
         std::ranges::none_of(std::array{"function ", "lines ", "uniform ", "block ", "texture ",
                                         "sampler ", "attribute ", "copy"},
                              [&](const char* kind) { return unit.starts_with(kind); });
}

Comparison compare(const tape::Tape& submission, const tape::Tape& reference, std::size_t before) {
  return Comparing(submission, reference, before).run();
}

} // namespace ggrade::repair
