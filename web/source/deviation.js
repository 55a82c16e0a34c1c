// Model against data: how far a surface lies from where the page's grey values cross the value that it was taken at,
// and how steeply they do. The programme's own method (engine/scene/deviation.h), on values of eight bits: one of them
// is off the CT's by half a step at most, and so is a distance by that over the slope.

export const nowhere = 1e9; // the distance of what has no crossing in reach
const reachSteps = 6,
  stepsOfVoxel = 4,
  halvings = 30,
  mostTurns = 4;
const allAround = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 1],
  [1, 1, -1],
  [1, -1, 1],
  [-1, 1, 1],
];

const lengthOf = (x, y, z) => Math.sqrt(x * x + y * y + z * z);

export class ValueGrid {
  /// `told`: the page's description of its volume; `bytes`: the values.
  constructor({size, first_mm, step_mm, low, high}, bytes) {
    [this.width, this.height, this.depth] = size;
    [this.x0, this.y0, this.z0] = first_mm;
    [this.dx, this.dy, this.dz] = step_mm;
    Object.assign(this, {bytes, low, unit: (high - low) / 255});
    this.finest = Math.min(...step_mm);
    this.coarsest = Math.max(...step_mm);
  }

  /// In bytes, between places straight, and beyond the outermost as there.
  at(x, y, z) {
    const {width, height, depth, bytes} = this;
    const u = Math.min(Math.max((x - this.x0) / this.dx, 0), width - 1);
    const v = Math.min(Math.max((y - this.y0) / this.dy, 0), height - 1);
    const w = Math.min(Math.max((z - this.z0) / this.dz, 0), depth - 1);
    const i = Math.floor(u),
      j = Math.floor(v),
      k = Math.floor(w),
      a = u - i,
      b = v - j,
      c = w - k;
    const right = i + 1 < width ? 1 : 0,
      back = j + 1 < height ? width : 0,
      up = k + 1 < depth ? width * height : 0;
    const n = (k * height + j) * width + i,
      m = n + up;
    const near = bytes[n] + a * (bytes[n + right] - bytes[n]);
    const far = bytes[n + back] + a * (bytes[n + back + right] - bytes[n + back]);
    const nearUp = bytes[m] + a * (bytes[m + right] - bytes[m]);
    const farUp = bytes[m + back] + a * (bytes[m + back + right] - bytes[m + back]);
    const below = near + b * (far - near),
      above = nearUp + b * (farUp - nearUp);
    return below + c * (above - below);
  }

  /// From the lower values to the higher, bytes a millimetre.
  slopeAt(x, y, z) {
    const {dx, dy, dz} = this;
    return [
      (this.at(x + 0.5 * dx, y, z) - this.at(x - 0.5 * dx, y, z)) / dx,
      (this.at(x, y + 0.5 * dy, z) - this.at(x, y - 0.5 * dy, z)) / dy,
      (this.at(x, y, z + 0.5 * dz) - this.at(x, y, z - 0.5 * dz)) / dz,
    ];
  }
}

/// The search for the crossing of a value that is nearest to a place.
class Search {
  constructor(grid, iso, x, y, z) {
    Object.assign(this, {grid, iso, x, y, z, foot: null, best: reachSteps * grid.coarsest});
    this.below = grid.at(x, y, z) < iso;
  }

  crossed(p, q, r, way) {
    return this.grid.at(this.x + way * p, this.y + way * q, this.z + way * r) < this.iso !== this.below;
  }

  /// The first crossing along a direction of unit length, if it is nearer than the best; true: it was.
  look(p, q, r) {
    const stride = this.grid.finest / stepsOfVoxel;
    for (let near = 0; near < this.best;) {
      let far = Math.min(near + stride, this.best);
      if (!this.crossed(p, q, r, far)) {
        near = far;
        continue;
      }
      for (let i = 0; i < halvings; ++i) {
        const middle = 0.5 * (near + far);
        if (this.crossed(p, q, r, middle)) far = middle;
        else near = middle;
      }
      this.best = far;
      this.foot = [this.x + far * p, this.y + far * q, this.z + far * r];
      return true;
    }
    return false;
  }

