// The controls of grey values.
import {choice, element} from './dom.js';
import {dataControls} from './data_panel.js';
import {filmControls, filmSection} from './film_panel.js';
import {capital, said, t} from './language.js';
import {told} from './slider_row.js';
import {TransferEditor} from './transfer_editor.js';

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
  const steepest = (high - low) / Math.min(...volume.told.step_mm), slope = {low: 0, high: steepest, step: steepest / 500, value: 0}, least = slope.step, of_slopes = () => volume.look.slopes;
  const borders = element('input', {type: 'checkbox', id: 'borders', onchange: e => viewer.setVolume({slopes: e.target.checked ? [0.05 * steepest, 0.2 * steepest] : [0, 0]})});
  const flat = told(t('Too flat, values/mm'), slope, value => viewer.setVolume({slopes: [Math.min(value, of_slopes()[1] - least), of_slopes()[1]]}));
  const steep = told(t('Steep enough, values/mm'), slope, value => viewer.setVolume({slopes: [of_slopes()[0], Math.max(value, of_slopes()[0] + least)]}));
  const only = element('label', {class: 'switch'}, borders, t('Borders only'));
  const iso = told(t('Value'), range, value => viewer.setVolume({iso: value})), film = filmControls(viewer);
  const of = {shaded: [kinds, dense, only, flat, steep], maximum: [black, white], average: [black, white], radiograph: [film], surface: [iso]};
  const all = [kinds, dense, only, flat, steep, black, white, film, iso];
  const begin = cast => ({
    cast, ...(['maximum', 'average', 'radiograph'].includes(cast) ? {shows: 'volume'} : {}), ...(cast === 'surface' ? {iso: isos[0]?.value ?? 0.5 * (air + dentine)} : {}),
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
    film.show();
    iso.show(look.iso);
  };
  return body;
}

function volumeSection(viewer) {
  const {volume} = viewer, controls = castControls(viewer);
  const about = element('p', {class: 'quiet'}, t('The CT itself: {size} values.', {size: volume.told.size.join(' \u00d7 ')}) + (volume.told.isos.length > 0 ? ` ${t('The line over the histogram is where the surface was taken.')}` : ''));
  const shows = volume.told.alone ? null : choice(t('What is shown'), [['surfaces', t('Surfaces')], ['volume', t('Volume')], ['both', t('Both')]].map(([value, words]) => ({value, words})), volume.look.shows,
    value => viewer.setVolume({shows: value, ...(value === 'both' && volume.projects ? {cast: 'shaded'} : {})}));
  const body = element('div', {}, controls), data = dataControls(viewer);
  const show = () => {
    data?.show();
    shows?.show(volume.look.shows);
    body.hidden = !volume.showsVolume;
    controls.show();
  };
  show();
  viewer.addEventListener('change', show);
  return element('section', {id: 'volume-controls', 'aria-label': t('Volume')}, element('h2', {}, t('Volume')), about, data, shows, body);
}

/// Of the page's volume, or where it has none of its model's film; null: of neither.
export function greysSection(viewer) { return viewer.volume ? volumeSection(viewer) : viewer.shadow ? filmSection(viewer) : null; }
