// Lessons and quizzes of a page: which one is open, what the address says of it, and what is told to a page around it.
import {asked, tell} from './address.js';
import {chance} from './chance.js';
import {listen, report} from './events.js';
import {Handout} from './handout.js';
import {t} from './language.js';
import {Lesson} from './lesson.js';
import {LessonCard} from './lesson_card.js';
import {questionsOn} from './own_quiz.js';
import {Staging} from './staging.js';

export class Teaching {
  /// `file`: what the page carries, a tour; null: none.
  constructor(viewer, file) {
    this.viewer = viewer;
    this.file = file;
    this.staging = new Staging(viewer);
    this.lesson = null;
    this.handout = new Handout(viewer, this.staging, file, () => this.again());
    addEventListener('hashchange', () => this.follow());
    listen(step => this.lesson?.go(step - 1));
  }

  begin() {
    report('ready', {title: this.file?.title ?? this.viewer.description.title, steps: this.file?.notes.length ?? 0});
    if (!this.follow() && this.file) this.openLesson();
  }

  /// What the address asks for; false: nothing.
  follow() {
    const {step, quiz, seed, handout} = asked();
    if (handout) {
      if (!this.file) return false;
      this.openLesson(0);
      this.openHandout();
    } else if (quiz !== null) {
      if (this.lesson?.kind !== 'quiz' || (seed !== null && this.lesson.seed !== seed) || (quiz && this.lesson.source !== quiz)) this.openQuiz({source: quiz, seed});
      if (step !== null) this.lesson?.go(step - 1);
    } else if (step !== null && this.file) {
      if (this.lesson?.kind !== 'lesson') this.openLesson(step - 1);
      else this.lesson.go(step - 1);
    } else return false;
    return this.lesson !== null;
  }

  openLesson(index = 0) { this.open(new Lesson(this.file), index); }

  /// `source`: 'lesson' for the lesson's own questions, 'model' for those made from what the page carries, '' for the lesson's if it has any.
  openQuiz({source = '', seed = null} = {}) {
    const order = seed ?? 1 + Math.floor(Math.random() * 9999), dice = chance(order), own = (this.file?.notes ?? []).filter(note => note.question);
    const from = source === 'model' || own.length === 0 ? 'model' : 'lesson';
    const notes = from === 'model' ? questionsOn(this.viewer, dice) : dice.shuffled(own);
    if (notes.length === 0) return;
    const title = from === 'model' ? t('Quiz: {title}', {title: t(this.viewer.description.title)}) : this.file.title;
    this.staging.reset();
    this.open(new Lesson({title, notes, feedback: from === 'model' ? 'at-once' : this.file.feedback}, {kind: 'quiz', source: from, seed: order}), 0);
  }

  open(lesson, index) {
    const {viewer} = this;
    this.lesson = lesson;
    this.card?.close();
    this.card = new LessonCard(viewer, lesson, {
      leave: () => this.close(),
      handout: this.file && lesson.kind === 'lesson' ? () => this.openHandout() : null,
      quiz: this.file && lesson.kind === 'lesson' && lesson.hasEnd ? () => this.openQuiz({source: 'lesson'}) : null,
      again: lesson.kind === 'quiz' ? () => this.openQuiz({source: lesson.source}) : null,
    });
    document.getElementById('learn')?.setAttribute('hidden', '');
    lesson.addEventListener('step', () => this.show());
    lesson.addEventListener('answer', () => this.answered());
    lesson.addEventListener('done', () => report('done', {kind: lesson.kind, title: lesson.title, score: lesson.score, rows: lesson.rows.map(({number, kind, question, given, right, seconds}) => ({number, kind, question, given, right, seconds}))}));
    lesson.go(index);
  }

  show() {
    const {lesson} = this, {note, index, kind} = lesson;
    if (note) this.staging.show(note);
    else this.viewer.pins.show([]);
    this.askFor(note);
    tell(kind === 'quiz' ? {quiz: lesson.source, seed: lesson.seed, step: index + 1} : {step: index + 1});
    report('step', {kind, step: index + 1, steps: lesson.count, title: note?.title ?? ''});
  }

  /// While a question is open, names in the picture would tell the answer.
  askFor(note) {
    const {viewer, lesson} = this, open = Boolean(note?.question) && !lesson.answers.has(lesson.index) && !lesson.told;
    viewer.labels.muted = open;
    viewer.pointing.ask(open && note.question.kind === 'click' ? given => lesson.answer(given) : null);
    viewer.touch();
  }

  answered() {
    const {lesson} = this, {note, index} = lesson, {kind, question, given, right, seconds} = lesson.answers.get(index);
    this.askFor(note);
    report('answer', {step: index + 1, kind, question, given, right, seconds});
  }

  /// The step that is open, anew: after something else used the picture.
  again() { if (this.lesson?.note) this.staging.show(this.lesson.note); else this.viewer.leave(); }

  openHandout() {
    this.card?.narration.turn(false);
    tell({handout: ''});
    this.handout.open(this.file);
  }

  close() {
    if (this.viewer.inside) this.viewer.leave();
    this.lesson = null;
    this.card.close();
    document.getElementById('learn')?.removeAttribute('hidden');
    document.body.classList.remove('teaching');
    this.viewer.labels.muted = false;
    this.viewer.pointing.ask(null);
    this.staging.reset();
    tell({});
    document.getElementById('canvas').focus({preventScroll: true});
  }

  /// A key that is the lesson's; true: done.
  key(event) {
    if (!this.lesson) return false;
    if (this.viewer.pointing.key(event)) return true;
    const way = {n: 1, pagedown: 1, p: -1, pageup: -1}[event.key.toLowerCase()];
    if (!way) return false;
    this.lesson.go(this.lesson.index + way);
    return true;
  }
}
