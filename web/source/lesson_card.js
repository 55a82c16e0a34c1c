// A lesson beside the picture: title, text, question, back and on, and the list of its steps.
import {element} from './dom.js';
import {t} from './language.js';
import {asCsv, asJson, rightAnswer, shownAnswer} from './marks.js';
import {Narration} from './narration.js';
import {questionForm} from './question_form.js';

const paragraphs = text => String(text ?? '').split(/\n+/).filter(Boolean).map(line => element('p', {}, line));

export class LessonCard {
  /// `does`: {leave, handout, again}; each may be missing.
  constructor(viewer, lesson, does) {
    Object.assign(this, {viewer, lesson, does});
    this.narration = new Narration(lesson.language);
    this.heading = element('h2', {id: 'lesson-title', tabindex: -1});
    this.where = element('p', {class: 'quiet', id: 'lesson-step'});
    this.body = element('div', {id: 'lesson-body'});
    this.back = element('button', {type: 'button', title: t('Key {key}', {key: 'P'}), onclick: () => lesson.go(lesson.index - 1)}, `\u2190 ${t('Back')}`);
    this.next = element('button', {type: 'button', class: 'main', title: t('Key {key}', {key: 'N'}), onclick: () => lesson.go(lesson.index + 1)});
    this.steps = element('ol', {});
    this.told = element('p', {class: 'unseen', role: 'status', 'aria-live': 'polite'});
    const all = lesson.kind === 'lesson' ? element('details', {class: 'steps'}, element('summary', {}, t('All steps')), this.steps) : null;
    this.host = document.getElementById('lesson');
    this.host.setAttribute('aria-label', lesson.kind === 'quiz' ? t('Quiz') : t('Lesson'));
    this.host.replaceChildren(...[this.where, this.heading, this.body, element('div', {class: 'row steer'}, this.back, this.next), all, this.ways(), this.told].filter(Boolean));
    this.host.hidden = false;
    document.body.classList.add('teaching');
    for (const event of ['step', 'answer']) lesson.addEventListener(event, () => this.show(event));
  }

  ways() {
    const {does, lesson} = this;
    const button = (act, words) => act ? element('button', {type: 'button', onclick: act}, words) : null;
    return element('div', {class: 'row'}, button(does.quiz, t('Questions only')), button(does.handout, t('Handout to print')),
      button(does.leave, lesson.kind === 'quiz' ? t('Leave the quiz') : t('Close the lesson')));
  }

  show(event) {
    const {lesson} = this, {note, index} = lesson, held = this.host.contains(document.activeElement);
    this.where.textContent = note ? this.place(index) : lesson.title;
    this.heading.textContent = note ? note.title || note.question?.ask || lesson.title : t('Your marks');
    this.body.replaceChildren(...(note ? this.step(note) : this.end()));
    this.steer();
    this.list();
    if (event === 'step') this.narration.begin();
    if (event === 'step') {
      this.told.textContent = [this.where.textContent, this.heading.textContent, ...this.spoken(note)].join('. ');
      this.host.closest('#panel').scrollTop = 0;
      if (held) this.heading.focus({preventScroll: true});
    } else if (held || document.activeElement === document.body) this.next.focus({preventScroll: true});
  }

  place(index) {
    const {lesson} = this, at = {step: index + 1, steps: lesson.count};
    return lesson.kind === 'quiz' ? t('Question {step} of {steps}', at) : t('Step {step} of {steps}', at);
  }

  spoken(note) { return note ? [note.text, note.question && note.question.ask !== note.title ? note.question.ask : ''].filter(Boolean) : this.body.firstChild ? [this.body.firstChild.textContent] : []; }

  steer() {
    const {lesson} = this, {index} = lesson, ends = index >= lesson.last;
    this.back.disabled = index <= 0;
    this.next.hidden = ends;
    const waits = lesson.note?.question && !lesson.answers.has(index) && !lesson.told;
    this.next.textContent = `${index === lesson.count - 1 ? t('To your marks') : waits ? t('Skip') : t('Next')} \u2192`;
    this.next.classList.toggle('main', !waits);
  }

  list() {
    const {lesson} = this;
    if (lesson.kind !== 'lesson') return;
    const items = lesson.notes.map((note, i) => {
      const mark = lesson.mayTell(i) ? lesson.answers.get(i).right ? ' \u2713' : ' \u2717' : '';
      return element('li', {}, element('button', {type: 'button', 'aria-current': i === lesson.index ? 'step' : null, onclick: () => lesson.go(i)}, (note.title || note.question?.ask || t('Step {step}', {step: i + 1})) + mark));
    });
    this.steps.replaceChildren(...items);
  }

  step(note) {
    const parts = paragraphs(note.text);
    parts.push(...this.narration.parts(note));
    if (note.question) parts.push(questionForm(this.viewer, this.lesson, note));
    return parts;
  }

  close() {
    this.narration.close();
    this.host.hidden = true;
  }

  end() {
    this.narration.parts({});
    const {lesson} = this, {rows} = lesson, {right, of} = lesson.score;
    const told = element('p', {class: 'score'}, t('{right} of {all} right', {right, all: of}));
    const list = element('ol', {class: 'marks'}, ...rows.map(row => {
      const answer = row.given ? t('You: {answer}.', {answer: shownAnswer(row.asked, row.raw)}) : t('Not answered.');
      return element('li', {class: row.right ? 'good' : 'bad'}, element('strong', {}, `${row.right ? `\u2713 ${t('Right')}` : `\u2717 ${t('Wrong')}`}: `), row.question, element('br'),
        element('span', {class: 'quiet'}, row.right ? answer : `${answer} ${t('Right: {answer}.', {answer: rightAnswer(row.asked)})}`), row.asked.explain ? element('p', {class: 'quiet'}, row.asked.explain) : null);
    }));
    const save = (name, kind, text) => element('button', {type: 'button', onclick: () => download(name, kind, text())}, t('Save {format}', {format: name.split('.').pop().toUpperCase()}));
    const again = this.does.again ? element('button', {type: 'button', onclick: this.does.again}, t('Again, other order')) : null;
    return [told, list, element('div', {class: 'row'}, save('marks.csv', 'text/csv', () => asCsv(rows)), save('marks.json', 'application/json', () => asJson(lesson.title, rows)), again)];
  }
}

function download(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], {type: `${type};charset=utf-8`})), link = element('a', {href: url, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
