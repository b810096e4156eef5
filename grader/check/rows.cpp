#include "check/rows.hpp"

#include "diagnosis/generic.hpp"

#include <algorithm>
#include <map>

namespace ggrade::check {

using diagnosis::Run;
using diagnosis::SceneViews;
using diagnosis::Slot;

namespace {

/// Of what is wrong in a picture, what a step must have changed for it to be blamed although
/// another one's first picture is wrong, later in the frame; or to be as likely as the one that is.
constexpr double kOwn = 0.5;

/// One picture of all those that a program is compared by. Passes come before windows, as in a
/// frame.
struct Cell {
  std::size_t scene = 0;
  std::optional<Slot> slot; ///< nothing: the window
  std::size_t frame = 0;    ///< of the window
};

const Image* pictureOf(const SceneViews& views, const Cell& cell) {
  if (!cell.slot) return cell.frame < views.windows.size() ? &views.windows[cell.frame] : nullptr;
  const diagnosis::PassView* pass = views.find(*cell.slot);
  return pass ? &pass->picture : nullptr;
}

/// All pictures that the program has after any of the steps, in the scenes that were drawn.
std::vector<Cell> cellsOf(const Expected& expected, const Shown& shown) {
  std::vector<Cell> cells;
  for (std::size_t scene = 0; scene < shown.size(); ++scene) {
    if (!shown[scene]) continue;
    std::vector<Slot> slots;
    for (const Run& step : expected.steps)
      for (const diagnosis::PassView& pass : step[scene].passes)
        if (std::ranges::find(slots, pass.slot) == slots.end()) slots.push_back(pass.slot);
    // In the order of the finished frame; what only unfinished ones have comes first.
    const auto order = [&](const Slot& slot) {
      const auto& passes = expected.reference[scene].passes;
      return std::ranges::find(passes, slot, &diagnosis::PassView::slot) - passes.begin();
    };
    std::ranges::stable_sort(slots, {}, [&](const Slot& slot) {
      const auto at = order(slot);
      return at == std::ptrdiff_t(expected.reference[scene].passes.size()) ? -1 : at;
    });
    for (const Slot& slot : slots) cells.push_back({scene, slot, 0});
    for (std::size_t frame = 0; frame < expected.scenes[scene].times.shown.size(); ++frame)
      cells.push_back({scene, std::nullopt, frame});
  }
  return cells;
}

class Judging {
public:
  Judging(const Expected& expected, const Shown& shown)
      : expected_(expected), shown_(shown), cells_(cellsOf(expected, shown)) {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t k = 0; k < expected.steps.size(); ++k)
        same_.push_back(diagnosis::alike(ofStep(k, cells_[c]), ofProgram(cells_[c])));
  }

  std::size_t steps() const { return expected_.steps.size(); }

  /// Are the windows those of a finished program that is right in another way?
  bool isFinishedInAnotherWay() const {
    return std::ranges::any_of(expected_.others, [&](const Run& other) {
      return std::ranges::all_of(cells_, [&](const Cell& cell) {
        return cell.slot || diagnosis::alike(pictureOf(other[cell.scene], cell), ofProgram(cell));
      });
    });
  }

