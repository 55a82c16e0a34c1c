// Answers and what they are worth, as the desktop writes them too: CSV and JSON.

import {named, plainNumber} from './language.js';

const digits = 1;   // of the seconds

/// `right` of an answer to a question of a lesson; see docs/web.md. `given`: a choice's index, a number, or what was clicked: {structure, part, others}.
export function isRight(question, given) {
  if (question.kind === 'choice') return given === question.answer;
  if (question.kind === 'number') return Math.abs(given - question.answer) <= (question.within ?? 0) + 1e-9 * Math.max(1, Math.abs(given), Math.abs(question.answer));
  const same = (a, b) => plain(a) === plain(b);
  const structure = given.structures.some(name => same(name, question.structure));
  return structure && (!question.part || same(given.part ?? '', question.part));
}

/// "Pulp chamber" and "chamber" are one.
const plain = name => String(name ?? '').trim().toLowerCase().replace(/^pulp chamber$/, 'chamber');

export function inWords(question, given) {
  if (question.kind === 'choice') return question.choices[given] ?? '';
  if (question.kind === 'number') return [String(given), question.unit].filter(Boolean).join(' ');
  return given.part || given.structure;
}

/// The same for whoever reads it, in their language; marks and events have the names that data have.
export function shownAnswer(question, given) {
  if (question.kind === 'choice') return question.choices[given] ?? '';
  if (question.kind === 'number') return [plainNumber(given), question.unit].filter(Boolean).join(' ');
  return named(given.part || given.structure);
}

export function rightAnswer(question) {
  if (question.kind === 'choice') return question.choices[question.answer];
  if (question.kind === 'number') {
    const within = question.within > 0 ? ` (\u00b1 ${plainNumber(question.within)})` : '';
    return `${plainNumber(question.answer)}${question.unit ? ` ${question.unit}` : ''}${within}`;
  }
  return named(question.part || question.structure);
}

export const score = rows => ({right: rows.filter(row => row.right).length, of: rows.length});

/// A field that a spreadsheet takes for text: quoted where it must be, and never a formula.
function field(value) {
  const text = typeof value === 'string' && /^[=+\-@\t\r]/.test(value) && !/^-?\d+(\.\d+)?( [a-z]+)?$/i.test(value) ? `'${value}` : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export function asCsv(rows) {
  const lines = [['number', 'kind', 'question', 'given', 'right', 'seconds'], ...rows.map(r => [r.number, r.kind, r.question, r.given, r.right ? 'yes' : 'no', r.seconds.toFixed(digits)])];
  return lines.map(line => line.map(field).join(',') + '\n').join('');
}

export function asJson(title, rows) {
  const rounded = rows.map(({number, kind, question, given, right, seconds}) => ({number, kind, question, given, right, seconds: Number(seconds.toFixed(digits))}));
  return JSON.stringify({format: 'odontoscope.marks', version: 1, title, score: score(rows).right, of: rows.length, rows: rounded}, null, 2) + '\n';
}
