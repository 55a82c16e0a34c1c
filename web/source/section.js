// The plane that cuts the model open: everything on its positive side is taken away.
import {Vector4} from 'three';
import {t} from './language.js';

/// What each side's cut takes away first, and what is up for its slider.
export const sides = [
  {name: 'buccal', words: t('Buccal'), normal: [0, 1, 0]},
  {name: 'mesial', words: t('Mesial'), normal: [1, 0, 0]},
  {name: 'occlusal', words: t('Occlusal'), normal: [0, 0, 1]},
];

const squareTo = 0.9999;   // a cosine

export class Section {
  constructor(bounds) {
    this.bounds = bounds;
    this.on = false;
    this.side = sides[0];
    this.reversed = false;
    this.at = 0;   // mm from the model's middle
    this.free = null;   // {point, normal} in any direction, in place of a side
  }

  /// As a lesson wants it; null: none. A plane square to an axis is a side's, which the slider moves.
  put(plane) {
    this.on = plane !== null;
    this.free = null;
    if (!plane) return;
    const {point, normal} = plane, along = normal.toArray(), side = sides.find(s => Math.abs(s.normal.reduce((sum, x, k) => sum + x * along[k], 0)) > squareTo);
    if (!side) {
      this.free = plane;
      return;
    }
    const k = side.normal.indexOf(1);
    this.side = side;
    this.reversed = along[k] < 0;
    this.at = point[k] - this.bounds.centre.getComponent(k);
  }

  range() {
    const k = this.side.normal.indexOf(1), {min, max} = this.bounds.box;
    const half = 0.5 * (max.getComponent(k) - min.getComponent(k));
    return {low: -half, high: half};
  }

  choose(side) {
    this.free = null;
    this.side = side;
    this.at = 0;
  }

  /// The plane as (normal, distance), or null.
  plane() {
    if (!this.on) return null;
    if (this.free) {
      const {point, normal} = this.free;
      return new Vector4(normal.x, normal.y, normal.z, normal.x * point[0] + normal.y * point[1] + normal.z * point[2]);
    }
    const sign = this.reversed ? -1 : 1, [x, y, z] = this.side.normal.map(c => sign * c), c = this.bounds.centre;
    return new Vector4(x, y, z, x * c.x + y * c.y + z * c.z + sign * this.at);
  }
}