  /// Steps after which all windows are the program's.
  std::vector<std::size_t> withTheseWindows() const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < steps(); ++k) {
      bool all = true;
      for (std::size_t c = 0; c < cells_.size(); ++c)
        if (!cells_[c].slot) all = all && same(c, k);
      if (all) found.push_back(k);
    }
    return found;
  }

  /// Are all windows those after step k, but for little?
  bool isNearly(std::size_t k) const {
    return std::ranges::all_of(cells_, [&](const Cell& cell) {
      return cell.slot || diagnosis::differingShare(ofStep(k, cell), ofProgram(cell)) < kNearly;
    });
  }

  /// The first picture that step k changes or adds. (One may go, such as a texture that was only
  /// cleared, once objects are drawn into it.)
  std::optional<std::size_t> firstChanged(std::size_t k) const {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (ofStep(k, cells_[c]) && isChanged(c, k)) return c;
    return std::nullopt;
  }

  /// The first picture that step k changes and that isn't right: the first of all that it changes,
  /// or one of a scene that was handed out that none of the later ones up to `should` changes
  /// again.
  std::optional<std::size_t> firstUnlike(std::size_t k, std::size_t should) const {
    const std::optional<std::size_t> first = firstChanged(k);
    for (std::size_t c = first.value_or(cells_.size()); c < cells_.size(); ++c) {
      const bool isOther = !cells_[c].slot || expected_.scenes[cells_[c].scene].another;
      if (c != *first && (isOther || !isLastToChange(c, k, should))) continue;
      if (!isRight(c, k, should)) return c;
    }
    return std::nullopt;
  }

  /// Is this picture as after step k or a later one? One that is gone is, where it should be gone
  /// after step `should`.
  bool isRight(std::size_t cell, std::size_t k, std::size_t should) const {
    if (!ofProgram(cells_[cell])) return !ofStep(should, cells_[cell]);
    for (; k < steps(); ++k)
      if (ofStep(k, cells_[cell]) && same(cell, k)) return true;
    return false;
  }

  /// Is this picture as after step k or a later one, and as after none before?
  bool isFrom(std::size_t cell, std::size_t k) const {
    if (!ofProgram(cells_[cell])) return false;
    for (std::size_t before = 0; before < k; ++before)
      if (ofStep(before, cells_[cell]) && same(cell, before)) return false;
    return isRight(cell, k, k);
  }

  /// How well the pixels that step k changes in a picture are those that aren't as after step
  /// `should`: their intersection over their union.
  double overlap(std::size_t cell, std::size_t k, std::size_t should) const {
    const Shares shares = sharesOf(cell, k, should);
    return shares.any > 0 ? shares.both / shares.any : 0;
  }

  /// Does the program draw passes in the public scene that it has after none of the steps?
  bool hasOwnPasses() const { return shown_[0] && !ownPasses(expected_, *shown_[0], 0).empty(); }
  bool isPass(std::size_t cell) const { return cells_[cell].slot.has_value(); }

  /// Is this a picture of a scene that was not handed out, which is there for one step?
  bool isAnother(std::size_t cell) const { return expected_.scenes[cells_[cell].scene].another; }

  /// Is there such a picture, or one that may be meant for it?
  bool isDrawn(std::size_t cell) const {
    const std::size_t scene = cells_[cell].scene;
    return ofProgram(cells_[cell]) || !ownPasses(expected_, *shown_[scene], scene).empty();
  }

  bool isChanged(std::size_t cell, std::size_t k) const {
    return !diagnosis::alike(ofStep(k, cells_[cell]), ofStep(k - 1, cells_[cell]));
  }

  /// Is it known of step k's own pictures only that they are right but for their brightness, which
  /// may be what is wrong in the window?
  bool isKnownInPart(std::size_t k, std::size_t cell, std::size_t should) const {
    if (cells_[cell].slot || !mayBeBrightness(cell, should)) return false;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (cells_[c].slot && !cells_[c].slot->mesh && cells_[c].slot->octave > 0 && isChanged(c, k))
        return true;
    return false;
  }

  bool isOneScene(std::size_t a, std::size_t b) const { return cells_[a].scene == cells_[b].scene; }

  /// Is it a picture of a scene that is there for one TODO?
  bool isOfATodo(std::size_t cell) const {
    return !expected_.scenes[cells_[cell].scene].todo.empty();
  }

  /// Does anything in the cell's scene change from step k on, up to `should`? If not, the scene
  /// does without the work of these steps.
  bool isUsedThere(std::size_t cell, std::size_t k, std::size_t should) const {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (isOneScene(c, cell))
        for (std::size_t step = k; step <= should; ++step)
          if (isChanged(c, step)) return true;
    return false;
  }

  /// Does step k show in the cell's scene, and is all that it changes there as after step `should`?
  bool isRightThere(std::size_t cell, std::size_t k, std::size_t should) const {
    bool shows = false;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (!isOneScene(c, cell) || !isChanged(c, k)) continue;
      if (!same(c, should)) return false;
      shows = true;
    }
    return shows;
  }

  /// Does step k change most of the pixels that aren't as after step `should`?
  bool changesWhatIsWrong(std::size_t cell, std::size_t k, std::size_t should) const {
    const Shares shares = sharesOf(cell, k, should);
    return shares.both > kOwn * shares.wrong;
  }

  /// The first step that is the last to change a picture of the first frame of its own scene,
  /// handed out, which isn't right: the mistake is made in it, or before.
  std::size_t firstWrongInOwnScene(std::size_t should) const {
    for (std::size_t k = 1; k <= should; ++k)
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        const Scene& scene = expected_.scenes[cells_[c].scene];
        if (!scene.another && scene.todo == expected_.todos[k - 1] && cells_[c].frame == 0 &&
            !same(c, should) && isLastToChange(c, k, should))
          return k;
      }
    return steps();
  }

  /// The first picture of the cell's scene that isn't as after step `should` and is drawn; else
  /// that cell.
  std::size_t firstWrongThere(std::size_t cell, std::size_t should) const {
    for (std::size_t c = 0; c < cell; ++c)
      if (isOneScene(c, cell) && ofProgram(cells_[c]) && !same(c, should)) return c;
    return cell;
  }

  /// The first picture that isn't as after step `should`; of scenes that were not handed out only
  /// windows count. A little may be another right way, where another scene has much more.
  std::optional<std::size_t> firstWrong(std::size_t should) const {
    std::optional<std::size_t> little;
    double share = 0; // of that
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (same(c, should) || (cells_[c].slot && isAnother(c))) continue;
      const double here =
          diagnosis::differingShare(ofStep(should, cells_[c]), ofProgram(cells_[c]));
      const bool isLittle = !cells_[c].slot && here < kNearly;
      if (!little && !isLittle) return c;
      if (little && isAnother(c) && here > kMuchMore * share) return c;
      if (little && !isAnother(c) && !isLittle) break;
      if (!little) little = c;
      if (!isAnother(c)) share = std::max(share, here);
    }
    return little;
  }

