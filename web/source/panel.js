// The controls: what can be seen and changed, beside the picture or, on a phone, under it.
import {views} from './camera.js';
import {depthStep} from './depth.js';
import {choice, element, slider} from './dom.js';
import {capital, language, languages, named, number, plainNumber, said, speak, t} from './language.js';
import {sides} from './section.js';
import {thicknessStep} from './thickness.js';
import {toldOf} from './told.js';
import {greysSection} from './volume_panel.js';

function certificateSection(viewer) {
  const badge = document.getElementById('badge'), words = element('p', {class: 'quiet'}), verdict = element('p', {class: 'verdict'}), list = element('ul');
  const look = element('ul', {class: 'places', 'aria-label': t('Places to look at')});
  const show = () => {
    const {certificate, triangles, words: about} = viewer.model;
    words.textContent = `${said(about)} ${t('{count} triangles.', {count: number(triangles)})}`;
    const mark = {wanting: '\u2717', amber: '!'}[certificate.verdict] ?? '\u2713';   // a sign and words, never the colour alone
    verdict.textContent = `${mark} ${said(certificate.headline)}`;
    badge.textContent = `${mark} ${t(certificate.verdict)}`;
    for (const told of [verdict, badge])
      for (const kind of ['wanting', 'amber']) told.classList.toggle(kind, certificate.verdict === kind);
    const places = certificate.findings.filter(f => f.mark === 'look');
    list.replaceChildren(...certificate.findings.filter(f => f.mark !== 'look').map(f => element('li', {class: f.mark}, said(f.words))));
    look.replaceChildren(...places.map(f => element('li', {class: 'look'}, f.at_mm ? element('button', {type: 'button', class: 'place', onclick: () => viewer.lookAt(f.at_mm)}, said(f.words)) : said(f.words))));
    places.length > 0 ? look.removeAttribute('hidden') : look.setAttribute('hidden', '');
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {'aria-label': t('Certificate')}, verdict, look, element('details', {}, element('summary', {}, t('Report')), words, list));
}

function methodSection(viewer) {
  if (viewer.models.length < 2) return null;
  const group = choice(t('Method'), viewer.models.map((model, index) => ({value: String(index), words: model.name, title: said(model.words)})), '0', value => viewer.show(Number(value)));
  const about = element('p', {class: 'quiet', role: 'status'});
  const show = () => { group.show(String(viewer.chosen)); about.textContent = said(viewer.model.words); };
  show();
  viewer.addEventListener('change', show);
  return element('section', {}, element('h2', {}, t('Method')), group, about);
}

function structuresSection(viewer) {
  const rows = [...viewer.looks.entries()].filter(([key]) => viewer.models.some(model => model.parts.some(part => part.key === key))).map(([key, look]) => {
    const swatch = element('span', {class: 'swatch'});
    swatch.style.background = look.colour;
    const shown = element('input', {type: 'checkbox', checked: look.visible, onchange: e => viewer.setLook(key, {visible: e.target.checked})});
    const output = element('output', {});
    const opacity = slider(t('Opacity of {structure}', {structure: named(key)}), {low: 0, high: 100, step: 1, value: Math.round(100 * look.opacity)}, value => viewer.setLook(key, {opacity: value / 100}));
    const show = () => {
      shown.checked = look.visible;
      opacity.value = Math.round(100 * look.opacity);
      output.textContent = `${Math.round(100 * look.opacity)} %`;
    };
    show();
    viewer.addEventListener('change', show);
    const told = toldOf(key), what = told ? element('details', {class: 'what'}, element('summary', {'aria-label': t('What is it? {structure}', {structure: named(key)})}, t('What is it?')), element('p', {class: 'quiet'}, told)) : null;
    return element('div', {class: 'look'}, element('label', {}, shown, swatch, named(key)), element('span'), output, opacity, what);
  });
  return element('section', {}, element('h2', {}, t('Structures')), ...rows);
}

function facesSection(viewer) {
  const told = {
    cull: t('Faces seen from behind are left out, as games and web pages do: a wrongly turned triangle is a hole.'),
    show: t('Faces are drawn from both sides, which hides wrongly turned triangles.'),
    tint: t('Faces seen from behind are magenta.'),
  };
  const group = choice(t('Faces'), [{value: 'cull', words: t('Cull')}, {value: 'show', words: t('Two-sided')}, {value: 'tint', words: t('Tint')}], viewer.faces, value => viewer.setFaces(value));
  const about = element('p', {class: 'quiet', role: 'status'});
  const show = () => { group.show(viewer.faces); about.textContent = told[viewer.faces]; };
  show();
  viewer.addEventListener('change', show);
  return element('section', {}, element('h2', {}, t('Faces')), group, about);
}

function cutSection(viewer) {
  const on = element('input', {type: 'checkbox', id: 'cut', onchange: e => viewer.cut({on: e.target.checked})});
  const side = choice(t('Cut from'), sides.map(s => ({value: s.name, words: s.words})), viewer.section.side.name, value => viewer.cut({side: value}));
  const at = slider(t('Position of the cut, mm'), {low: 0, high: 1, step: 'any', value: 0}, value => viewer.cut({at: value}));
  const output = element('output', {class: 'quiet'});
  const other = element('button', {type: 'button', onclick: () => viewer.cut({reversed: !viewer.section.reversed})}, t('Cut away the other side'));
  const body = element('div', {}, side, element('div', {class: 'row'}, element('span', {class: 'grow'}, t('Position')), output), at, other);
  const show = () => {
    const {low, high} = viewer.section.range();
    on.checked = viewer.section.on;
    body.hidden = !viewer.section.on;
    Object.assign(at, {min: low, max: high, value: viewer.section.at});
    output.textContent = `${viewer.section.at >= 0 ? '+' : '\u2212'}${number(Math.abs(viewer.section.at), 2)} mm`;
    at.setAttribute('aria-valuetext', output.textContent);
    side.show(viewer.section.side.name);
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {}, element('h2', {}, t('Section')), element('label', {class: 'switch'}, on, t('Cut the model open')), body);
}

