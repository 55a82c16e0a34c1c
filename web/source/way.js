// A way through a canal as the program computed it (engine/navigate/tour.h), by time and by length. Plain arrays and numbers, so that it runs
// without a browser too.

const minus = (a, b) => a.map((x, k) => x - b[k]);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const between = (a, b, share) => a.map((x, k) => x + share * (b[k] - x));
const unit = v => v.map(x => x / Math.hypot(...v));

/// Of `values` that never fall: the step that holds `wanted`, and how much of it is gone.
function placeIn(values, wanted) {
  let low = 0, high = values.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] < wanted) low = middle; else high = middle;
  }
  const step = values[high] - values[low];
  return {step: low, share: step > 0 ? Math.min(Math.max((wanted - values[low]) / step, 0), 1) : 0};
}

/// Numbers that page.cpp wrote as whole steps of `finest`, each from where the two before it lead.
function addedUp(steps, finest) {
  let value = 0, step = 0;
  return steps.map(more => finest * (value += step += more));
}

function vectors(components, finest) {
  const [x, y, z] = components.map(steps => addedUp(steps, finest));
  return x.map((first, i) => [first, y[i], z[i]]);
}

export class Way {
  /// `tour`: as page.cpp writes it. Its keys are even in time; what only leads somewhere, a horn, has points alone.
  constructor({points_mm, keys}) {
    this.places = keys ? vectors(keys.at_mm, keys.finest) : points_mm;
    this.directions = keys && vectors(keys.view_direction, keys.finest);
    this.ups = keys && vectors(keys.up, keys.finest);
    this.seconds = keys?.seconds ?? 0;
    this.along = keys ? addedUp(keys.along_mm, keys.finest) : points_mm.map(() => 0);
    if (!keys) for (let i = 1; i < points_mm.length; ++i) this.along[i] = this.along[i - 1] + Math.hypot(...minus(points_mm[i], points_mm[i - 1]));
    this.length = this.along.at(-1);
  }

  /// Between keys place and turn go evenly: {mm, place, direction, up}.
  at(step, share) {
    const value = values => between(values[step], values[step + 1], share);
    return {
      mm: this.along[step] + share * (this.along[step + 1] - this.along[step]), place: value(this.places),
      direction: this.directions && unit(value(this.directions)), up: this.ups && unit(value(this.ups)),
    };
  }

  atTime(seconds) {
    const steps = this.places.length - 1, place = Math.min(Math.max(seconds / this.seconds, 0), 1) * steps, step = Math.min(Math.floor(place), steps - 1);
    return this.at(step, place - step);
  }

  atLength(mm) {
    const {step, share} = placeIn(this.along, mm);
    return this.at(step, share);
  }

  /// When it is first `mm` along.
  timeAt(mm) {
    const {step, share} = placeIn(this.along, mm);
    return (step + share) / (this.places.length - 1) * this.seconds;
  }

  /// The nearest place on the way: {mm, distance}.
  nearest(p) {
    let mm = 0, best = Infinity;
    for (let i = 0; i + 1 < this.places.length; ++i) {
      const piece = minus(this.places[i + 1], this.places[i]), off = minus(p, this.places[i]);
      const share = Math.min(Math.max(dot(off, piece) / Math.max(dot(piece, piece), 1e-12), 0), 1), distance = Math.hypot(...minus(off, piece.map(x => share * x)));
      if (distance < best) [best, mm] = [distance, this.along[i] + share * (this.along[i + 1] - this.along[i])];
    }
    return {mm, distance: best};
  }
}