private:
  /// Sums over a picture: what isn't as after step `should`, what of it step k changes, and what is
  /// either.
  struct Shares {
    double both = 0, any = 0, wrong = 0;
  };
  Shares sharesOf(std::size_t cell, std::size_t k, std::size_t should) const {
    const Cell& at = cells_[cell];
    const std::vector<float> changed = diagnosis::distance(ofStep(k, at), ofStep(k - 1, at));
    const std::vector<float> wrong = diagnosis::distance(ofStep(should, at), ofProgram(at));
    Shares shares;
    for (std::size_t i = 0; i < std::min(changed.size(), wrong.size()); ++i) {
      shares.both += double(std::min(changed[i], wrong[i]));
      shares.any += double(std::max(changed[i], wrong[i]));
      shares.wrong += double(wrong[i]);
    }
    return shares;
  }
  /// Adds the last step that changes a window the right light, but for a factor?
  bool mayBeBrightness(std::size_t cell, std::size_t should) const {
    std::size_t last = should;
    while (last > 0 && !isChanged(cell, last)) --last;
    const Image *is = ofProgram(cells_[cell]), *wanted = ofStep(should, cells_[cell]),
                *before = last > 0 ? ofStep(last - 1, cells_[cell]) : nullptr;
    const auto isLike = [&](const Image* image) {
      return image && image->width() == wanted->width() && image->height() == wanted->height() &&
             image->channels() == wanted->channels();
    };
    return !wanted || !isLike(is) || !isLike(before) ||
           diagnosis::addsScaledLight(*is, *wanted, *before);
  }
  bool isLastToChange(std::size_t cell, std::size_t k, std::size_t should) const {
    if (!ofStep(k, cells_[cell]) || !isChanged(cell, k)) return false;
    for (std::size_t later = k + 1; later <= should; ++later)
      if (isChanged(cell, later)) return false;
    return true;
  }
  const Image* ofStep(std::size_t k, const Cell& cell) const {
    return pictureOf(expected_.steps[k][cell.scene], cell);
  }
  const Image* ofProgram(const Cell& cell) const { return pictureOf(*shown_[cell.scene], cell); }
  bool same(std::size_t cell, std::size_t k) const { return same_[cell * steps() + k]; }

  const Expected& expected_;
  const Shown& shown_;
  std::vector<Cell> cells_;
  std::vector<bool> same_; ///< by cell and step
};

/// Goes from what is right to what may be wrong.
class Blaming {
public:
  Blaming(const Expected& expected, const Shown& shown, const std::set<std::string>& begun,
          const Suspect& suspect)
      : expected_(expected), begun_(begun), suspect_(suspect), judging_(expected, shown),
        should_(expectedStep(expected, begun)), windows_(judging_.withTheseWindows()),
        wrong_(judging_.firstWrong(should_)), last_(judging_.firstWrongInOwnScene(should_)) {}

