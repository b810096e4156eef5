#include "grading/diagnose.hpp"

#include "diagnosis/proved.hpp"
#include "repair/compare.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ggrade::grading {

using diagnosis::FirstWrong;
using diagnosis::Identified;
using gg::say;
using results::Diagnosis;

namespace {

/// The step of the item that lost most.
std::string stepOfWorst(const results::Result& result, const Part& part) {
  const results::Item* worst = nullptr;
  for (const results::Item& item : result.items)
    if (item.id.starts_with(part.id + '.') && item.kind != results::ItemKind::bonus &&
        report::lost(item) > 0 && (!worst || report::lost(item) > report::lost(*worst)))
      worst = &item;
  return worst ? worst->step : std::string();
}

/// How many steps an unfinished program may have: some show nothing.
std::size_t stepsDone(const Cause& cause) {
  std::size_t done = std::stoul(cause.id.substr(5));
  for (const std::string& other : cause.alike)
    if (other.starts_with("step.")) done = std::max(done, std::size_t(std::stoul(other.substr(5))));
  return done;
}

/// How many of the first steps earned all of their points: of some, passes alone show it.
std::size_t stepsEarned(const results::Result& result, const Part& part) {
  const auto earned = [&](const Todo& todo) {
    const auto isOf = [&](const results::Item& item) {
      const auto declared = std::ranges::find(part.items, item.id, &ItemDeclaration::id);
      return declared != part.items.end() && declared->step == todo.id &&
             item.kind == results::ItemKind::gain;
    };
    return !todo.bonus && std::ranges::any_of(result.items, isOf) &&
           std::ranges::none_of(result.items, [&](const results::Item& item) {
             return isOf(item) && report::lost(item) > 1e-6;
           });
  };
  return std::size_t(std::ranges::find_if_not(part.todos, earned) - part.todos.begin());
}

/// "Step 3" of an unfinished program: the steps before it show all that it shows.
void describeStep(const Cause& cause, const results::Result& result, const Part& part,
                  Diagnosis& words) {
  const std::size_t done = stepsDone(cause), earned = stepsEarned(result, part);
  words.step =
      stepHeading(part, part.todos.at(std::min(std::max(done, earned), part.todos.size() - 1)).id);
  const bool nothing =
      cause.id == "step.0" || std::ranges::find(cause.alike, "step.0") != cause.alike.end();
  if (nothing && earned > 0) {
    words.text = earned == 1 ? say("Step 1 is right. What step 2 adds can't be seen yet.")
                             : say("Steps 1 to {} are right. What step {} adds can't be seen yet.",
                                   earned, earned + 1);
    if (done > earned) words.text += say(" The first step that shows is step {}.", done + 1);
  } else if (nothing) {
    words.text = say("Your picture is still the one of the handed-out program: nothing of this "
                     "part can be seen yet.");
    if (done > 0) words.text += say(" The first step that shows is step {}.", done + 1);
  } else {
    words.text = done == 1 ? say("Your picture is the one of the program with step 1 done: what "
                                 "step 2 adds can't be seen yet.")
                           : say("Your picture is the one of the program with steps 1 to {} done: "
                                 "what step {} adds can't be seen yet.",
                                 done, done + 1);
  }
}

void describeMistake(const Cause& cause, const Part& part, const Catalogue& catalogue,
                     Diagnosis& words) {
  const Mistake& mistake = *catalogue.mistake(cause.id);
  words.text = mistake.hint;
  words.step = stepHeading(part, mistake.step);
  std::vector<std::string> others;
  for (const std::string& name : cause.alike)
    if (const Mistake* other = catalogue.mistake(name);
        other && other->same != mistake.name && mistake.same != other->name &&
        (mistake.same.empty() || mistake.same != other->same))
      others.push_back(other->title);
  if (others.size() > 2) others.resize(2);
  for (const std::string& title : others)
    words.beside.push_back(say("The same is seen where this is so: {}.", title));
  if (cause.by == Identified::By::firstPass)
    words.beside.push_back(
        say("Something else is wrong after it: grade again once this is right."));
}

void describePlace(const FirstWrong& first, const Graded& graded, Diagnosis& words) {
  words.picture =
      first.slot ? diagnosis::describe(*first.slot) : say("the window, frame {}", first.frame + 1);
  words.scene = graded.scenes[first.scene].name;
  words.amount =
      first.missing ? say("not there") : say("{} of it differs", report::percent(first.share));
  if (!first.missing && first.width > 0)
    words.place = say("around ({}, {}) of {}x{}", std::lround(first.x * first.width),
                      std::lround(first.y * first.height), first.width, first.height);
}

Diagnosis inWords(const Cause& cause, const Graded& graded, const Part& part,
                  const Catalogue& catalogue) {
  Diagnosis words;
  words.part = part.id;
  words.id = cause.id;
  words.confidence = cause.confidence;
  if (cause.first) describePlace(*cause.first, graded, words);
  if (cause.id.empty()) {
    words.text = say("What went wrong here matches no known mistake. The items below say what was "
                     "seen and where.");
    words.step = stepOfWorst(graded.result, part);
  } else if (cause.generic) {
    std::string what = cause.of ? diagnosis::describe(*cause.of) : say("the window's picture");
    what[0] = char(std::toupper(static_cast<unsigned char>(what[0])));
    words.text = diagnosis::describe(*cause.generic, what);
    words.step = stepOfWorst(graded.result, part);
  } else if (cause.id.starts_with("step.")) {
    describeStep(cause, graded.result, part, words);
  } else {
    describeMistake(cause, part, catalogue, words);
  }
  return words;
}

/// The proved causes that are a part's work, or nobody's.
std::vector<results::ProvedCause> causesIn(const Part& part, const results::Result& result) {
  std::vector<results::ProvedCause> causes;
  std::ranges::copy_if(result.causes, std::back_inserter(causes), [&](const auto& cause) {
    return cause.todos.empty() || std::ranges::any_of(cause.todos, [&](const std::string& todo) {
             return todo.starts_with(part.id + '.');
           });
  });
  return causes;
}

/// The first of a part's steps that a cause is the work of alone, as `todosOf` has it; empty: none
/// is.
template <class TodosOf>
std::string firstStep(const std::vector<results::ProvedCause>& causes, const Part& part,
                      TodosOf todosOf) {
  for (const Todo& todo : part.todos)
    for (const results::ProvedCause& cause : causes)
      if (todosOf(cause) == std::set<std::string>{todo.id}) return stepHeading(part, todo.id);
  return {};
}

/// Of what was begun: whose work alone one of them is, or whose calls alone change it.
std::string stepBegun(const std::vector<results::ProvedCause>& causes, const Part& part) {
  return firstStep(causes, part, [](const results::ProvedCause& cause) {
    std::set<std::string> todos;
    std::ranges::set_difference(cause.todos, cause.notBegun, std::inserter(todos, todos.end()));
    return cause.todos.empty() ? cause.changedBy : todos;
  });
}

/// Likewise, or else of what wasn't.
std::string stepOf(const std::vector<results::ProvedCause>& causes, const Part& part) {
  const std::string step = stepBegun(causes, part);
  return step.empty() ? firstStep(causes, part, [](const auto& cause) { return cause.todos; })
                      : step;
}

/// The step before the first one that isn't begun; empty: all are, or none is.
std::string lastBegun(const std::vector<results::ProvedCause>& causes, const Part& part) {
  const auto first = std::ranges::find_if(part.todos, [&](const Todo& todo) {
    return std::ranges::any_of(causes, [&](const results::ProvedCause& cause) {
      return cause.notBegun.contains(todo.id);
    });
  });
  if (first == part.todos.begin() || first == part.todos.end()) return {};
  return stepHeading(part, std::prev(first)->id);
}

/// Are all causes the work of steps that the program up to this one hasn't got?
bool areLater(const std::vector<results::ProvedCause>& causes, const std::string& step,
              const Part& part) {
  const std::size_t done = std::stoul(step.substr(5));
  return std::ranges::all_of(causes, [&](const results::ProvedCause& cause) {
    return !cause.todos.empty() &&
           std::none_of(part.todos.begin(), part.todos.begin() + std::ptrdiff_t(done),
                        [&](const auto& todo) { return cause.todos.contains(todo.id); });
  });
}

/// Of shaders it is known by the line whose work they are. (A state that two steps set is known as
/// the later one's.)
bool isOfItsStep(const Mistake& mistake, const std::vector<results::ProvedCause>& causes) {
  return std::ranges::all_of(causes, [&](const results::ProvedCause& cause) {
    return !repair::isShader(cause.unit) || cause.todos.empty() ||
           cause.todos.contains(mistake.step);
  });
}

/// What was proved is surer than what the picture resembles. A mistake of the catalogue is named
/// where it changes what was proved, too.
Diagnosis withProof(Cause cause, const std::vector<results::ProvedCause>& causes,
                    const Graded& graded, const Part& part, const Catalogue& catalogue,
                    const Agrees& agrees) {
  const auto isProved = [&](const std::string& id) {
    const Mistake* mistake = catalogue.mistake(id);
    return mistake && isOfItsStep(*mistake, causes) && agrees(*mistake, causes);
  };
  if (cause.id.starts_with("step.") && areLater(causes, cause.id, part)) {
    std::erase_if(cause.alike, [&](const std::string& other) {
      return other.starts_with("step.") && !areLater(causes, other, part);
    });
    const std::string& next = part.todos.at(stepsDone(cause)).id;
    // A later step's fault can look so, too, and so can what was begun and shows nothing.
    if (std::ranges::any_of(causes, [&](const auto& one) {
          return one.todos.contains(next) &&
                 (one.isUnseen || one.notBegun.contains(next) || one.untouched.contains(next));
        }))
      return inWords(cause, graded, part, catalogue);
  }
  if (!cause.generic && !isProved(cause.id)) {
    const auto other = std::ranges::find_if(cause.alike, isProved);
    if (other != cause.alike.end()) std::swap(cause.id, *other);
  }
  Diagnosis words;
  if (!cause.generic && isProved(cause.id)) {
    std::erase_if(cause.alike, [&](const std::string& name) { return !isProved(name); });
    cause.by = Identified::By::everything; // with it right, all is
    words = inWords(cause, graded, part, catalogue);
    words.beside.push_back(diagnosis::sentenceOf(causes));
    return words;
  }
  words.part = part.id;
  if (cause.first) describePlace(*cause.first, graded, words);
  words.id = "proved";
  words.confidence = 1;
  words.text = diagnosis::sentenceOf(causes);
  words.step = stepOf(causes, part);
  return words;
}

/// What lies in a submission's folders of frames and passes, by scene.
Shown shown(std::vector<std::filesystem::path> folders) {
  return {[folders](std::size_t scene) { return viewsIn(folders[scene]); },
          [folders](std::size_t scene) { return framesIn(folders[scene]); }};
}

} // namespace

