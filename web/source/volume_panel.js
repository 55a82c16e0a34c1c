// The controls of grey values and of X-ray films.
import {choice, element, slider} from './dom.js';
import {capital, plainNumber, said, t} from './language.js';
import {transferred, understood} from './transfer.js';

const fullExtinction = 4;   // 1/mm that fills a bar of the histogram, as in the viewer
const three = value => plainNumber(Number(value.toPrecision(3)));

/// A row of words, what it is set to, and a slider below.
function told(words, range, changed, format = three) {
  const output = element('output', {class: 'quiet'}), input = slider(words, range, value => changed(value));
  const row = element('div', {}, element('div', {class: 'row'}, element('span', {class: 'grow'}, words), output), input);
  row.show = value => {
    input.value = value;
    output.textContent = format(value);
    input.setAttribute('aria-valuetext', output.textContent);
  };
  return row;
}

function tubeControl(viewer) {
  const tube = told(t('Tube swung by'), {low: -40, high: 40, step: 1, value: 0}, degrees => { tube.show(degrees); viewer.swingTube(degrees); }, degrees => `${degrees}\u00b0`);
  tube.show(0);
  const rule = t('Same lingual, opposite buccal: of two canals that lie one behind the other, the one that moves with the tube lies lingually.');
  return element('div', {}, tube, element('p', {class: 'quiet'}, rule));
}

/// How often values occur, in the colours that they are shown in; lines at the values of the surfaces.
class Histogram {
  constructor(volume) {
    this.volume = volume;
    this.canvas = element('canvas', {width: 520, height: 140, class: 'histogram', role: 'img', 'aria-label': t('How often grey values occur, and the colours that they are shown in')});
  }

  draw() {
    const {volume: {told: {bars, low, high, isos}, look}, canvas} = this, {width, height} = canvas, context = canvas.getContext('2d'), points = understood(look.transfer);
    const style = getComputedStyle(document.documentElement), byte = light => Math.round(255 * Math.min(Math.max(light, 0), 1) ** (1 / 2.2));
    context.clearRect(0, 0, width, height);
    bars.forEach((bar, index) => {
      const left = index * width / bars.length, [r, g, b, extinction] = transferred(points, low + (high - low) * (index + 0.5) / bars.length);
      context.fillStyle = style.getPropertyValue('--quiet').trim() || '#888';
      context.fillRect(left, height * (1 - 0.94 * bar), width / bars.length - 1, height);
      if (look.cast !== 'shaded') return;
      context.fillStyle = `rgb(${byte(r)} ${byte(g)} ${byte(b)} / 0.7)`;
      context.fillRect(left, height * (1 - Math.min(extinction / fullExtinction, 1)), width / bars.length, height);
    });
    context.fillStyle = style.getPropertyValue('--accent').trim() || '#2ab';
    for (const iso of isos) context.fillRect(width * (iso - low) / (high - low) - 1.5, 0, 3, height);
  }
}