  std::vector<Row> run() {
    judgeEach();
    if (windows_.empty() && judging_.isFinishedInAnotherWay()) {
      allBegunAreDone();
      return all_;
    }
    // What comes after a step that somebody has left out lacks that step, so nothing tells what
    // else it lacks.
    gap_ = std::size_t(
               std::ranges::find_if(
                   all_, [](const Row& row) { return row.state == State::notBegun && row.seen; }) -
               all_.begin()) +
           1;
    if (Row* culprit = culpritOf()) {
      culprit->isFirst = true;
      blame(*culprit);
    }
    for (Row& row : all_)
      if (const std::size_t last = lastToShow(row.todo); row.state == State::done && last > should_)
        row.showsWith = expected_.todos[last - 1];
    return all_;
  }

private:
  bool isBegun(const Row& row) const { return begun_.count(row.todo) > 0; }
  bool isNamed(const Row& row) const { return row.todo == suspect_.todo; }
  /// Is the first wrong picture one of a scene that was not handed out?
  bool isInAnother() const { return wrong_ && judging_.isAnother(*wrong_); }
  /// Of an unfinished program the last step was not looked at before.
  bool isLastOfUnfinished(std::size_t k) const {
    return k == should_ && should_ + 1 < judging_.steps();
  }
  void allBegunAreDone() {
    for (Row& row : all_)
      if (isBegun(row)) row.state = State::done;
  }

  /// What is done or not begun; the rest waits.
  void judgeEach() {
    for (std::size_t k = 1; k < judging_.steps(); ++k) {
      const std::optional<std::size_t> changed = judging_.firstChanged(k);
      const std::optional<std::size_t> unlike = judging_.firstUnlike(k, should_);
      first_.push_back(unlike ? unlike : changed);
      Row row{expected_.todos[k - 1], State::notBegun, changed.has_value()};
      if (!windows_.empty() && k <= windows_.front())
        row.state = isBegun(row) || row.seen ? State::done : State::notBegun;
      else if (isBegun(row) && ((changed && !unlike) || (!row.seen && !windows_.empty())))
        row.state = State::done;
      else if (isBegun(row))
        row.state = State::waits;
      all_.push_back(row);
    }
  }

  /// Of those that aren't right one is to be mended first: the suspect; else, of those that change
  /// the earliest wrong picture, the one that changes what is wrong in it, or the last one.
  Row* culpritOf() {
    Row* culprit = nullptr;
    std::size_t earliest = 0;
    double most = -1;
    for (std::size_t k = 1; k < judging_.steps(); ++k) {
      Row& row = all_[k - 1];
      if (isNamed(row) && row.state != State::notBegun &&
          (suspect_.isExplained || windows_.empty()) && (k <= gap_ || suspect_.isSure))
        return &row;
      if (row.state != State::waits || k > std::min(gap_, last_) || !first_[k]) continue;
      const double overlap = isLastOfUnfinished(k) ? 1 : judging_.overlap(*first_[k], k, should_);
      if (!culprit || *first_[k] < earliest || (*first_[k] == earliest && overlap > most)) {
        culprit = &row;
        earliest = *first_[k];
        most = overlap;
      }
    }
    // What each one changes first may be right, and the earliest wrong picture comes before it.
    // Then it is the one that changes what is wrong in that, or the last one.
    if (windows_.empty() && gap_ > should_ && (!culprit || (wrong_ && *wrong_ < earliest))) {
      most = culprit ? kOwn : -1;
      const std::size_t cell = wrong_ ? judging_.firstWrongThere(*wrong_, should_) : 0;
      for (std::size_t k = 1; k < judging_.steps() && k <= last_; ++k) {
        Row& row = all_[k - 1];
        if (row.state != State::waits && row.state != State::done) continue;
        if (isInAnother() && !judging_.isUsedThere(*wrong_, k, should_)) continue;
        const bool isLast = isLastOfUnfinished(k) && row.state == State::waits;
        const double overlap = isLast ? 1 : wrong_ ? judging_.overlap(cell, k, should_) : 0;
        if (overlap < most) continue;
        culprit = &row;
        most = overlap;
      }
    }
    // Where a step was left out, and nothing else is known, the last one before it.
    if (!culprit && windows_.empty() && gap_ <= should_)
      for (std::size_t k = 1; k < gap_; ++k)
        if (isBegun(all_[k - 1])) culprit = &all_[k - 1];
    return culprit;
  }

