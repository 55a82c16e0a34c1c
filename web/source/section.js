// The plane that cuts the model open: everything on its positive side is taken away.
import {Vector4} from 'three';

/// What each side's cut takes away first, and what is up for its slider.
export const sides = [
  {name: 'buccal', words: 'Buccal', normal: [0, 1, 0]},
  {name: 'mesial', words: 'Mesial', normal: [1, 0, 0]},
  {name: 'occlusal', words: 'Occlusal', normal: [0, 0, 1]},
];

export class Section {
  constructor(bounds) {
    this.bounds = bounds;
    this.on = false;
    this.side = sides[0];
    this.reversed = false;
    this.at = 0;   // mm from the model's middle
  }

  range() {
    const k = this.side.normal.indexOf(1), {min, max} = this.bounds.box;
    const half = 0.5 * (max.getComponent(k) - min.getComponent(k));
    return {low: -half, high: half};
  }

  choose(side) {
    this.side = side;
    this.at = 0;
  }

  /// The plane as (normal, distance), or null.
  plane() {
    if (!this.on) return null;
    const sign = this.reversed ? -1 : 1, [x, y, z] = this.side.normal.map(c => sign * c), c = this.bounds.centre;
    return new Vector4(x, y, z, x * c.x + y * c.y + z * c.z + sign * this.at);
  }
}