/// The controls of one way to cast; `show()` follows the look.
function castControls(viewer) {
  const {volume} = viewer, {told: {transfers, low, high, air, dentine, dentine_attenuation: swallowed, isos}} = volume, range = {low, high, step: (high - low) / 255, value: low};
  let ready = Object.keys(transfers).find(name => JSON.stringify(transfers[name]) === JSON.stringify(volume.look.transfer)) ?? '', density = 1;
  const lay = () => viewer.setVolume({transfer: transfers[ready || 'tooth'].map(point => ({...point, extinction: density * point.extinction}))});
  const kinds = choice(t('Shows'), Object.keys(transfers).map(name => ({value: name, words: capital(said(name))})), ready, name => { ready = name; lay(); });
  const dense = told(t('Density'), {low: 5, high: 400, step: 5, value: 100}, percent => { density = percent / 100; lay(); }, percent => `${Math.round(percent)} %`);
  const black = told(t('Black'), range, value => viewer.setVolume({window: [Math.min(value, volume.look.window[1] - range.step), volume.look.window[1]]}));
  const white = told(t('White'), range, value => viewer.setVolume({window: [volume.look.window[0], Math.max(value, volume.look.window[0] + range.step)]}));
  const latitude = told(t('White at attenuation'), {low: 0.5, high: 10, step: 0.1, value: 4}, value => viewer.setVolume({latitude: value}));
  const iso = told(t('Value'), range, value => viewer.setVolume({iso: value})), tube = tubeControl(viewer);
  const of = {shaded: [kinds, dense], maximum: [black, white], average: [black, white], radiograph: [latitude, tube], surface: [iso]}, all = [kinds, dense, black, white, latitude, tube, iso];
  const begin = cast => ({
    cast, ...(['maximum', 'average', 'radiograph'].includes(cast) ? {shows: 'volume'} : {}), ...(cast === 'surface' ? {iso: isos[0] ?? 0.5 * (air + dentine)} : {}),
    ...(cast === 'radiograph' ? {window: [air, dentine], attenuation: swallowed} : ['maximum', 'average'].includes(cast) ? {window: [air, high]} : {}),
  });
  const ways = [['shaded', t('Shaded')], ['maximum', t('Maximum')], ['average', t('Average')], ['radiograph', t('X-ray')], ['surface', t('One value')]];
  const cast = choice(t('Rays'), ways.map(([value, words]) => ({value, words})), volume.look.cast, value => viewer.setVolume(begin(value)));
  const body = element('div', {}, cast, ...all);
  body.show = () => {
    const {look} = volume;
    cast.show(look.cast);
    for (const row of all) row.hidden = !of[look.cast].includes(row);
    kinds.show(ready);
    dense.show(100 * density);
    black.show(look.window[0]);
    white.show(look.window[1]);
    latitude.show(look.latitude);
    iso.show(look.iso);
  };
  return body;
}

function volumeSection(viewer) {
  const {volume} = viewer, histogram = new Histogram(volume), controls = castControls(viewer);
  const about = element('p', {class: 'quiet'}, t('The CT itself: {size} values.', {size: volume.told.size.join(' \u00d7 ')}) + (volume.told.isos.length > 0 ? ` ${t('The line over the histogram is where the surface was taken.')}` : ''));
  const shows = volume.told.alone ? null : choice(t('What is shown'), [['surfaces', t('Surfaces')], ['volume', t('Volume')], ['both', t('Both')]].map(([value, words]) => ({value, words})), volume.look.shows,
    value => viewer.setVolume({shows: value, ...(value === 'both' && volume.projects ? {cast: 'shaded'} : {})}));
  const body = element('div', {}, histogram.canvas, controls);
  const show = () => {
    shows?.show(volume.look.shows);
    body.hidden = !volume.showsVolume;
    controls.show();
    histogram.draw();
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {id: 'volume-controls', 'aria-label': t('Volume')}, element('h2', {}, t('Volume')), about, shows, body);
}

function filmSection(viewer) {
  const {shadow} = viewer, on = element('input', {type: 'checkbox', id: 'film', onchange: e => viewer.setFilm(e.target.checked)});
  const latitude = told(t('White at attenuation'), {low: 0.5, high: 10, step: 0.1, value: 4}, value => { shadow.latitude = value; viewer.dress(); });
  const body = element('div', {}, latitude, tubeControl(viewer));
  const show = () => {
    on.checked = shadow.on;
    body.hidden = !shadow.on;
    latitude.show(shadow.latitude);
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {id: 'film-controls', 'aria-label': t('X-ray')}, element('h2', {}, t('X-ray')), element('label', {class: 'switch'}, on, t('As an X-ray film shows it')), body);
}

/// Of the page's volume, or where it has none of its model's film; null: of neither.
export function greysSection(viewer) { return viewer.volume ? volumeSection(viewer) : viewer.shadow ? filmSection(viewer) : null; }