  /// Those that draw what is wrong, and that nothing else shows to be right.
  std::set<std::string> drawing() const {
    std::set<std::string> todos;
    for (std::size_t k = 1; wrong_ && k <= std::min({should_, gap_, last_}); ++k) {
      const Row& row = all_[k - 1];
      // What the handed-out scenes show tells nothing of another one, nor the public one of those
      // that are there for a TODO.
      if ((judging_.isAnother(*wrong_)
               ? judging_.isUsedThere(*wrong_, k, should_) &&
                     (!judging_.isRightThere(*wrong_, k, should_) ||
                      suspect_.binding.count(row.todo))
               : suspect_.spoiling.count(row.todo) ||
                     ((row.state == State::waits || judging_.isOfATodo(*wrong_)) &&
                      judging_.isChanged(*wrong_, k))) ||
          judging_.changesWhatIsWrong(*wrong_, k, should_) ||
          judging_.isKnownInPart(k, *wrong_, should_))
        todos.insert(row.todo);
    }
    return todos;
  }

  /// Steps of which there are mistakes that show first in a program that has come to this one:
  /// they were not seen before.
  std::set<std::string> shownFirstHere() const {
    std::set<std::string> todos;
    for (const Fault& fault : expected_.faults)
      for (const Row& row : all_)
        if (fault.step == should_ && row.todo == fault.todo && isBegun(row)) todos.insert(row.todo);
    return todos;
  }

  /// The step with which the last of the known mistakes in a TODO shows.
  std::size_t lastToShow(const std::string& todo) const {
    std::map<std::string, std::size_t> first; // of each mistake
    for (const Fault& fault : expected_.faults) {
      if (fault.todo != todo) continue;
      const auto known = first.try_emplace(fault.signature.group, fault.step).first;
      known->second = std::min(known->second, fault.step);
    }
    std::size_t last = 0;
    for (const auto& [mistake, step] : first) last = std::max(last, step);
    return last;
  }

  void blame(Row& culprit) {
    // A scene that is there for a TODO shows that, and those that it names.
    const std::set<std::string> drawing =
        isNamed(culprit) && isInAnother() ? suspect_.also : this->drawing();
    std::set<std::string> waiting;
    for (const Row& row : all_)
      if (row.state == State::waits) waiting.insert(row.todo);
    // A little that differs may come of what is there already of a later step.
    if (windows_.empty() && !suspect_.isExplained && gap_ <= should_ &&
        judging_.isNearly(gap_ - 1)) {
      for (std::size_t k = 1; k < gap_; ++k)
        if (isBegun(all_[k - 1])) all_[k - 1].state = State::done;
      return;
    }
    if (windows_.empty() && !suspect_.isExplained && judging_.isNearly(should_)) {
      allBegunAreDone();
      if (gap_ <= should_) return; // a step that was left out explains it
      culprit.state = State::nearly;
      for (Row& row : all_)
        if (isBegun(row) && (drawing.count(row.todo) || suspect_.drawing.count(row.todo)))
          row.state = State::nearly;
      return;
    }
    const bool inWindows = std::ranges::find(windows_, should_) == windows_.end();
    const bool isDrawn = wrong_ && judging_.isDrawn(*wrong_);
    culprit.state = inWindows || suspect_.isExplained || !isDrawn ? State::wrong : State::differs;
    if (culprit.state == State::differs && wrong_) return differ(culprit);
    // What comes before it and isn't seen is not what is wrong.
    for (Row& row : all_)
      if (&row < &culprit && row.state == State::waits) row.state = State::done;
    if (culprit.state == State::wrong) doubt(culprit, drawing, waiting, inWindows);
  }

  /// Windows are right, and a pass isn't as it should be: the last step that changes it differs.
  void differ(Row& culprit) {
    Row* row = &culprit;
    for (std::size_t k = 1; k <= should_ && !judging_.isChanged(*wrong_, indexOf(culprit)); ++k)
      if (isBegun(all_[k - 1]) && judging_.isChanged(*wrong_, k)) row = &all_[k - 1];
    for (Row& other : all_)
      if (other.state == State::waits && &other < row) other.state = State::done;
    if (row != &culprit) culprit.state = State::waits;
    row->state = State::differs;
  }

  std::size_t indexOf(const Row& row) const { return std::size_t(&row - all_.data()) + 1; }

