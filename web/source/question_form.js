// The form in which a question is answered, and what is said of the answer.
import {element} from './dom.js';
import {plainNumber, t} from './language.js';
import {rightAnswer, shownAnswer} from './marks.js';

export function questionForm(viewer, lesson, note) {
  const {question} = note, row = lesson.answers.get(lesson.index), tells = lesson.mayTell();
  const ask = note.title === question.ask ? null : element('p', {class: 'ask'}, question.ask);
  const answered = Boolean(row) || lesson.told;
  const form = {choice: choices, number: entry, click}[question.kind](viewer, lesson, question, row, answered, tells);
  return element('div', {class: 'question', role: 'group', 'aria-label': question.ask}, ask, form, ...feedback(question, row, lesson.told && !row, tells));
}

function feedback(question, row, missed, tells) {
  const right = t('Right: {answer}.', {answer: rightAnswer(question)}), you = row ? t('You: {answer}.', {answer: shownAnswer(question, row.raw)}) : '';
  if (missed) return [element('p', {class: 'quiet'}, `${t('Not answered.')} ${right}`)];
  if (!row) return [];
  if (!tells) return [element('p', {class: 'quiet', role: 'status'}, `${you} ${t('You will be told at the end.')}`)];
  const words = row.right ? `\u2713 ${t('Right')}.` : `\u2717 ${t('Not quite.')} ${you} ${right}`;
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
  const input = element('input', {type: 'text', inputmode: 'decimal', autocomplete: 'off', size: 7, 'aria-label': question.ask + (question.unit ? `, ${t('in {unit}', {unit: question.unit})}` : ''), value: row ? plainNumber(row.raw) : '', disabled: answered});
  const wrong = element('p', {class: 'quiet', role: 'alert'});
  const send = event => {
    event.preventDefault();
    const text = input.value.trim().replace(',', '.').replace('\u2212', '-'), value = Number(text);
    if (!/^[-+]?(\d+\.?\d*|\.\d+)$/.test(text) || !Number.isFinite(value)) {
      wrong.textContent = t('Write a number.');
      input.focus();
      return;
    }
    lesson.answer(value);
  };
  return element('form', {class: 'row', onsubmit: send}, input, question.unit || null, answered ? null : element('button', {type: 'submit', class: 'main'}, t('Answer')), wrong);
}

function click(viewer, lesson, question, row, answered) {
  if (answered) return null;
  const touch = matchMedia('(pointer: coarse)').matches, missed = element('p', {class: 'quiet', role: 'status'});
  const cross = element('button', {type: 'button', onclick: () => {
    viewer.pointing.showCross();
    if (!viewer.pointing.taken(viewer.pointing.at)) missed.textContent = t('There is nothing under the cross.');
  }}, t('Take what is under the cross'));
  cross.addEventListener('focus', () => viewer.pointing.showCross());
  const how = touch ? t('Tap it in the picture.') : t('Click it in the picture. By keyboard: turn the tooth with the arrow keys, move the cross with Shift and the arrow keys, and press Enter.');
  return element('div', {}, element('p', {class: 'quiet'}, how), touch ? null : cross, missed);
}
