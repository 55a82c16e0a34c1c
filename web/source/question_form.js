// The form in which a question is answered, and what is said of the answer.
import {element} from './dom.js';
import {rightAnswer} from './marks.js';

export function questionForm(viewer, lesson, note) {
  const {question} = note, row = lesson.answers.get(lesson.index), tells = lesson.mayTell();
  const ask = note.title === question.ask ? null : element('p', {class: 'ask'}, question.ask);
  const answered = Boolean(row) || lesson.told;
  const form = {choice: choices, number: entry, click}[question.kind](viewer, lesson, question, row, answered, tells);
  return element('div', {class: 'question', role: 'group', 'aria-label': question.ask}, ask, form, ...feedback(question, row, lesson.told && !row, tells));
}

function feedback(question, row, missed, tells) {
  if (missed) return [element('p', {class: 'quiet'}, `Not answered. Right: ${rightAnswer(question)}.`)];
  if (!row) return [];
  if (!tells) return [element('p', {class: 'quiet', role: 'status'}, `You: ${row.given}. You will be told at the end.`)];
  const words = row.right ? '\u2713 Right.' : `\u2717 Not quite. You: ${row.given}. Right: ${rightAnswer(question)}.`;
  return [element('div', {class: `verdict${row.right ? '' : ' wanting'}`, role: 'status'}, words), question.explain ? element('p', {}, question.explain) : null].filter(Boolean);
}

function choices(viewer, lesson, question, row, answered, tells) {
  const buttons = question.choices.map((words, index) => {
    const right = tells && index === question.answer, wrong = tells && row?.raw === index && !row.right;
    const said = `${right ? '\u2713 ' : wrong ? '\u2717 ' : ''}${words}`;
    const button = element('button', {type: 'button', disabled: answered, 'aria-pressed': row ? String(row.raw === index) : null, onclick: () => lesson.answer(index)}, said);
    if (right) button.classList.add('right');
    if (wrong) button.classList.add('wrong');
    return element('li', {}, button);
  });
  return element('ul', {class: 'answers'}, ...buttons);
}

function entry(viewer, lesson, question, row, answered) {
  const input = element('input', {type: 'text', inputmode: 'decimal', autocomplete: 'off', size: 7, 'aria-label': question.ask + (question.unit ? `, in ${question.unit}` : ''), value: row ? String(row.raw) : '', disabled: answered});
  const wrong = element('p', {class: 'quiet', role: 'alert'});
  const send = event => {
    event.preventDefault();
    const text = input.value.trim().replace(',', '.').replace('\u2212', '-'), value = Number(text);
    if (!/^[-+]?(\d+\.?\d*|\.\d+)$/.test(text) || !Number.isFinite(value)) {
      wrong.textContent = 'Write a number.';
      input.focus();
      return;
    }
    lesson.answer(value);
  };
  return element('form', {class: 'row', onsubmit: send}, input, question.unit || null, answered ? null : element('button', {type: 'submit', class: 'main'}, 'Answer'), wrong);
}

function click(viewer, lesson, question, row, answered) {
  if (answered) return null;
  const touch = matchMedia('(pointer: coarse)').matches, missed = element('p', {class: 'quiet', role: 'status'});
  const cross = element('button', {type: 'button', onclick: () => {
    viewer.pointing.showCross();
    if (!viewer.pointing.taken(viewer.pointing.at)) missed.textContent = 'There is nothing under the cross.';
  }}, 'Take what is under the cross');
  cross.addEventListener('focus', () => viewer.pointing.showCross());
  const how = touch ? 'Tap it in the picture.' : 'Click it in the picture. By keyboard: turn the tooth with the arrow keys, move the cross with Shift and the arrow keys, and press Enter.';
  return element('div', {}, element('p', {class: 'quiet'}, how), touch ? null : cross, missed);
}
