#include "engine/viewer/notes/notes_mode.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/ui/dialog.h"
#include "engine/ui/drawing.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/names/canals.h"
#include "engine/viewer/names/names_mode.h"
#include "engine/viewer/notes/lesson_dialogs.h"
#include "engine/viewer/notes/notes_panel.h"
#include "engine/viewer/notes/pins.h"
#include "engine/viewer/workspace.h"
#include "recon/core/lower_case.h"

namespace odontoscope {

void NotesMode::loaded(const LoadRequest&) {
  if (notes_.at_risk() && !may_go_) save_notes();  // written while it loaded: nobody was asked
  may_go_ = false;
  notes_ = {};
  history_ = {};
  lesson_.leave();
  if (auto lesson = std::exchange(to_give_, std::nullopt)) take_lesson(std::move(*lesson));
}

void NotesMode::load_failed() {
  to_give_.reset();
  may_go_ = false;
}

bool NotesMode::takes_request(LoadRequest& request) {
  if (!notes_.at_risk() || may_go_) return open_lesson(request);
  notes_.leaving = LeavingNotes{std::move(request)};
  return true;
}

bool NotesMode::may_close() {
  if (!notes_.at_risk()) return true;
  if (!notes_.leaving) notes_.leaving = LeavingNotes{};
  return false;
}

void NotesMode::answer_leaving() {
  using Answer = LeavingNotes::Answer;
  if (!notes_.leaving || notes_.leaving->answer == Answer::none) return;
  const LeavingNotes leaving = std::move(*std::exchange(notes_.leaving, std::nullopt));
  if (leaving.answer == Answer::save) save_notes();
  if (leaving.answer == Answer::stay ||
      (leaving.answer == Answer::save && notes_.at_risk())) {  // or it could not be written
    for (const auto& mode : at_.modes) mode->load_failed();
    return;
  }
  if (!leaving.to_open) {
    state_.close = true;
    return;
  }
  may_go_ = true;
  at_.open(*leaving.to_open);
  if (!at_.modes.loading()) may_go_ = false;
}

void NotesMode::take_requests() {
  history_.watch(notes_, at_.interface.wants_text() ? LessonHistory::Words::begun : LessonHistory::Words::whole);
  if (std::exchange(notes_.undo, false)) step_history(HistoryStep::undo);
  if (std::exchange(notes_.redo, false)) step_history(HistoryStep::redo);
  if (std::exchange(notes_.write, false)) write_note();
  if (std::exchange(notes_.retake, false) && notes_.draft) {
    const LessonNote now = view_now();
    notes_.draft->camera = now.camera;
    notes_.draft->scene = now.scene;
    notes_.draft->inside = now.inside;
  }
  if (std::exchange(notes_.save, false)) save_notes();
  if (std::exchange(lesson_.save_marks, false)) save_marks();
  if (std::exchange(lesson_.pick_middle, false)) point_at_middle();
  if (const auto wanted = std::exchange(notes_.go_to, {})) go_to_note(*wanted);
  answer_leaving();
}

bool NotesMode::perform(Action action) {
  if (!state_.shown) {
    if (action == Action::toggle_lessons) lesson_.toggle_menu();
    return action == Action::toggle_lessons;
  }
  if (action == Action::toggle_help || action == Action::open_file) return false;  // over whatever moves
  at_.settle_looks();
  if (action == Action::write_note) {
    if (!notes_.draft) write_note();
    return true;
  }
  if (action == Action::toggle_lessons) {
    lesson_.toggle_menu();
    return true;
  }
  if (action == Action::undo || action == Action::redo) {
    step_history(action == Action::redo ? HistoryStep::redo : HistoryStep::undo);
    return true;
  }
  if (!notes_.shown) return false;
  if (action == Action::next_step && lesson_.step(1, notes_)) return true;
  if (action == Action::previous_step && lesson_.step(-1, notes_)) return true;
  if (action == Action::next_step) {
    if (*notes_.shown + 1 < notes_.lesson.notes.size()) go_to_note(*notes_.shown + 1);
    return true;
  }
  if (action == Action::previous_step) {
    if (*notes_.shown > 0) go_to_note(*notes_.shown - 1);
    return true;
  }
  return false;
}

/// The change before is taken back, or the one that was taken back is made again.
void NotesMode::step_history(HistoryStep step) {
  const bool again = step == HistoryStep::redo;
  history_.watch(notes_, LessonHistory::Words::whole);
  const std::vector<LessonNote> before = notes_.lesson.notes;
  const std::optional<LessonNote> draft_before = notes_.draft;
  const auto what = again ? history_.redo(notes_) : history_.undo(notes_);
  if (what)
    notice(again ? fmt::format("Done again: {}.", *what) : fmt::format("Undone: {}.", *what));
  else
    notice(again ? "There is nothing to do again." : "There is nothing to undo.");
  if (what) show_change(before, draft_before);
}

/// Leads to what was changed.
void NotesMode::show_change(const std::vector<LessonNote>& before, const std::optional<LessonNote>& draft_before) {
  const auto& notes = notes_.lesson.notes;
  if (notes_.shown && *notes_.shown >= notes.size()) notes_.shown.reset();
  if (notes_.draft) {
    const LessonNote& draft = *notes_.draft;
    if (draft_before && (draft_before->camera != draft.camera || draft_before->scene != draft.scene))
      show_view_of(draft);
    return;
  }
  const auto [now, then] = std::mismatch(notes.begin(), notes.end(), before.begin(), before.end());
  if (now != notes.end()) notes_.go_to = static_cast<std::size_t>(now - notes.begin());
}

void NotesMode::write_note() {
  if (!state_.shown) return;
  if (notes_.lesson.notes.size() >= most_notes) {
    notice(fmt::format("A lesson has at most {} notes.", most_notes));
    return;
  }
  notes_.draft = view_now();
  notes_.draft_of.reset();
  notes_.fresh_draft = true;
  notes_.shown.reset();
}

/// The view as it is, or is on its way to.
LessonNote NotesMode::view_now() {
  FlyMode& fly = at_.modes.get<FlyMode>();
  fly.let_go();
  at_.settle_looks();
  Scene seen = state_.scene;
  seen.camera = at_.camera_goal();
  return note_of(seen, fly.inside() ? TakenFrom::inside : TakenFrom::outside);
}

bool NotesMode::handle(const Event& event) {
  if (const auto* key = std::get_if<KeyChanged>(&event)) {
    if (key->down && key->key == Key::enter && placing()) {
      point_at_middle();
      return true;
    }
    return !at_.interface.wants_text() && lesson_.handle(event, notes_, state_);
  }
  if (std::holds_alternative<TextTyped>(event)) return lesson_.handle(event, notes_, state_) || writing();
  return false;
}

/// The first click begins it, the second ends it.
bool NotesMode::draw_arrow_at(const ViewPane& pane, double x, double y) {
  const auto hit = at_.hit_at(pane, x, y);
  if (notes_.placing == NotesState::Placing::arrow_tail) {
    notes_.tail = ArrowTail{pane.camera, place_in(pane.area, x, y)};
    if (hit) notes_.tail->surface = hit->point_mm;
    notes_.placing = NotesState::Placing::arrow_head;
    return true;
  }
  if (!hit) return false;
  if (!end_arrow(notes_, hit->point_mm)) notice("An arrow ends at another place than it begins.");
  return true;
}

/// What a click here means for the lesson: a pin, an arrow or an answer for the draft, or an answer to the question.
/// true: it was for the lesson.
bool NotesMode::point_at(const ViewPane& pane, double x, double y) {
  const bool placing = notes_.draft && this->placing();
  if (!placing && !lesson_.wants_click(notes_)) return false;
  const bool arrow =
      notes_.placing == NotesState::Placing::arrow_tail || notes_.placing == NotesState::Placing::arrow_head;
  if (placing && arrow && draw_arrow_at(pane, x, y)) return true;
  const auto clicked = arrow ? std::nullopt : pointed_at(pane, x, y);
  if (placing && notes_.placing == NotesState::Placing::pin) {
    if (const auto hit = at_.hit_at(pane, x, y)) {
      notes_.draft->marks.push_back({hit->point_mm, ""});
      stop_placing(notes_);
      return true;
    }
  } else if (clicked && placing) {
    if (notes_.draft->question) {
      notes_.draft->question->structure = clicked->structure;
      notes_.draft->question->part = clicked->part;
    }
    stop_placing(notes_);
    return true;
  } else if (clicked) {
    lesson_.answer(notes_, *clicked);
    return true;
  }
  notice("There is nothing at this place: point at the tooth.");
  return true;
}

void NotesMode::point_at_middle() {
  if (at_.layout.panes.empty() || !state_.shown) return;
  const ViewPane& pane = at_.front();
  point_at(pane, pane.area.left + pane.area.width / 2, pane.area.top + pane.area.height / 2);
}

/// For a question about the pulp a canal counts as soon as it is seen, whatever translucent lies before it.
std::optional<PointedAt> NotesMode::pointed_at(const ViewPane& pane, double x, double y) const {
  const LessonQuestion* question = notes_.draft ? nullptr : lesson_.asked(notes_);
  const auto is_pulp = [&](const std::string& structure) {
    const auto& cavities = state_.shown->flight->cavities;
    return lower_case(structure).find("pulp") != std::string::npos ||
           std::any_of(cavities.begin(), cavities.end(),
                       [&](const FlightSpace& space) { return space.structure == structure; });
  };
  const auto hit = at_.hit_at(pane, x, y);
  if (const auto canal = at_.modes.get<NamesMode>().canal_at(pane, x, y);
      canal && ((question && is_pulp(question->structure)) || (hit && is_pulp(hit->structure)) || !question))
    return PointedAt{question ? question->structure : pulp_of(*state_.shown, canal->cavity),
                     name_of(*canal, *state_.shown->flight)};
  return hit ? std::optional(PointedAt{hit->structure, ""}) : std::nullopt;
}

bool NotesMode::click(const Click& click) {
  if (!point_at(click.pane, click.x, click.y)) return false;
  at_.pointing.last_click = {};
  return true;
}

bool NotesMode::hover(const Hover&) {
  Pointing& hand = at_.pointing;
  const bool asked = lesson_.asked(notes_);
  if (!asked && !placing()) return false;
  hand.hit.reset();  // what is there is the question
  if (pointing() && hand.at_model()) hand.pointer = Pointer::cross;
  return true;
}

bool NotesMode::put_away(PutAway what) {
  if (what == PutAway::dialog && notes_.leaving) {
    notes_.leaving->answer = LeavingNotes::Answer::stay;
    return true;
  }
  if (what != PutAway::step) return false;
  if (lesson_.menu())
    lesson_.close_menu();
  else if (placing())
    stop_placing(notes_);
  else if (notes_.draft)
    drop_draft(notes_);
  else if (notes_.shown)
    notes_.shown.reset();
  else
    return false;
  return true;
}

bool NotesMode::answer() {
  if (!notes_.leaving) return false;
  notes_.leaving->answer = LeavingNotes::Answer::save;
  return true;
}

/// Neither names nor the section's handle: not while they would answer a question, and not over a lesson's own pins and
/// arrows.
ModeEffects NotesMode::effects() const {
  const LessonNote* note = notes_.seen();
  const bool clear = !lesson_.asked(notes_) && !(note && (!note->marks.empty() || !note->arrows.empty()));
  return {.names = clear, .section_handle = clear, .first_hints = !notes_.shown && !notes_.draft};
}

void NotesMode::draw(DrawLayer layer, const DrawnPane& drawn) {
  if (layer == DrawLayer::marks && drawn.first) {
    const LessonNote* note = drawn.pane.db ? nullptr : notes_.seen();
    const PinsSeenFrom from{at_.modes.effects().from_outside, at_.modes.get<FlyMode>().inside()};
    if (note) draw_arrows(note->arrows, state_, from, drawn.pane, at_.interface, at_.layout.scale);
    if (note) draw_pins(note->marks, state_, from, drawn.pane, at_.interface, at_.layout.scale);
    if (notes_.tail) draw_begun_arrow(*notes_.tail, drawn.pane, {at_.pointing.x, at_.pointing.y}, at_.layout.scale);
    if (pointing()) draw_cross(drawn.pane.area, at_.layout.scale);  // that Enter takes
  }
  if (layer == DrawLayer::windows && state_.shown) draw_dock();
  if (layer == DrawLayer::lists && !at_.modes.loading())
    draw_lesson_menu(state_, lesson_, at_.interface, at_.layout.viewport);
}

void NotesMode::draw_dock() {
  const double before = lesson_.dock_height;
  const Area& viewport = at_.layout.viewport;
  draw_lesson_dock(notes_, state_, lesson_, at_.modes.get<FlyMode>().canal_here(), at_.interface,
                   {viewport.left, 0, viewport.width, static_cast<double>(at_.layout.size.height)}, at_.layout.scale);
  if (lesson_.dock_height != before) at_.frames_to_settle = 3;
}

bool NotesMode::draw_dialog() {
  if (!notes_.leaving) return false;
  using Answer = LeavingNotes::Answer;
  const Dialog dialog("leaving", at_.layout.viewport, 460);
  LeavingNotes& leaving = *notes_.leaving;
  dialog_title(at_.interface, "Your notes are not saved");
  widgets::wrapped(leaving.to_open
                       ? fmt::format("They are about {} and go when {} is opened.",
                                     state_.shown ? state_.shown->title : "this model", name_of(*leaving.to_open))
                       : "They go when the window is closed.");
  if (widgets::wide_button(leaving.to_open ? "Save them, then open" : "Save them, then close",
                           widgets::Emphasis::strong))
    leaving.answer = Answer::save;
  if (widgets::wide_button(leaving.to_open ? "Open without saving" : "Close without saving"))
    leaving.answer = Answer::drop;
  if (widgets::wide_button("Stay (Esc)")) leaving.answer = Answer::stay;
  return true;
}

std::vector<PanelSection> NotesMode::panel() {
  const auto lessons = [this] {
    if (widgets::wide_button("Lessons (G)", widgets::Emphasis::strong))
      state_.pending_actions.push_back(Action::toggle_lessons);
  };
  const auto notes = [this] { notes_section(notes_, history_, at_.modes.effects().from_outside, at_.interface); };
  return {{SectionPlace::lessons, lessons}, {SectionPlace::notes, notes, true}};
}

}  // namespace odontoscope
