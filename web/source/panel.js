// The controls: what can be seen and changed, beside the picture or, on a phone, under it.
import {views} from './camera.js';
import {depthStep} from './depth.js';
import {choice, element, slider} from './dom.js';
import {sides} from './section.js';
import {greysSection} from './volume_panel.js';

const grouped = count => count.toLocaleString('en-GB');

function certificateSection(viewer) {
  const badge = document.getElementById('badge'), words = element('p', {class: 'quiet'}), verdict = element('p', {class: 'verdict'}), list = element('ul');
  const look = element('ul', {class: 'places', 'aria-label': 'Places to look at'});
  const show = () => {
    const {certificate, triangles, words: about} = viewer.model;
    words.textContent = `${about} ${grouped(triangles)} triangles.`;
    const mark = {wanting: '\u2717', amber: '!'}[certificate.verdict] ?? '\u2713';   // a sign and words, never the colour alone
    verdict.textContent = `${mark} ${certificate.headline}`;
    badge.textContent = `${mark} ${certificate.verdict}`;
    for (const told of [verdict, badge])
      for (const kind of ['wanting', 'amber']) told.classList.toggle(kind, certificate.verdict === kind);
    const places = certificate.findings.filter(f => f.mark === 'look');
    list.replaceChildren(...certificate.findings.filter(f => f.mark !== 'look').map(f => element('li', {class: f.mark}, f.words)));
    look.replaceChildren(...places.map(f => element('li', {class: 'look'}, f.at_mm ? element('button', {type: 'button', class: 'place', onclick: () => viewer.lookAt(f.at_mm)}, f.words) : f.words)));
    places.length > 0 ? look.removeAttribute('hidden') : look.setAttribute('hidden', '');
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {'aria-label': 'Certificate'}, verdict, look, element('details', {}, element('summary', {}, 'Report'), words, list));
}

function methodSection(viewer) {
  if (viewer.models.length < 2) return null;
  const group = choice('Method', viewer.models.map((model, index) => ({value: String(index), words: model.name, title: model.words})), '0', value => viewer.show(Number(value)));
  const about = element('p', {class: 'quiet', role: 'status'});
  const show = () => { group.show(String(viewer.chosen)); about.textContent = viewer.model.words; };
  show();
  viewer.addEventListener('change', show);
  return element('section', {}, element('h2', {}, 'Method'), group, about);
}

function structuresSection(viewer) {
  const rows = [...viewer.looks.entries()].filter(([key]) => viewer.models.some(model => model.parts.some(part => part.key === key))).map(([key, look]) => {
    const swatch = element('span', {class: 'swatch'});
    swatch.style.background = look.colour;
    const shown = element('input', {type: 'checkbox', checked: look.visible, onchange: e => viewer.setLook(key, {visible: e.target.checked})});
    const output = element('output', {});
    const opacity = slider(`Opacity of ${key}`, {low: 0, high: 100, step: 1, value: Math.round(100 * look.opacity)}, value => viewer.setLook(key, {opacity: value / 100}));
    const show = () => {
      shown.checked = look.visible;
      opacity.value = Math.round(100 * look.opacity);
      output.textContent = `${Math.round(100 * look.opacity)} %`;
    };
    show();
    viewer.addEventListener('change', show);
    return element('div', {class: 'look'}, element('label', {}, shown, swatch, key), element('span'), output, opacity);
  });
  return element('section', {}, element('h2', {}, 'Structures'), ...rows);
}

function facesSection(viewer) {
  const told = {
    cull: 'Faces seen from behind are left out, as games and web pages do: a wrongly turned triangle is a hole.',
    show: 'Faces are drawn from both sides, which hides wrongly turned triangles.',
    tint: 'Faces seen from behind are magenta.',
  };
  const group = choice('Faces', [{value: 'cull', words: 'Cull'}, {value: 'show', words: 'Two-sided'}, {value: 'tint', words: 'Tint'}], viewer.faces, value => viewer.setFaces(value));
  const about = element('p', {class: 'quiet', role: 'status'});
  const show = () => { group.show(viewer.faces); about.textContent = told[viewer.faces]; };
  show();
  viewer.addEventListener('change', show);
  return element('section', {}, element('h2', {}, 'Faces'), group, about);
}

function cutSection(viewer) {
  const on = element('input', {type: 'checkbox', id: 'cut', onchange: e => viewer.cut({on: e.target.checked})});
  const side = choice('Cut from', sides.map(s => ({value: s.name, words: s.words})), viewer.section.side.name, value => viewer.cut({side: value}));
  const at = slider('Position of the cut, mm', {low: 0, high: 1, step: 'any', value: 0}, value => viewer.cut({at: value}));
  const output = element('output', {class: 'quiet'});
  const other = element('button', {type: 'button', onclick: () => viewer.cut({reversed: !viewer.section.reversed})}, 'Cut away the other side');
  const body = element('div', {}, side, element('div', {class: 'row'}, element('span', {class: 'grow'}, 'Position'), output), at, other);
  const show = () => {
    const {low, high} = viewer.section.range();
    on.checked = viewer.section.on;
    body.hidden = !viewer.section.on;
    Object.assign(at, {min: low, max: high, value: viewer.section.at});
    output.textContent = `${viewer.section.at >= 0 ? '+' : '\u2212'}${Math.abs(viewer.section.at).toFixed(2)} mm`;
    at.setAttribute('aria-valuetext', output.textContent);
    side.show(viewer.section.side.name);
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {}, element('h2', {}, 'Section'), element('label', {class: 'switch'}, on, 'Cut the model open'), body);
}

