// The controls of grey values and of X-ray films.
import {choice, element} from './dom.js';
import {FilmRuler} from './film_ruler.js';
import {lengthOnFilm, trueLength} from './film_length.js';
import {capital, named, number, said, t} from './language.js';
import {told} from './slider_row.js';
import {TransferEditor} from './transfer_editor.js';

const filmSize = [31, 41];   // mm: intraoral film of size 2, upright

function tubeControl(viewer) {
  const tube = told(t('Tube swung by'), {low: -40, high: 40, step: 1, value: 0}, degrees => { tube.show(degrees); viewer.swingTube(degrees); }, degrees => `${degrees}\u00b0`);
  tube.show(0);
  const rule = t('Same lingual, opposite buccal: of two canals that lie one behind the other, the one that moves with the tube lies lingually.');
  return element('div', {}, tube, element('p', {class: 'quiet'}, rule));
}

/// The controls of one way to cast; `show()` follows the look.
function castControls(viewer) {
  const {volume} = viewer, {told: {transfers, low, high, air, dentine, dentine_attenuation: swallowed, isos}} = volume, range = {low, high, step: (high - low) / 255, value: low};
  let ready = Object.keys(transfers).find(name => JSON.stringify(transfers[name]) === JSON.stringify(volume.look.transfer)) ?? '', density = 1;
  let edited = ready ? null : structuredClone(volume.look.transfer);   // at density 1
  const lay = () => viewer.setVolume({transfer: (edited ?? transfers[ready || 'tooth']).map(point => ({...point, extinction: density * point.extinction}))});
  const kinds = choice(t('Shows'), Object.keys(transfers).map(name => ({value: name, words: capital(said(name))})), ready, name => { ready = name; edited = null; lay(); });
  const dense = told(t('Density'), {low: 5, high: 400, step: 5, value: 100}, percent => { density = percent / 100; lay(); }, percent => `${Math.round(percent)} %`);
  const black = told(t('Black'), range, value => viewer.setVolume({window: [Math.min(value, volume.look.window[1] - range.step), volume.look.window[1]]}));
  const white = told(t('White'), range, value => viewer.setVolume({window: [volume.look.window[0], Math.max(value, volume.look.window[0] + range.step)]}));
  const latitude = told(t('White at attenuation'), {low: 0.5, high: 10, step: 0.1, value: 4}, value => viewer.setVolume({latitude: value}));
  const steepest = (high - low) / Math.min(...volume.told.step_mm), slope = {low: 0, high: steepest, step: steepest / 500, value: 0}, least = slope.step, of_slopes = () => volume.look.slopes;
  const borders = element('input', {type: 'checkbox', id: 'borders', onchange: e => viewer.setVolume({slopes: e.target.checked ? [0.05 * steepest, 0.2 * steepest] : [0, 0]})});
  const flat = told(t('Too flat, values/mm'), slope, value => viewer.setVolume({slopes: [Math.min(value, of_slopes()[1] - least), of_slopes()[1]]}));
  const steep = told(t('Steep enough, values/mm'), slope, value => viewer.setVolume({slopes: [of_slopes()[0], Math.max(value, of_slopes()[0] + least)]}));
  const only = element('label', {class: 'switch'}, borders, t('Borders only'));
  const negative = element('input', {type: 'checkbox', onchange: e => viewer.setVolume({inverted: e.target.checked})}), inverted = element('label', {class: 'switch'}, negative, t('Inverted'));
  const iso = told(t('Value'), range, value => viewer.setVolume({iso: value})), tube = tubeControl(viewer);
  const of = {shaded: [kinds, dense, only, flat, steep], maximum: [black, white], average: [black, white], radiograph: [latitude, inverted, tube], surface: [iso]}, all = [kinds, dense, only, flat, steep, black, white, latitude, inverted, tube, iso];
  const begin = cast => ({
    cast, ...(['maximum', 'average', 'radiograph'].includes(cast) ? {shows: 'volume'} : {}), ...(cast === 'surface' ? {iso: isos[0] ?? 0.5 * (air + dentine)} : {}),
    ...(cast === 'radiograph' ? {window: [air, dentine], attenuation: swallowed} : ['maximum', 'average'].includes(cast) ? {window: [air, high]} : {}),
  });
  const ways = [['shaded', t('Shaded')], ['maximum', t('Maximum')], ['average', t('Average')], ['radiograph', t('X-ray')], ['surface', t('One value')]];
  const cast = choice(t('Rays'), ways.map(([value, words]) => ({value, words})), volume.look.cast, value => viewer.setVolume(begin(value)));
  const editor = new TransferEditor(volume, points => {
    ready = '';
    edited = points.map(point => ({...point, extinction: point.extinction / density}));
    lay();
  });
  const body = element('div', {}, editor.body, cast, ...all);
  body.show = () => {
    const {look} = volume;
    editor.show();
    cast.show(look.cast);
    for (const row of all) row.hidden = !of[look.cast].includes(row);
    borders.checked = of_slopes()[1] > 0;
    flat.hidden = steep.hidden = flat.hidden || !borders.checked;
    flat.show(of_slopes()[0]);
    steep.show(of_slopes()[1]);
    kinds.show(ready);
    dense.show(100 * density);
    black.show(look.window[0]);
    white.show(look.window[1]);
    latitude.show(look.latitude);
    negative.checked = look.inverted;
    iso.show(look.iso);
  };
  return body;
}

