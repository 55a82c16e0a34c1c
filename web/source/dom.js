// Elements, made from code alone: text stays text.

/// element('button', {class: 'main', onclick: f, 'aria-label': 'x'}, 'words', child)
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (key === 'value' || key === 'checked' || key === 'disabled' || key === 'hidden' || key === 'open') made[key] = value;
    else if (value !== null && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children.filter(child => child !== null && child !== undefined));
  return made;
}

/// Buttons of which one is pressed. `choices`: {value, words, title}. Its `show(value)` presses one without telling.
export function choice(label, choices, chosen, choose) {
  const group = element('div', {class: 'choices', role: 'group', 'aria-label': label});
  group.show = value => {
    for (const button of group.children) button.setAttribute('aria-pressed', String(button.value === value));
  };
  for (const {value, words, title} of choices) {
    const button = element('button', {type: 'button', title, onclick: () => { group.show(value); choose(value); }}, words);
    button.value = value;
    group.append(button);
  }
  group.show(chosen);
  return group;
}

export function slider(label, {low, high, step, value}, changed) {
  return element('input', {type: 'range', min: low, max: high, step, value, 'aria-label': label, oninput: event => changed(Number(event.target.value))});
}
