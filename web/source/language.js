// The page's words in the reader's language. In the code they stand in English; a file of assets/languages holds another language's words for each of
// them, and how it writes numbers. docs/languages.md tells of the files; engine/language reads the same ones for the desktop.
//
// The address chooses (#language=de), then what was chosen here before, then who made the page, then the browser.

const english = {language: 'en', name: 'English', decimal: '.', group: ',', texts: {}};
const place = /\{(\w+)\}/g;
const kept = 'odontoscope.language';

const held = id => {
  const element = globalThis.document?.getElementById(id);
  return element ? JSON.parse(element.textContent) : null;
};

/// The program has checked the file.
const ready = file => ({...file, texts: Object.fromEntries(file.texts)});

const own = held('language');   // of the page: {language}, or a whole file that came with it
export const languages = [english, ...[...(held('languages') ?? []), ...(own?.texts ? [own] : [])].map(ready)];

function remembered() {
  try {
    return localStorage.getItem(kept);
  } catch {
    return null;   // a page from disk, or in a frame, may not
  }
}

function chosen() {
  const {location, navigator} = globalThis, wishes = [
    new URLSearchParams(location?.hash?.replace(/^#/, '')).get('language'), location ? remembered() : null, own?.language, ...(location ? navigator?.languages ?? [] : []),
  ];
  for (const wish of wishes.filter(Boolean)) {
    const found = languages.findLast(({language}) => language.toLowerCase() === wish.toLowerCase()) ?? languages.findLast(({language}) => language === wish.toLowerCase().split('-')[0]);
    if (found) return found;
  }
  return english;
}

export const language = chosen();

/// For the next time, and in the address, which goes with a link; the page is then made anew in it.
export function speak(tag) {
  try {
    localStorage.setItem(kept, tag);
  } catch {
    // then the address alone remembers
  }
  const params = new URLSearchParams(location.hash.replace(/^#/, ''));
  params.set('language', tag);
  history.replaceState(null, '', `#${params}`);
  location.reload();
}

const filled = (text, values) => text.replace(place, (all, name) => values[name] ?? all);

/// t('Step {step} of {steps}', {step: 1, steps: 8})
export const t = (text, values = {}) => filled(language.texts[text] ?? text, values);

/// A number as one writes it here, with so many digits behind the point.
export function number(value, digits = 0) {
  const [before, behind] = Math.abs(value).toFixed(digits).split('.');
  return `${value < 0 ? '\u2212' : ''}${before.replace(/\B(?=(\d{3})+$)/g, language.group)}${behind ? language.decimal + behind : ''}`;
}
/// Without zeros at its end.
export const plainNumber = value => String(value).replace('.', language.decimal);

/// What data call a thing: a structure, a canal. Names that nobody knows stay; of "canal 2" the word is known, of "pulp cavity" both.
export function named(name) {
  const known = language.texts[name];
  if (known) return known;
  const [, word, count] = /^(.+) (\d+)$/.exec(name) ?? [];
  if (count && language.texts[word]) return `${language.texts[word]} ${count}`;
  return name.endsWith(' cavity') ? `${named(name.slice(0, -7))}: ${t('cavity')}` : name;
}

/// Each place takes as little as can be; a {count} is a number.
const formOf = known => new RegExp(`^${known.split(/(\{\w+\})/).map((piece, i) => i % 2 === 0 ? piece.replace(special, '\\$&') : piece === '{count}' ? '(-?[\\d.,]*\\d)' : '(.+?)').join('')}$`);
const special = /[.*+?^${}()|[\]\\]/g;
let patterns = null;

/// Words that the program put together ("{structure}: {what}"): found again among the texts, and what fills their places likewise.
export function said(text) {
  if (language.texts[text]) return language.texts[text];
  if (/^-?[\d,]*\.?\d+$/.test(text)) return text.replace(/[.,]/g, sign => sign === '.' ? language.decimal : language.group);
  patterns ??= Object.keys(language.texts).filter(known => known.search(place) >= 0)
    .map(known => ({known, names: [...known.matchAll(place)].map(([, name]) => name), form: formOf(known)}))
    .filter(({known}) => known.replace(place, '').length > 2).sort((a, b) => b.known.length - a.known.length);
  for (const {known, names, form} of patterns) {
    const match = form.exec(text);
    if (match) return filled(language.texts[known], Object.fromEntries(names.map((name, i) => [name, said(match[i + 1])])));
  }
  const end = /[.]$/.exec(text);   // a sentence of a known clause
  if (end && text.length > 1) {
    const clause = said(text.slice(0, -1));
    if (clause !== text.slice(0, -1)) return `${clause}.`;
  }
  for (const between of ['   ', '  ', ' \u2192 ', '. ', '; ', ', ', ': ']) {
    const parts = text.split(between);
    if (parts.length > 1) return parts.map(said).join(between);
  }
  return named(text);
}

export const capital = words => words.charAt(0).toUpperCase() + words.slice(1);

/// What stands in the page before any script runs.
export function translatePage() {
  document.documentElement.lang = language.language;
  for (const element of document.querySelectorAll('[data-text]')) {
    if (element.hasAttribute('aria-label')) element.setAttribute('aria-label', t(element.getAttribute('aria-label')));
    if (element.childElementCount === 0 && element.textContent.trim()) element.textContent = t(element.textContent);
  }
}
