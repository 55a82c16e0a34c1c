// The page begins here.
import {MathUtils} from 'three';
import {description, lessonOf} from './data.js';
import {element} from './dom.js';
import {watchForHeadset} from './headset.js';
import {InsideBar} from './inside_bar.js';
import {listenToKeys, makeHelp} from './keys.js';
import {plainNumber, t, translatePage} from './language.js';
import {makePanel} from './panel.js';
import {Showing} from './showing.js';
import {Teaching} from './teaching.js';
import {Viewer} from './viewer.js';

const longestStep = 0.1;   // seconds: after a pause the world does not jump

function fail(words) {
  const told = document.createElement('p');
  told.className = 'failure';
  told.setAttribute('role', 'alert');
  told.textContent = words;
  document.body.append(told);
  document.documentElement.dataset.failed = words;
}

/// A bar of a round length in millimetres, where the model is.
/// 1, 2 or 5 times a power of ten: the shortest that is at least `least`.
function roundLength(least) {
  const unit = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5].find(step => step * unit >= least) ?? 10) * unit;
}

/// Below 0.1 mm in µm.
function lengthWords(mm) {
  const rounded = value => Number(value.toPrecision(1));
  return mm < 0.099 ? `${rounded(1000 * mm)} µm` : `${plainNumber(rounded(mm))} mm`;
}

function drawScale(viewer) {
  const {orbit, bounds, canvas} = viewer, distance = orbit.camera.position.distanceTo(bounds.centre);
  const perPixel = 2 * distance * Math.tan(MathUtils.degToRad(orbit.camera.fov) / 2) / canvas.clientHeight;
  const length = roundLength(60 * perPixel);
  document.getElementById('scale-words').textContent = lengthWords(length);
  document.getElementById('scale-line').style.width = `${length / perPixel}px`;
}

function followColours(viewer) {
  const apply = () => {
    const style = getComputedStyle(document.documentElement);
    viewer.picture.setBackground(style.getPropertyValue('--sky-top').trim(), style.getPropertyValue('--sky-bottom').trim());
    viewer.touch();
  };
  apply();
  matchMedia('(prefers-color-scheme: light)').addEventListener('change', apply);
}

/// Only where there is one.
function headsetSection(viewer) {
  const enter = element('button', {type: 'button', class: 'main', onclick: () => viewer.headset.enter().catch(error => {
    document.getElementById('notice').textContent = t('The headset cannot be entered: {why}', {why: error.message});
  })}, t('Enter VR'));
  const section = element('section', {hidden: true, 'aria-label': t('Headset')}, enter);
  watchForHeadset(found => { section.hidden = !found; });
  return section;
}

async function start() {
  translatePage();
  const viewer = await Viewer.of(description(), document.getElementById('canvas'));
  const help = makeHelp(), lesson = lessonOf();
  let teaching = null;
  makePanel(viewer, {help, extra: headsetSection(viewer), learn: {lesson: lesson?.title ?? null, open: () => teaching.openLesson(), quiz: () => teaching.openQuiz({source: 'model'})}});
  new InsideBar(viewer);
  followColours(viewer);
  teaching = new Teaching(viewer, lesson);
  viewer.teaching = teaching;
  listenToKeys(viewer, help, teaching);
  viewer.addEventListener('drawn', () => drawScale(viewer));
  let before = performance.now();
  viewer.renderer.setAnimationLoop(now => {
    viewer.frame(Math.min(longestStep, Math.max(0, (now - before) / 1000)));
    before = now;
  });
  new Showing(viewer);
  teaching.begin();
  return viewer;
}

// For scripts and tests: resolves once the model is there.
globalThis.odontoscope = start().catch(error => {
  fail(t('The model cannot be shown: {why}. It needs a browser with WebGL 2.', {why: error.message}));
  throw error;
});
