// The keyboard, as on the desktop where the same can be done there.
import {views} from './camera.js';
import {element} from './dom.js';
import {t} from './language.js';

const turnStep = 0.12, nearStep = 0.88;

const told = [
  [t('drag, one finger'), t('turn')],
  [t('right drag, two fingers'), t('move')],
  [t('wheel, pinch'), t('nearer, farther')],
  [t('arrow keys'), t('turn')],
  ['+  \u2212', t('nearer, farther')],
  [t('1 to 6, 0'), t('from buccal, lingual, mesial, distal, occlusal, apical, three quarters')],
  ['F', t('fit all into the picture')],
  ['S', t('cut the model open or close it')],
  ['R', t('cut away the other side')],
  ['[  ]', t('move the cut')],
  ['B', t('faces from behind: cull, two-sided, tint')],
  ['X', t('DT or DB, where the page has both')],
  ['L', t('labels')],
  ['C', t('fly inside, and back out')],
  ['W A S D, E Q', t('fly: ahead, left, back, right, up, down; or I J K L, O U')],
  [t('T, 1 to 9'), t('tour through the next canal; inside: through that one')],
  [t('space'), t('tour: play or pause')],
  [',  .', t('tour: back, on')],
  ['Esc', t('leave tour or flight')],
  ['N, P', t('lesson, quiz: on, back')],
  ['?', t('this list')],
];

export function makeHelp() {
  const dialog = document.getElementById('help');
  const rows = told.map(([keys, words]) => element('tr', {}, element('td', {}, element('kbd', {}, keys)), element('td', {}, words)));
  const close = element('form', {method: 'dialog'}, element('button', {class: 'main'}, t('Close')));
  dialog.append(element('div', {class: 'row'}, element('h2', {id: 'help-title', class: 'grow'}, t('Keys and gestures')), close), element('table', {}, element('tbody', {}, ...rows)),
    element('p', {class: 'quiet'}, t('In flight, drag to look round; the ring at the left is for the thumb. Walls cannot be flown through. With a headset: grab the tooth with the trigger, with both hands make it larger or smaller; the sticks fly.')));
  return () => dialog.showModal();
}

const flying = {w: ['forward', 1], s: ['forward', -1], a: ['side', -1], d: ['side', 1], e: ['rise', 1], q: ['rise', -1],
  i: ['forward', 1], k: ['forward', -1], j: ['side', -1], l: ['side', 1], o: ['rise', 1], u: ['rise', -1],
  arrowleft: ['turn', -1], arrowright: ['turn', 1], arrowup: ['tilt', 1], arrowdown: ['tilt', -1]};

function outside(viewer, key) {
  switch (key) {
    case 'arrowleft': return viewer.orbit.nudge({turn: -turnStep});
    case 'arrowright': return viewer.orbit.nudge({turn: turnStep});
    case 'arrowup': return viewer.orbit.nudge({tilt: turnStep});
    case 'arrowdown': return viewer.orbit.nudge({tilt: -turnStep});
    case '+': case '=': return viewer.orbit.nudge({nearer: nearStep});
    case '-': return viewer.orbit.nudge({nearer: 1 / nearStep});
    case 's': return viewer.cut({on: !viewer.section.on});
    case 'f': return viewer.orbit.fit();
    default: return false;
  }
}

function always(viewer, key, help) {
  const view = views.find(v => v.key === key), {low, high} = viewer.section.range();
  if (viewer.inside && viewer.tours[Number(key) - 1]) return viewer.startTour(Number(key) - 1);
  if (view) return viewer.look(view.name);
  switch (key) {
    case 'r': return viewer.cut({reversed: !viewer.section.reversed});
    case '[': case ']': return viewer.cut({on: true, at: Math.min(high, Math.max(low, viewer.section.at + (key === ']' ? 0.02 : -0.02) * (high - low)))});
    case 'b': return viewer.nextFaces();
    case 'x': return viewer.show((viewer.chosen + 1) % viewer.models.length);
    case 'l': viewer.labels.on = !viewer.labels.on; return viewer.touch();
    case 't': return viewer.tours.length > 0 ? viewer.startTour((viewer.tours.indexOf(viewer.journey.tour) + 1) % viewer.tours.length) : undefined;
    case 'c': return viewer.inside ? viewer.leave() : viewer.startFlight();
    case 'escape': return viewer.inside ? viewer.leave() : viewer.labels.told ? viewer.labels.tell(null) : undefined;
    case '?': return help();
    default: return false;
  }
}

function onTour(viewer, key) {
  const {journey} = viewer;
  switch (key) {
    case ' ': return viewer.play(!journey.playing);
    case '.': return viewer.seek(journey.mm + journey.lengths.step);
    case ',': return viewer.seek(journey.mm - journey.lengths.step);
    default: return false;
  }
}

/// `teaching`: see teaching.js.
export function listenToKeys(viewer, help, teaching) {
  const held = new Set();
  const steer = () => {
    for (const axis of Object.keys(viewer.journey.speed)) viewer.journey.speed[axis] = 0;
    for (const key of held) if (flying[key]) viewer.journey.speed[flying[key][0]] += flying[key][1];
  };
  addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || document.getElementById('help').open || teaching.handout.isOpen) return;
    const key = event.key.toLowerCase(), at = event.target;
    if (at instanceof HTMLInputElement && at.type === 'text') return;   // what is written is no command
    // A slider, a button or a box keeps the keys that work it.
    if (at instanceof HTMLInputElement && (key.startsWith('arrow') || key === ' ' || key === 'home' || key === 'end')) return;
    if ((at instanceof HTMLButtonElement || at.tagName === 'SUMMARY') && (key === ' ' || key === 'enter')) return;
    if (teaching.key(event)) return event.preventDefault();
    const mode = viewer.journey.mode;
    let done;
    if (mode === 'fly' && flying[key]) {
      held.add(key);
      steer();
    } else {
      done = mode === 'tour' ? onTour(viewer, key) : mode === null ? outside(viewer, key) : false;
      if (done === false) done = always(viewer, key, help);
    }
    if (done !== false) event.preventDefault();
  });
  const release = event => {
    if (event.key) held.delete(event.key.toLowerCase());
    else held.clear();
    steer();
  };
  addEventListener('keyup', release);
  addEventListener('blur', release);
}