  lookBothWays([p, q, r]) {
    const length = lengthOf(p, q, r);
    if (!(length > 0)) return;
    this.look(p / length, q / length, r / length);
    this.look(-p / length, -q / length, -r / length);
  }

  /// From the nearest crossing the shortest way back runs along the slope that the values have there.
  lookBack() {
    for (let turn = 0; turn < mostTurns && this.foot; ++turn) {
      const [x, y, z] = this.foot,
        [p, q, r] = this.grid.slopeAt(x, y, z),
        steep = lengthOf(p, q, r);
      const side = p * (x - this.x) + q * (y - this.y) + r * (z - this.z),
        length = side < 0 ? -steep : steep;
      if (!(steep > 0) || !this.look(p / length, q / length, r / length)) return;
    }
  }
}

/// Millimetres; positive where the model reaches beyond the data, negative where the data reach beyond the model;
/// `nowhere` beyond six voxels. `iso` in bytes.
export function deviationAt(grid, iso, [x, y, z], normal) {
  const search = new Search(grid, iso, x, y, z);
  search.lookBothWays(normal);
  search.lookBothWays(grid.slopeAt(x, y, z));
  for (const way of allAround) search.lookBothWays(way);
  search.lookBack();
  if (!search.foot) return nowhere;
  return search.below ? search.best : -search.best;
}

/// Each triangle into four, at the middle of its edges, which changes no shape: contours have their points where values
/// cross, so that a surface made of them is off between slices above all.
export function partedIntoFour(positions, normals, indices) {
  const count = positions.length / 3,
    middles = new Map(),
    places = Array.from(positions),
    ways = Array.from(normals);
  const middle = (a, b) => {
    const key = a < b ? a * count + b : b * count + a,
      known = middles.get(key);
    if (known !== undefined) return known;
    const way = [0, 1, 2].map(k => normals[3 * a + k] + normals[3 * b + k]),
      length = lengthOf(...way);
    for (let k = 0; k < 3; ++k) {
      places.push(0.5 * (positions[3 * a + k] + positions[3 * b + k]));
      ways.push(length > 0 ? way[k] / length : normals[3 * a + k]);
    }
    middles.set(key, places.length / 3 - 1);
    return places.length / 3 - 1;
  };
  const parted = new Uint32Array(4 * indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.slice(i, i + 3),
      ab = middle(a, b),
      bc = middle(b, c),
      ca = middle(c, a);
    parted.set([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca], 4 * i);
  }
  return {positions: Float32Array.from(places), normals: Float32Array.from(ways), indices: parted};
}

/// Of each position its distance, mm, and the slope there, values a millimetre. `rest()` is waited for now and then.
export async function deviationsOf(grid, value, positions, normals, rest) {
  const found = new Float32Array((positions.length / 3) * 2),
    iso = (value - grid.low) / grid.unit;
  for (let i = 0; 3 * i < positions.length; ++i) {
    if (i % 500 === 0) await rest();
    const place = [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];
    found[2 * i] = deviationAt(grid, iso, place, [normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]]);
    found[2 * i + 1] = grid.unit * lengthOf(...grid.slopeAt(...place));
  }
  return found;
}

/// Of several such lists: {median, within, most} of the distances, whatever their sign (within: nineteen of twenty
/// are), and the slope that nineteen of twenty stay below. Null: there is nothing in them.
export function summaryOf(lists) {
  const distances = [],
    slopes = [],
    sorted = values => Float64Array.from(values).sort();
  for (const list of lists)
    for (let i = 0; i < list.length; i += 2) {
      slopes.push(list[i + 1]);
      if (Math.abs(list[i]) < nowhere) distances.push(Math.abs(list[i]));
    }
  if (slopes.length === 0) return null;
  const far = sorted(distances),
    part = (values, share) => values[Math.trunc(share * (values.length - 1))] ?? 0;
  return {median: part(far, 0.5), within: part(far, 0.95), most: part(far, 1), steep: part(sorted(slopes), 0.95)};
}
