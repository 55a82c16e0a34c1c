// The controls of an X-ray film, of a CT or of a model: exposure, size, beam, tube, and what is measured on it.
import films from '../../assets/films.json';
import {choice, element} from './dom.js';
import {lengthOnFilm, trueLength} from './film_length.js';
import {FilmRuler} from './film_ruler.js';
import {named, number, t} from './language.js';
import {told} from './slider_row.js';

/// Intraoral films by their size, upright, mm.
export const dentalFilms = films.intraoral_mm;

const quiet = (...words) => element('p', {class: 'quiet'}, ...words);

function sizeControl(viewer) {
  const size = () => viewer.filmLook.film_mm,
    isAcross = () => size()[0] > size()[1];
  const turned = (upright, across) => (across ? [...upright].reverse() : [...upright]);
  const numberOf = ([width, height]) =>
    dentalFilms.findIndex(film => film.join() === turned([width, height], width > height).join());
  const words = [t('No edge'), ...dentalFilms.keys()].map((word, index) => ({
    value: String(index),
    words: String(word),
  }));
  const films = choice(t('Film, by its size'), words, '0', chosen => {
    const film_mm = chosen === '0' ? [0, 0] : turned(dentalFilms[Number(chosen) - 1], isAcross());
    viewer.setFilmLook({film_mm});
  });
  films.id = 'film-size';
  const across = element('input', {
    type: 'checkbox',
    id: 'film-across',
    onchange: () => viewer.setFilmLook({film_mm: [...size()].reverse()}),
  });
  const lies = element('label', {class: 'switch'}, across, t('Lies across')),
    about = quiet();
  const row = element('div', {}, quiet(t('Film, by its size')), films, lies, about);
  row.show = () => {
    const [width, height] = size(),
      edged = width > 0;
    films.show(edged ? String(1 + numberOf(size())) : '0');
    across.checked = isAcross();
    lies.hidden = about.hidden = !edged;
    about.textContent = t('{width} x {height} mm, at the middle of the tooth', {width, height});
  };
  return row;
}

function beamControl(viewer) {
  const kinds = [
    ['cone', t('Cone beam')],
    ['parallel', t('Parallel beam')],
  ];
  const beams = choice(
    t('Beam'),
    kinds.map(([value, words]) => ({value, words})),
    viewer.beam,
    beam => viewer.setBeam(beam),
  );
  const about = quiet(),
    row = element('div', {id: 'film-beam'}, beams, about);
  row.show = () => {
    beams.show(viewer.beam);
    const distance = number(viewer.orbit.camera.position.distanceTo(viewer.bounds.centre), 0);
    about.textContent =
      viewer.beam === 'parallel'
        ? t('All rays run one way, and all is shown in its own size.')
        : t('Rays come from a focus {distance} mm before the film.', {distance});
  };
  return row;
}

function tubeControl(viewer) {
  const swing = degrees => {
    tube.show(degrees);
    viewer.swingTube(degrees);
  };
  const range = {low: -40, high: 40, step: 1, value: 0};
  const tube = told(t('Tube swung by'), range, swing, degrees => `${degrees}\u00b0`);
  tube.show(0);
  const rule = t('Same lingual, opposite buccal: of two canals that lie one behind the other, the one that moves with the tube lies lingually.');
  return element('div', {}, tube, quiet(rule));
}

/// Working lengths: of each canal's line on the film as it hangs now, and its own.
function filmLengths(viewer) {
  const rows = viewer.description.tours
    .filter(tour => tour.points_mm.length > 1)
    .map(tour => ({tour, cell: element('td', {}), own: trueLength(tour.points_mm)}));
  if (rows.length === 0) return element('div', {});
  const mm = value => t('{length} mm', {length: number(value, 1)});
  const head = [t('Line'), t('On film'), t('True')].map(words => element('th', {scope: 'col'}, words));
  const lines = rows.map(({tour, cell, own}) =>
    element('tr', {}, element('th', {scope: 'row'}, named(tour.name)), cell, element('td', {}, mm(own))),
  );
  const table = element(
    'table',
    {class: 'lengths', id: 'film-lengths'},
    element('thead', {}, element('tr', {}, ...head)),
    element('tbody', {}, ...lines),
  );
  const about = t('From the chamber to the end of the root. The film hangs at the middle of the tooth, square to the rays: what leans towards the tube or away from it is shown shorter, what lies nearer the tube larger.');
  viewer.addEventListener('drawn', () => {
    if (!viewer.film) return;
    for (const {tour, cell} of rows)
      cell.textContent = mm(lengthOnFilm(tour.points_mm, viewer.camera, viewer.bounds.centre));
  });
  return element('div', {}, table, quiet(about));
}

/// `show()` follows what the film looks like.
export function filmControls(viewer) {
  const latitude = told(t('White at attenuation'), {low: 0.5, high: 10, step: 0.1, value: 4}, value =>
    viewer.setFilmLook({latitude: value}),
  );
  const inverted = element('input', {
    type: 'checkbox',
    id: 'film-inverted',
    onchange: event => viewer.setFilmLook({inverted: event.target.checked}),
  });
  const size = sizeControl(viewer),
    beam = beamControl(viewer),
    ruler = new FilmRuler(viewer);
  const negative = element('label', {class: 'switch'}, inverted, t('Inverted'));
  const body = element('div', {}, latitude, negative, size, beam, tubeControl(viewer), filmLengths(viewer), ruler.body);
  body.show = () => {
    if (!viewer.film) ruler.clear();
    latitude.show(viewer.filmLook.latitude);
    inverted.checked = viewer.filmLook.inverted;
    size.show();
    beam.show();
  };
  viewer.addEventListener('drawn', () => {
    if (viewer.film) beam.show();
  });
  return body;
}

/// Of a page without a volume: the film of its model.
export function filmSection(viewer) {
  const {shadow} = viewer,
    body = filmControls(viewer);
  const on = element('input', {type: 'checkbox', id: 'film', onchange: event => viewer.setFilm(event.target.checked)});
  const show = () => {
    on.checked = shadow.on;
    body.hidden = !shadow.on;
    body.show();
  };
  show();
  viewer.addEventListener('change', show);
  return element(
    'section',
    {id: 'film-controls', 'aria-label': t('X-ray')},
    element('h2', {}, t('X-ray')),
    element('label', {class: 'switch'}, on, t('As an X-ray film shows it')),
    body,
  );
}
