// Where a plane meets a surface of triangles. Plain arrays and numbers, so that it runs without a browser too.

const mostPairs = 2000;   // open ends among which the nearest are looked for

/// For each vertex the first one in the same place: surfaces for drawing have a vertex more wherever normals differ.
export function weldedVertices(positions) {
  const first = new Map(), same = new Uint32Array(positions.length / 3);
  for (let v = 0; v < same.length; ++v) {
    const key = `${positions[3 * v]},${positions[3 * v + 1]},${positions[3 * v + 2]}`;
    if (!first.has(key)) first.set(key, v);
    same[v] = first.get(key);
  }
  return same;
}

/// The closed loops, as lists of [x, y, z], in which the plane dot(normal, p) = w cuts the surface; `same` from weldedVertices. Where the
/// surface is open, loose ends are joined to the nearest others by straight lines; `joined` counts these.
export function loopsOf({positions, indices, same}, [nx, ny, nz, w]) {
  const count = positions.length / 3, off = new Float64Array(count);
  for (let v = 0; v < count; ++v) off[v] = nx * positions[3 * v] + ny * positions[3 * v + 1] + nz * positions[3 * v + 2] - w;
  const nodes = new Map(), points = [], lines = [], linesAt = [];
  // A point of the cut lies on an edge. A vertex in the plane counts as above it, as in recon/mesh/plane_section.h, so that every triangle has none or two.
  const nodeOn = (a, b) => {
    if (a > b) [a, b] = [b, a];
    const key = a * count + b;
    let node = nodes.get(key);
    if (node === undefined) {
      node = points.length;
      nodes.set(key, node);
      const t = off[a] / (off[a] - off[b]);
      points.push([0, 1, 2].map(k => positions[3 * a + k] + t * (positions[3 * b + k] - positions[3 * a + k])));
      linesAt.push([]);
    }
    return node;
  };
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [same[indices[i]], same[indices[i + 1]], same[indices[i + 2]]], above = corners.map(v => off[v] >= 0);
    if (above[0] === above[1] && above[1] === above[2]) continue;
    const ends = [];
    for (let k = 0; k < 3; ++k) if (above[k] !== above[(k + 1) % 3]) ends.push(nodeOn(corners[k], corners[(k + 1) % 3]));
    linesAt[ends[0]].push(lines.length);
    linesAt[ends[1]].push(lines.length);
    lines.push(ends);
  }
  const {closed, open} = chainsOf(lines, linesAt);
  const joined = joinedChains(open, points);
  return {loops: [...closed, ...joined].filter(chain => chain.length > 2).map(chain => chain.map(node => points[node])), joined: open.length};
}

/// Lines end to end: first those that begin where an odd number of them meet, the rest closes.
function chainsOf(lines, linesAt) {
  const used = new Uint8Array(lines.length), next = linesAt.map(() => 0);
  const walk = start => {
    const chain = [start];
    for (let node = start;;) {
      while (next[node] < linesAt[node].length && used[linesAt[node][next[node]]]) next[node] += 1;
      if (next[node] === linesAt[node].length) return chain;
      const line = linesAt[node][next[node]];
      used[line] = 1;
      node = lines[line][0] === node ? lines[line][1] : lines[line][0];
      chain.push(node);
    }
  };
  const left = node => linesAt[node].filter(line => !used[line]).length;
  const closed = [], open = [];
  for (let node = 0; node < linesAt.length; ++node) if (left(node) % 2 === 1) open.push(walk(node));
  for (let node = 0; node < linesAt.length; ++node) while (left(node) > 0) closed.push(walk(node).slice(1));
  return {closed, open};
}

/// Each end joined to one other, the nearest pairs first; what then hangs together is one loop.
function joinedChains(chains, points) {
  const ends = chains.flatMap((chain, index) => [{index, at: points[chain[0]]}, {index, at: points[chain.at(-1)]}]), mate = ends.map((_, e) => e ^ 1);
  if (ends.length <= mostPairs) {
    const pairs = [], free = ends.map(() => true);
    for (let a = 0; a < ends.length; ++a)
      for (let b = a + 1; b < ends.length; ++b) pairs.push([a, b, Math.hypot(...[0, 1, 2].map(k => ends[a].at[k] - ends[b].at[k]))]);
    for (const [a, b] of pairs.sort((p, q) => p[2] - q[2])) {
      if (!free[a] || !free[b]) continue;
      free[a] = free[b] = false;
      mate[a] = b;
      mate[b] = a;
    }
  }
  const seen = chains.map(() => false), loops = [];
  for (let start = 0; start < chains.length; ++start) {
    if (seen[start]) continue;
    const loop = [];
    for (let end = 2 * start; !seen[end >> 1]; end = mate[end ^ 1]) {   // enters a chain at `end`, leaves it at its other end
      seen[end >> 1] = true;
      loop.push(...(end & 1 ? [...chains[end >> 1]].reverse() : chains[end >> 1]));
    }
    loops.push(loop);
  }
  return loops;
}

/// Twice the area that a loop of [x, y] goes round, positive if counter-clockwise.
function twiceArea(loop) {
  let sum = 0;
  for (let i = 0; i < loop.length; ++i) {
    const a = loop[i], b = loop[(i + 1) % loop.length];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

function within(loop, [x, y]) {
  let inside = false;
  for (let i = 0; i < loop.length; ++i) {
    const a = loop[i], b = loop[(i + 1) % loop.length];
    if ((a[1] > y) !== (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

/// What an odd number of the loops of [x, y] goes round: outlines with their holes, whichever way each loop turns.
export function regionsOf(loops) {
  const sized = loops.map(loop => ({loop, size: Math.abs(twiceArea(loop)), holes: []})).filter(({size}) => size > 0).sort((a, b) => b.size - a.size);
  const outlines = [];
  sized.forEach((own, index) => {
    const middle = [0, 1].map(k => 0.5 * (own.loop[0][k] + own.loop[1][k]));
    const round = sized.slice(0, index).filter(({loop}) => within(loop, middle));
    if (round.length % 2 === 0) outlines.push(own);
    else round.at(-1).holes.push(own.loop);
  });
  return outlines.map(({loop, holes}) => ({outline: loop, holes}));
}

export const areaOf = ({outline, holes}) => 0.5 * (Math.abs(twiceArea(outline)) - holes.reduce((sum, hole) => sum + Math.abs(twiceArea(hole)), 0));