  /// Pictures alone don't tell which of several it is, unless the others were looked at before.
  ///   drawing: what is wrong;  waiting: of these no picture is right
  void doubt(Row& culprit, const std::set<std::string>& drawing,
             const std::set<std::string>& waiting, bool inWindows) {
    const bool isKnown = isNamed(culprit) && !suspect_.isGuess;
    const bool isLast = isLastOfUnfinished(indexOf(culprit));
    const auto mayBe = [&](const std::set<std::string>& todos) {
      for (Row& row : all_)
        if (&row == &culprit || (row.state != State::notBegun && todos.count(row.todo)))
          row.state = State::maybe;
    };
    if (isKnown && !suspect_.also.empty()) return mayBe(suspect_.also);
    if (suspect_.showsNothing) return doubtUnseenBefore(culprit);
    if (!wrong_ || isKnown || !(inWindows || suspect_.isGuess)) return;
    if (isLast && !suspect_.isLater && !isInAnother()) {
      std::set<std::string> earlier = shownFirstHere();
      earlier.erase(culprit.todo);
      if (!earlier.empty()) mayBe(earlier);
      return doubtUnseenBefore(culprit);
    }
    mayBe(suspect_.isLater ? begun_ : drawing);
    // One that draws where no step does may have taken another's picture for a step's own.
    if (judging_.hasOwnPasses())
      for (std::size_t k = 1; k < indexOf(culprit); ++k)
        if (first_[k] && isBegun(all_[k - 1]) && judging_.isPass(*first_[k]))
          all_[k - 1].state = State::maybe;
    mayBe(suspect_.also);
    mayBe({suspect_.todo});
    // A step before may have another scene's picture wrong, which doesn't come of this one.
    for (std::size_t k = 1; &all_[k - 1] < &culprit; ++k)
      if (first_[k] && waiting.count(all_[k - 1].todo) && !judging_.isOneScene(*first_[k], *wrong_))
        all_[k - 1].state = State::maybe;
    for (Row& row : all_)
      if (row.state == State::maybe && (waiting.count(row.todo) || &row == &culprit))
        doubtUnseenBefore(row);
  }

  /// Of what it stands on nothing may have been seen before.
  void doubtUnseenBefore(Row& row) {
    for (std::size_t k = indexOf(row); k > 1 && !all_[k - 2].seen && isBegun(all_[k - 2]); --k)
      all_[k - 1].state = all_[k - 2].state = State::maybe;
  }

  const Expected& expected_;
  const std::set<std::string>& begun_;
  const Suspect& suspect_;
  Judging judging_;
  std::size_t should_;               ///< steps that the program should have done
  std::vector<std::size_t> windows_; ///< steps after which all windows are the program's
  std::optional<std::size_t> wrong_; ///< the first picture that isn't as it should be
  std::size_t last_;                 ///< no later step makes what is wrong
  std::size_t gap_ = 0;              ///< the first step that was left out
  std::vector<Row> all_;
  std::vector<std::optional<std::size_t>> first_{std::nullopt}; ///< wrong picture, of each step
};

} // namespace

bool allRight(const std::vector<Row>& rows) {
  return std::ranges::all_of(rows, [](const Row& row) {
    return row.state == State::done || row.state == State::notBegun;
  });
}

bool windowsPass(const Expected& expected, const Shown& shown, std::size_t step) {
  const Judging judging(expected, shown);
  return judging.isNearly(step) || judging.isFinishedInAnotherWay();
}

std::set<std::string> doneInPictures(const Expected& expected, const Shown& shown) {
  const Judging judging(expected, shown);
  std::set<std::string> done;
  for (std::size_t k = 1; k < judging.steps(); ++k)
    if (const auto first = judging.firstChanged(k); first && judging.isFrom(*first, k))
      done.insert(expected.todos[k - 1]);
  return done;
}

std::vector<Slot> ownPasses(const Expected& expected, const SceneViews& shown, std::size_t scene) {
  std::vector<Slot> own;
  for (const diagnosis::PassView& pass : shown.passes)
    if (std::ranges::none_of(expected.steps,
                             [&](const Run& step) { return step[scene].find(pass.slot); }))
      own.push_back(pass.slot);
  return own;
}

std::size_t expectedStep(const Expected& expected, const std::set<std::string>& begun) {
  std::size_t step = 0;
  for (std::size_t k = 1; k <= expected.todos.size(); ++k)
    if (begun.count(expected.todos[k - 1])) step = k;
  return step;
}

std::vector<Row> rows(const Expected& expected, const Shown& shown,
                      const std::set<std::string>& begun, const Suspect& suspect) {
  return Blaming(expected, shown, begun, suspect).run();
}

} // namespace ggrade::check
