// How deep the walls of canals lie below their orifices; as the desktop does it (engine/navigate/wall_depth.h).

const aboveOrifice = -1;

/// The tours' pieces, each with the depth of its ends.
function piecesOf(tours) {
  const pieces = [];
  for (const {points_mm: points, orifice_mm: orifice} of tours) {
    let along = 0;
    for (let i = 0; i + 1 < points.length; ++i) {
      const [from, to] = [points[i], points[i + 1]], length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      const depth = orifice === null ? aboveOrifice : along - orifice;
      pieces.push({from, way: [to[0] - from[0], to[1] - from[1], to[2] - from[2]], squared: length * length, depth, deeper: orifice === null ? 0 : length, low: Math.min(from[2], to[2])});
      along += length;
    }
  }
  return pieces.sort((a, b) => a.low - b.low);
}

/// From ring to ring, so that there are at most 25: 1 mm in a tooth of usual size.
export function depthStep(tours) {
  const deepest = Math.max(0, ...tours.filter(tour => tour.orifice_mm !== null).map(tour => tour.length_mm));
  let step = 1;
  for (let five = true; deepest > 25 * step && step < 1e6; five = !five) step *= five ? 5 : 2;
  return step;
}

/// Of every place of `positions` (x, y, z, x, ...): that of the nearest place on a tour, in steps; -1 step or less beside the chamber.
export function wallDepths(positions, tours) {
  const pieces = piecesOf(tours), step = depthStep(tours), depths = new Float32Array(positions.length / 3).fill(aboveOrifice);
  if (pieces.length === 0) return depths;
  const tallest = Math.max(...pieces.map(piece => Math.abs(piece.way[2]))), lows = pieces.map(piece => piece.low);
  for (let v = 0; v < depths.length; ++v) {
    const x = positions[3 * v], y = positions[3 * v + 1], z = positions[3 * v + 2];
    let best = Infinity;
    const lookAt = ({from, way, squared, depth, deeper}) => {
      const [dx, dy, dz] = [x - from[0], y - from[1], z - from[2]];
      const part = squared > 0 ? Math.min(Math.max((dx * way[0] + dy * way[1] + dz * way[2]) / squared, 0), 1) : 0;
      const distance = (dx - part * way[0]) ** 2 + (dy - part * way[1]) ** 2 + (dz - part * way[2]) ** 2;
      if (distance < best) [best, depths[v]] = [distance, Math.max(depth + part * deeper, aboveOrifice)];
    };
    let up = firstNotBelow(lows, z), down = up - 1;
    const beyond = gap => gap > 0 && gap * gap >= best;
    while (up < pieces.length || down >= 0) {
      if (up < pieces.length) beyond(lows[up] - z) ? up = pieces.length : lookAt(pieces[up++]);
      if (down >= 0) beyond(z - lows[down] - tallest) ? down = -1 : lookAt(pieces[down--]);
    }
  }
  return depths.map(depth => depth / step);
}

function firstNotBelow(sorted, value) {
  let low = 0, high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    sorted[middle] < value ? low = middle + 1 : high = middle;
  }
  return low;
}