function insideSection(viewer) {
  const tours = viewer.tours.map((tour, index) =>
    element('button', {type: 'button', onclick: () => viewer.startTour(index)}, `\u25b6 ${named(tour.name)}${tour.canalLength > 0 ? `   ${number(tour.canalLength, 1)} mm` : ''}`));
  const fly = element('button', {type: 'button', onclick: () => viewer.startFlight()}, viewer.hasInside ? t('Fly inside') : t('Fly'));
  const depth = element('input', {type: 'checkbox', checked: viewer.wallDepth, onchange: e => viewer.setWallDepth(e.target.checked)});
  const step = depthStep(viewer.description.tours);
  const told = element('p', {class: 'quiet'}, t('Below the orifice: a ring every {step} mm, a bold one every {bold}. Amber near the crown, teal and blue towards the tip.', {step, bold: 5 * step}));
  const cues = viewer.description.tours.some(tour => tour.orifice_mm !== null) ? [element('label', {class: 'switch'}, depth, t('Depth on the walls of canals')), told] : [];
  const thickness = element('input', {type: 'checkbox', checked: viewer.wallThickness, onchange: e => viewer.setWallThickness(e.target.checked)});
  if (viewer.hasThickness) cues.push(element('label', {class: 'switch'}, thickness, t('Thickness of the wall')),
    element('p', {class: 'quiet'}, t('To the outside: a line every {line} mm, a bold one at {one} and {two} mm. Blue where it is thin, its own colour from {thick} mm on.', {line: plainNumber(Number((thicknessStep * step).toPrecision(3))), one: step, two: 2 * step, thick: 3 * step})));
  viewer.addEventListener('change', () => Object.assign(depth, {checked: viewer.wallDepth}) && Object.assign(thickness, {checked: viewer.wallThickness}));
  if (viewer.tours.length > 0) {
    const marks = element('input', {type: 'checkbox', checked: viewer.cues.on, onchange: e => { viewer.cues.on = e.target.checked; viewer.touch(); }});
    cues.push(element('label', {class: 'switch'}, marks, t('Numbers, names and the way ahead')));
  }
  return element('section', {'aria-label': t('Inside')}, element('h2', {}, t('Inside')),
    tours.length > 0 ? element('p', {class: 'quiet'}, t('Tours through the canals, from the chamber to the tip:')) : null,
    element('div', {class: 'row'}, ...tours, fly), ...cues);
}

/// A quiz made from the model, offered where the page can ask enough.
function learnSection(learn) {
  const about = element('p', {class: 'quiet'}, learn.lesson ? `“${learn.lesson}”` : t('Questions made from this model: name it, click it, count, measure by eye.'));
  const open = learn.lesson ? element('button', {type: 'button', class: 'main', onclick: learn.open}, t('Open the lesson')) : null;
  return element('section', {id: 'learn', 'aria-label': t('Learn')}, element('h2', {}, t('Learn')), about, element('div', {class: 'row'}, open, element('button', {type: 'button', onclick: learn.quiz}, t('Quiz on this model'))));
}

/// Each language by its own name, which whoever looks for it can read.
function languageChoice() {
  if (languages.length < 2) return null;
  const options = languages.map(({language: tag, name}) => element('option', {value: tag, lang: tag, selected: tag === language.language ? '' : null}, name));
  const id = 'choose-language', select = element('select', {id, onchange: event => speak(event.target.value)}, ...options);
  return element('div', {class: 'row'}, element('label', {for: id}, t('Language')), select);
}

function viewSection(viewer, help) {
  const labels = element('input', {type: 'checkbox', checked: true, onchange: e => { viewer.labels.on = e.target.checked; viewer.touch(); }});
  const shade = element('input', {type: 'checkbox', onchange: e => viewer.setShade(e.target.checked)}), about = element('p', {class: 'quiet', role: 'status'});
  const show = () => {
    shade.checked = viewer.shade;
    about.textContent = viewer.quality.reduced && viewer.picture.layers ? t('Drawing takes long here: while the picture moves it is simpler.') : '';
  };
  show();
  viewer.addEventListener('change', show);
  const buttons = views.map(view => element('button', {type: 'button', title: t('Key {key}', {key: view.key}), onclick: () => viewer.look(view.name)}, view.words));
  return element('section', {}, element('h2', {}, t('View')), element('div', {class: 'row'}, ...buttons), element('label', {class: 'switch'}, labels, t('Labels')),
    element('label', {class: 'switch'}, shade, t('Shade in hollows')), about,
    element('div', {class: 'row tall'}, element('button', {type: 'button', onclick: help}, t('Keys and gestures'))), languageChoice());
}

/// `learn`: {lesson: its title or null, open, quiz}.
export function makePanel(viewer, {help, extra, learn}) {
  document.getElementById('title').textContent = document.title = t(viewer.description.title);
  const {tooth} = viewer.description, line = document.getElementById('tooth');
  line.textContent = tooth ? capital(said(tooth)) : '';
  line.hidden = !tooth;
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