std::vector<std::string> lostItems(const results::Result& result, const Part& part) {
  std::vector<std::string> lost;
  for (const results::Item& item : result.asDrawn.empty() ? result.items : result.asDrawn)
    if (item.id.starts_with(part.id + '.') && item.judged &&
        item.kind != results::ItemKind::bonus && report::lost(item) > 1e-6)
      lost.push_back(item.id);
  return lost;
}

std::vector<Diagnosis> diagnosesOf(const Target& target, const Graded& graded,
                                   const std::function<Diagnoser&(const Part&)>& diagnoserOf,
                                   const Agrees& agrees, const std::set<std::string>& leftOut) {
  const results::Result& result = graded.result;
  const auto observed = diagnosis::outcomeDiagnosis(result, graded.facts);
  if (!report::scored(result.outcome))
    return observed ? std::vector{*observed} : std::vector<Diagnosis>{};
  std::vector<Diagnosis> all;
  for (const Part& part : target.parts) {
    const std::vector<std::string> lost = lostItems(result, part);
    if (lost.empty()) continue;
    // Seen, not concluded: no picture can be surer. That OpenGL reports errors says little.
    const std::vector<results::ProvedCause> causes = causesIn(part, result);
    if (observed && observed->id != results::name(results::Outcome::glError)) {
      Diagnosis& words = all.emplace_back(*observed);
      words.part = part.id;
      words.step = stepBegun(causes, part);
      if (words.step.empty() && words.id == diagnosis::kLeftBound)
        words.step = lastBegun(causes, part); // who isn't begun binds nothing
      if (words.step.empty()) words.step = stepOf(causes, part);
      if (words.step.empty()) words.step = stepOfWorst(result, part);
      if (!causes.empty()) words.beside.push_back(diagnosis::sentenceOf(causes));
      continue;
    }
    if (!result.causes.empty() && causes.empty()) continue; // another part's fault was seen here
    Diagnoser& diagnoser = diagnoserOf(part);
    const Cause cause = diagnoser.causeOf(lost, shown(graded.students()), leftOut);
    Diagnosis words = causes.empty()
                          ? inWords(cause, graded, part, diagnoser.catalogue())
                          : withProof(cause, causes, graded, part, diagnoser.catalogue(), agrees);
    if (words.id.empty() && observed) {
      words.id = observed->id;
      words.text = observed->text;
      words.confidence = observed->confidence;
    }
    const auto beside =
        observed ? observed->beside : diagnosis::tellingWarnings(result.compilerOutput);
    words.beside.insert(words.beside.end(), beside.begin(), beside.end());
    all.push_back(std::move(words));
  }
  return all;
}

} // namespace ggrade::grading
