#pragma once
// Lessons, quizzes and a teacher's notes: written, saved, opened, and given.

#include <optional>
#include <string>
#include <vector>

#include "engine/viewer/mode.h"
#include "engine/viewer/notes/lesson_history.h"
#include "engine/viewer/notes/lesson_player.h"
#include "engine/viewer/notes/notes_state.h"

namespace odontoscope {

class NotesMode final : public Mode {
 public:
  using Mode::Mode;

  NotesState& notes() { return notes_; }
  const NotesState& notes() const { return notes_; }
  const LessonPlayer& lesson() const { return lesson_; }

  void loaded(const LoadRequest& request) override;
  void load_failed() override;
  bool takes_request(LoadRequest& request) override;
  bool perform(Action action) override;
  bool handle(const Event& event) override;
  bool click(const Click& click) override;
  bool hover(const Hover& hover) override;
  bool put_away(PutAway what) override;
  bool answer() override;
  bool dialog_open() const override { return notes_.leaving || lesson_.menu(); }
  bool chooses_by_letter() const override { return lesson_.menu(); }
  bool writing() const override { return notes_.draft.has_value(); }
  bool may_close() override;
  void take_requests() override;
  void advance(double seconds) override { lesson_.advance(notes_, seconds); }
  ModeEffects effects() const override;
  double dock_height() const override { return lesson_.dock_height; }
  void draw(DrawLayer layer, const DrawnPane& pane) override;
  bool draw_dialog() override;
  std::vector<PanelSection> panel() override;

 private:
  void write_note();
  enum class HistoryStep { undo, redo };
  void step_history(HistoryStep step);
  void show_change(const std::vector<LessonNote>& before, const std::optional<LessonNote>& draft_before);
  LessonNote view_now();
  void answer_leaving();
  bool placing() const { return notes_.placing != NotesState::Placing::none; }
  bool pointing() const { return placing() || lesson_.wants_click(notes_); }
  bool point_at(const ViewPane& pane, double x, double y);
  bool draw_arrow_at(const ViewPane& pane, double x, double y);
  void point_at_middle();
  std::optional<PointedAt> pointed_at(const ViewPane& pane, double x, double y) const;
  void draw_dock();

  // notes_files.cpp
  void save_notes();
  void save_marks();
  bool open_lesson(LoadRequest& request);
  void take_lesson(Lesson lesson);

  // giving.cpp
  void go_to_note(std::size_t number);
  bool ride_for_note(const LessonNote& note);
  void show_view_of(const LessonNote& note);
  void show_inside(const LessonNote& note);
  void show_outside(const LessonNote& note);

  NotesState notes_;
  LessonPlayer lesson_;
  LessonHistory history_;
  std::optional<Lesson> to_give_;  // once its model is there
  bool may_go_ = false;            // the person said so of those that are there
};

}  // namespace odontoscope