function volumeSection(viewer) {
  const {volume} = viewer, controls = castControls(viewer);
  const about = element('p', {class: 'quiet'}, t('The CT itself: {size} values.', {size: volume.told.size.join(' \u00d7 ')}) + (volume.told.isos.length > 0 ? ` ${t('The line over the histogram is where the surface was taken.')}` : ''));
  const shows = volume.told.alone ? null : choice(t('What is shown'), [['surfaces', t('Surfaces')], ['volume', t('Volume')], ['both', t('Both')]].map(([value, words]) => ({value, words})), volume.look.shows,
    value => viewer.setVolume({shows: value, ...(value === 'both' && volume.projects ? {cast: 'shaded'} : {})}));
  const body = element('div', {}, controls);
  const show = () => {
    shows?.show(volume.look.shows);
    body.hidden = !volume.showsVolume;
    controls.show();
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {id: 'volume-controls', 'aria-label': t('Volume')}, element('h2', {}, t('Volume')), about, shows, body);
}

/// Working lengths: of each canal's line on the film as it hangs now, and its own.
function filmLengths(viewer) {
  const {tours} = viewer.description, rows = tours.filter(tour => tour.points_mm.length > 1).map(tour => ({tour, cell: element('td', {}), own: trueLength(tour.points_mm)}));
  if (rows.length === 0) return element('div', {});
  const mm = value => t('{length} mm', {length: number(value, 1)}), head = [t('Line'), t('On film'), t('True')].map(words => element('th', {scope: 'col'}, words));
  const body = element('div', {}, element('table', {class: 'lengths', id: 'film-lengths'}, element('thead', {}, element('tr', {}, ...head)),
    element('tbody', {}, ...rows.map(({tour, cell, own}) => element('tr', {}, element('th', {scope: 'row'}, named(tour.name)), cell, element('td', {}, mm(own)))))),
    element('p', {class: 'quiet'}, t('From the chamber to the end of the root. The film hangs at the middle of the tooth, square to the rays: what leans towards the tube or away from it is shown shorter, what lies nearer the tube larger.')));
  viewer.addEventListener('drawn', () => {
    if (viewer.shadow.on) for (const {tour, cell} of rows) cell.textContent = mm(lengthOnFilm(tour.points_mm, viewer.camera, viewer.bounds.centre));
  });
  return body;
}

function filmSection(viewer) {
  const {shadow} = viewer, on = element('input', {type: 'checkbox', id: 'film', onchange: e => viewer.setFilm(e.target.checked)});
  const latitude = told(t('White at attenuation'), {low: 0.5, high: 10, step: 0.1, value: 4}, value => { shadow.latitude = value; viewer.dress(); });
  const inverted = element('input', {type: 'checkbox', id: 'film-inverted', onchange: e => { shadow.inverted = e.target.checked; viewer.dress(); }});
  const edged = element('input', {type: 'checkbox', id: 'film-edge', onchange: e => { shadow.size = e.target.checked ? filmSize : [0, 0]; viewer.dress(); }});
  const ruler = new FilmRuler(viewer, () => shadow.on);
  const switches = [[inverted, t('Inverted')], [edged, t('Film of 31 x 41 mm')]].map(([input, words]) => element('label', {class: 'switch'}, input, words));
  const body = element('div', {}, latitude, ...switches, tubeControl(viewer), filmLengths(viewer), ruler.body);
  const show = () => {
    if (!shadow.on) ruler.clear();
    on.checked = shadow.on;
    inverted.checked = shadow.inverted;
    edged.checked = shadow.size[0] > 0;
    body.hidden = !shadow.on;
    latitude.show(shadow.latitude);
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {id: 'film-controls', 'aria-label': t('X-ray')}, element('h2', {}, t('X-ray')), element('label', {class: 'switch'}, on, t('As an X-ray film shows it')), body);
}

/// Of the page's volume, or where it has none of its model's film; null: of neither.
export function greysSection(viewer) { return viewer.volume ? volumeSection(viewer) : viewer.shadow ? filmSection(viewer) : null; }
