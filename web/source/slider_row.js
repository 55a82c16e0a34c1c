import {element, slider} from './dom.js';
import {plainNumber} from './language.js';

const three = value => plainNumber(Number(value.toPrecision(3)));

/// A row of words, what it is set to, and a slider below.
export function told(words, range, changed, format = three) {
  const output = element('output', {class: 'quiet'}), input = slider(words, range, value => changed(value));
  const row = element('div', {}, element('div', {class: 'row'}, element('span', {class: 'grow'}, words), output), input);
  row.show = value => {
    input.value = value;
    output.textContent = format(value);
    input.setAttribute('aria-valuetext', output.textContent);
  };
  return row;
}
