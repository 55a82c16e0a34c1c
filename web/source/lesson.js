// A lesson as it is gone through: steps with or without a question, the answers given, and where one is. It draws nothing.
//
// Events: 'step' when another step is shown, 'answer' when a question was answered, 'done' when the end is reached.
import {inWords, isRight, score} from './marks.js';

export class Lesson extends EventTarget {
  /// `kind`: 'lesson' or 'quiz'; `source` and `seed`: what the address says of a quiz.
  constructor({title, notes, feedback = 'at-once', language = 'en'}, {kind = 'lesson', source = null, seed = null} = {}) {
    super();
    Object.assign(this, {title, notes, feedback, language, kind, source, seed});
    this.index = -1;
    this.answers = new Map();   // by a note's index
    this.told = false;          // that it is done
  }

  get count() { return this.notes.length; }
  get note() { return this.notes[this.index] ?? null; }   // null: the end, where the marks are told
  get atEnd() { return this.index >= this.count; }
  get questions() { return this.notes.filter(note => note.question); }
  get hasEnd() { return this.questions.length > 0; }
  get last() { return this.hasEnd ? this.count : this.count - 1; }
  get atOnce() { return this.feedback !== 'at-end'; }
  /// May it be told whether the answer to this step was right?
  mayTell(index = this.index) { return this.answers.has(index) && (this.atOnce || this.told); }

  go(index) {
    const to = Math.min(Math.max(Math.trunc(index) || 0, 0), this.last);
    if (to === this.index) return;
    this.index = to;
    this.since = performance.now();
    this.dispatchEvent(new Event('step'));
    if (to === this.last && !this.told && (this.atEnd || !this.hasEnd)) {
      this.told = true;
      this.dispatchEvent(new Event('done'));
    }
  }

  /// Once a question. `given`: see marks.js.
  answer(given) {
    const {note, index} = this;
    if (!note?.question || this.told || this.answers.has(index)) return null;
    const {kind, ask} = note.question;
    const row = {kind, question: ask, given: inWords(note.question, given), right: isRight(note.question, given), seconds: (performance.now() - this.since) / 1000, raw: given};
    this.answers.set(index, row);
    this.dispatchEvent(new Event('answer'));
    return row;
  }

  /// One for each question, answered or not.
  get rows() {
    const rows = [];
    this.notes.forEach((note, index) => {
      if (!note.question) return;
      const {kind, ask} = note.question, unanswered = {kind, question: ask, given: '', right: false, seconds: 0};
      rows.push({...(this.answers.get(index) ?? unanswered), number: rows.length + 1, index, asked: note.question});
    });
    return rows;
  }
  get score() { return score(this.rows); }
}
