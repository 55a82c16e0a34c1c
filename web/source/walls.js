// Moving a ball among walls that hold.
//
// The ball's centre always has a distance of at least `radius` from every wall. It goes straight by less than its distance to the nearest one
// at a time, and on such a way there is no wall to be crossed: however far a step is meant to lead, nothing is ever passed through.

const least = 0.999;         // of the radius: what rounding may take
const shortStep = 0.25;      // of the radius: how far it goes at a time while it touches
const mostRounds = 60;       // what is left of a step after these is dropped

const plus = (p, d, s) => [p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = v => Math.hypot(v[0], v[1], v[2]);

/// From `p` by `step`, sliding along what is met. Precondition: p is `radius` from the walls or farther; else it stays where it is.
export function glide(tree, p, step, radius) {
  let left = [...step];
  for (let round = 0; round < mostRounds; ++round) {
    const distance = length(left);
    if (!(distance > 1e-9)) break;
    const near = tree.nearest(p);
    if (near.distance < radius * least) break;
    const direction = left.map(x => x / distance), free = near.distance - radius;
    if (free > shortStep * radius) {
      const go = Math.min(distance, free);
      p = plus(p, direction, go);
      left = plus(left, direction, -go);
      continue;
    }
    const away = minusOver(p, near.point, near.distance), into = dot(direction, away);
    const slide = into < 0 ? plus(direction, away, -into) : direction;
    if (length(slide) < 1e-3) break;   // straight against the wall
    const go = Math.min(distance, shortStep * radius), next = outOf(tree, plus(p, slide, go), radius);
    if (!next) break;
    p = next;
    left = plus(left, direction, -go);
  }
  return p;
}

const minusOver = (a, b, s) => [(a[0] - b[0]) / s, (a[1] - b[1]) / s, (a[2] - b[2]) / s];

/// Pushed out of what it now touches too closely; null where the ball does not fit. A push is shorter than the distance to the nearest wall.
function outOf(tree, p, radius) {
  for (let push = 0; push < 4; ++push) {
    const near = tree.nearest(p);
    if (near.distance >= radius * least) return p;
    if (near.distance <= 0.5 * radius) return null;
    p = plus(p, minusOver(p, near.point, near.distance), radius - near.distance);
  }
  return null;
}