function insideSection(viewer) {
  const tours = viewer.tours.map((tour, index) =>
    element('button', {type: 'button', onclick: () => viewer.startTour(index)}, `\u25b6 ${tour.name}${tour.canalLength > 0 ? `   ${tour.canalLength.toFixed(1)} mm` : ''}`));
  const fly = element('button', {type: 'button', onclick: () => viewer.startFlight()}, viewer.hasInside ? 'Fly inside' : 'Fly');
  const depth = element('input', {type: 'checkbox', checked: viewer.wallDepth, onchange: e => viewer.setWallDepth(e.target.checked)});
  const step = depthStep(viewer.description.tours);
  const told = element('p', {class: 'quiet'}, `Below the orifice: a ring every ${step} mm, a bold one every ${5 * step}. Amber near the crown, teal and blue towards the tip.`);
  const cues = viewer.description.tours.some(tour => tour.orifice_mm !== null) ? [element('label', {class: 'switch'}, depth, 'Depth on the walls of canals'), told] : [];
  if (viewer.tours.length > 0) {
    const marks = element('input', {type: 'checkbox', checked: viewer.cues.on, onchange: e => { viewer.cues.on = e.target.checked; viewer.touch(); }});
    cues.push(element('label', {class: 'switch'}, marks, 'Numbers, names and the way ahead'));
  }
  return element('section', {'aria-label': 'Inside'}, element('h2', {}, 'Inside'),
    tours.length > 0 ? element('p', {class: 'quiet'}, 'Tours through the canals, from the chamber to the tip:') : null,
    element('div', {class: 'row'}, ...tours, fly), ...cues);
}

/// A quiz made from the model, offered where the page can ask enough.
function learnSection(learn) {
  const about = element('p', {class: 'quiet'}, learn.lesson ? `“${learn.lesson}”` : 'Questions made from this model: name it, click it, count, measure by eye.');
  const open = learn.lesson ? element('button', {type: 'button', class: 'main', onclick: learn.open}, 'Open the lesson') : null;
  return element('section', {id: 'learn', 'aria-label': 'Learn'}, element('h2', {}, 'Learn'), about, element('div', {class: 'row'}, open, element('button', {type: 'button', onclick: learn.quiz}, 'Quiz on this model')));
}

function viewSection(viewer, help) {
  const labels = element('input', {type: 'checkbox', checked: true, onchange: e => { viewer.labels.on = e.target.checked; viewer.touch(); }});
  const shade = element('input', {type: 'checkbox', onchange: e => viewer.setShade(e.target.checked)}), about = element('p', {class: 'quiet', role: 'status'});
  const show = () => {
    shade.checked = viewer.shade;
    about.textContent = viewer.quality.reduced && viewer.picture.layers ? 'Drawing takes long here: while the picture moves it is simpler.' : '';
  };
  show();
  viewer.addEventListener('change', show);
  const buttons = views.map(view => element('button', {type: 'button', title: `Key ${view.key}`, onclick: () => viewer.look(view.name)}, view.words));
  return element('section', {}, element('h2', {}, 'View'), element('div', {class: 'row'}, ...buttons), element('label', {class: 'switch'}, labels, 'Labels'),
    element('label', {class: 'switch'}, shade, 'Shade in hollows'), about,
    element('button', {type: 'button', onclick: help}, 'Keys and gestures'));
}

/// `learn`: {lesson: its title or null, open, quiz}.
export function makePanel(viewer, {help, extra, learn}) {
  document.getElementById('title').textContent = viewer.description.title;
  const alone = viewer.volume?.told.alone ?? false;   // nothing but grey values: there is no surface to speak of
  const about = alone ? [certificateSection(viewer), extra, greysSection(viewer), cutSection(viewer)]
    : [certificateSection(viewer), extra, methodSection(viewer), greysSection(viewer), insideSection(viewer), learnSection(learn), structuresSection(viewer), cutSection(viewer), facesSection(viewer)];
  document.getElementById('controls').append(...[...about, viewSection(viewer, help)].filter(Boolean));
  const panel = document.getElementById('panel'), fold = document.getElementById('fold');
  const folded = on => {
    panel.classList.toggle('folded', on);
    fold.setAttribute('aria-expanded', String(!on));
  };
  const phone = matchMedia('(max-width: 44rem)');
  viewer.addEventListener('enter', () => { if (phone.matches) folded(true); });   // the drawer would cover the tour
  fold.addEventListener('click', () => folded(!panel.classList.contains('folded')));
  folded(learn.lesson !== null || phone.matches);
}
