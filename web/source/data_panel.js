// The controls of surfaces in the colours of numbers, with their legend.
import {choice, element} from './dom.js';
import {legendColour} from './data_colours.js';
import {plainNumber, t} from './language.js';
import {told} from './slider_row.js';

const pieces = 48;
const three = value => plainNumber(Number(value.toPrecision(3)));

function paint(canvas, of) {
  const pen = canvas.getContext('2d');
  for (let i = 0; i < pieces; ++i) {
    pen.fillStyle = legendColour(of, (2 * (i + 0.5)) / pieces - 1);
    pen.fillRect(i, 0, 1, 1);
  }
}

/// Null: there is nothing to compare.
export function dataControls(viewer) {
  const {data} = viewer;
  if (!data) return null;
  const ways = [
    ['own', t('Own colours')],
    ['distance', t('Distance')],
    ['slope', t('Slope')],
  ].map(([value, words]) => ({value, words}));
  const which = choice(t('Surfaces against the CT'), ways, 'own', value => data.choose(value === 'own' ? null : value));
  which.id = 'data-colours';
  const status = element('p', {class: 'quiet', role: 'status', id: 'data-told'});
  const bar = element('canvas', {class: 'legend', width: pieces, height: 1, role: 'img', 'aria-label': t('Legend')});
  const ends = element('p', {class: 'quiet', id: 'data-ends'});
  const range = {low: 0, high: 1, step: 'any', value: 1};
  const reaches = {
    distance: told(t('Colours reach to, mm'), range, reach => data.setReach(reach)),
    slope: told(t('Colours reach to, values/mm'), range, reach => data.setReach(reach)),
  };
  const body = element(
    'div',
    {},
    element('p', {class: 'quiet'}, t('Surfaces against the CT')),
    which,
    reaches.distance,
    reaches.slope,
    bar,
    ends,
    status,
  );
  const mostOf = ({most, steep}, of) =>
    of === 'distance' ? Math.max(most, data.grid.coarsest) : 4 * Math.max(steep, 1e-9);
  body.show = () => {
    const {shown, asked, summary} = data,
      reach = data.reach[shown];
    which.show(shown ?? asked ?? 'own');
    for (const of of ['distance', 'slope']) reaches[of].hidden = of !== shown;
    bar.hidden = ends.hidden = !shown;
    status.textContent = asked && !shown ? t('Comparing with the CT…') : '';
    if (!shown || !summary) return;
    const most = mostOf(summary, shown);
    Object.assign(reaches[shown].querySelector('input'), {min: most / 200, max: most});
    reaches[shown].show(reach);
    paint(bar, shown);
    if (shown === 'slope') ends.textContent = t('0 to {most} grey values a millimetre', {most: three(reach)});
    else {
      ends.textContent = t('−{less} mm (blue: the CT reaches beyond the model) to +{more} mm (red: the model beyond the CT)', {less: three(reach), more: three(reach)});
      const {median, within, most: farthest} = summary;
      status.textContent = t('Median {median} mm, 95 % within {within} mm, the farthest {most} mm.', {
        median: three(median),
        within: three(within),
        most: three(farthest),
      });
    }
  };
  return body;
}
