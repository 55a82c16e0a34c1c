// Surfaces in the colours of numbers, as on the desktop: how far they lie from the CT's own surface, or how steep its
// values are there.
import {BufferAttribute, Color, SRGBColorSpace} from 'three';
import {data as colours} from '../../assets/theme.json';
import {ValueGrid, deviationsOf, partedIntoFour, summaryOf} from './deviation.js';

const longest = 200; // ms of work at a time, so that the page stays awake, and drawing does not take most of the time

const linear = hex => new Color().setStyle(hex, SRGBColorSpace);

/// As the screen shows it, of a part from -1 to 1 of the legend.
export function legendColour(of, part) {
  const [low, middle, high] = colours[of].map(linear);
  return middle.lerp(part < 0 ? low : high, Math.abs(part)).getStyle(SRGBColorSpace);
}

/// Uniforms that all surfaces share.
export function dataUniforms() {
  const first = {data_low: '#000', data_middle: '#000', data_high: '#000', data_nowhere: colours.nowhere_near};
  return {
    data_reach: {value: 1},
    ...Object.fromEntries(Object.entries(first).map(([name, hex]) => [name, {value: linear(hex)}])),
  };
}

/// Gives other things their turn now and then.
function resting() {
  let until = performance.now() + longest;
  return async () => {
    if (performance.now() < until) return;
    await new Promise(done => {
      setTimeout(done);
    });
    until = performance.now() + longest;
  };
}

export class DataColours {
  /// Null where no surface was taken at a value of the page's volume.
  static of(viewer, told, bytes) {
    return told?.isos.length > 0 && !told.alone ? new DataColours(viewer, told, bytes) : null;
  }

  constructor(viewer, told, bytes) {
    this.viewer = viewer;
    this.grid = new ValueGrid(told, bytes);
    this.isos = new Map(told.isos.map(({structure, value}) => [structure, value]));
    this.shown = null; // 'distance', 'slope'; null: own colours
    this.asked = null; // of them, while the surfaces are compared
    this.reach = {distance: this.grid.coarsest, slope: 1};
    this.summaries = null; // of each model
  }

  get summary() {
    return this.summaries?.[this.viewer.chosen] ?? null;
  }
  get uniform() {
    return {distance: 1, slope: 2}[this.shown] ?? 0;
  }

  async choose(of) {
    this.asked = of;
    if (!of || this.summaries) return this.put(of);
    this.put(null);
    this.comparing ??= this.compare();
    await this.comparing;
    if (this.asked) this.put(this.asked);
  }

  put(of) {
    const {viewer} = this,
      began = of && !this.shown;
    this.shown = of;
    if (began && viewer.volume?.look.shows !== 'both')
      // colours are to be told apart
      for (const look of viewer.looks.values()) if (!look.as_body) look.opacity = 1;
    if (of) this.setReach(this.reach[of]);
    else viewer.dress();
  }

  /// Where the colours end: mm, or values a millimetre.
  setReach(reach) {
    const {shared} = this.viewer;
    this.reach[this.shown] = reach;
    shared.data_reach.value = reach;
    ['data_low', 'data_middle', 'data_high'].forEach((name, index) =>
      shared[name].value.copy(linear(colours[this.shown][index])),
    );
    this.viewer.dress();
  }

  /// Parts the surfaces' triangles and gives each corner its numbers.
  async compare() {
    const rest = resting(),
      summaries = [];
    for (const {parts} of this.viewer.models) {
      const lists = [];
      for (const {structure, geometry} of parts) {
        if (!this.isos.has(structure)) continue;
        const {position, normal} = geometry.attributes;
        const fine = partedIntoFour(position.array, normal.array, geometry.index.array);
        const data = await deviationsOf(this.grid, this.isos.get(structure), fine.positions, fine.normals, rest);
        geometry.setAttribute('position', new BufferAttribute(fine.positions, 3));
        geometry.setAttribute('normal', new BufferAttribute(fine.normals, 3));
        geometry.setAttribute('data', new BufferAttribute(data, 2));
        geometry.setIndex(new BufferAttribute(fine.indices, 1));
        this.viewer.forgetWalls(geometry);
        lists.push(data);
      }
      summaries.push(summaryOf(lists));
    }
    this.summaries = summaries;
    const steepest = summaries[this.viewer.chosen]?.steep ?? 0;
    this.reach.slope = steepest > 0 ? steepest : 1;
  }
}
