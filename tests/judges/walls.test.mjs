// The page's walls, which nothing passes through, whatever is asked for; its cuts and its pace. Needs the page's own packages.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Quality} from '../../web/source/quality.js';
import {areaOf, loopsOf, regionsOf, weldedVertices} from '../../web/source/slice.js';
import {glide} from '../../web/source/walls.js';
import {bundled} from './support.mjs';

const {TriangleTree} = await bundled('bvh.js');

/// Numbers from 0 to 1, the same each time.
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/// A bent pipe with closed ends, radius `wide` along (x, 0, 2 sin x), 0 <= x <= 6.
function pipe(wide, around = 24, along = 60) {
  const positions = [], indices = [];
  const centre = s => [s, 0, 2 * Math.sin(s)];
  for (let i = 0; i <= along; ++i) {
    const s = 6 * i / along, c = centre(s), slope = 2 * Math.cos(s), length = Math.hypot(1, slope);
    for (let k = 0; k < around; ++k) {
      const a = 2 * Math.PI * k / around, out = Math.cos(a), side = Math.sin(a);
      positions.push(c[0] - wide * out * slope / length, wide * side, c[2] + wide * out / length);
    }
  }
  for (let i = 0; i < along; ++i)
    for (let k = 0; k < around; ++k) {
      const a = i * around + k, b = i * around + (k + 1) % around;
      indices.push(a, b, a + around, b, b + around, a + around);
    }
  for (const [ring, s] of [[0, 0], [along, 6]]) {
    const middle = positions.length / 3;
    positions.push(...centre(s));
    for (let k = 0; k < around; ++k) {
      const a = ring * around + k, b = ring * around + (k + 1) % around;
      indices.push(middle, ring === 0 ? b : a, ring === 0 ? a : b);
    }
  }
  return {positions, indices, inside: p => p[0] > -wide && p[0] < 6 + wide && distanceToLine(p, centre) < wide};
}

function distanceToLine(p, centre) {
  let least = Infinity;
  for (let i = 0; i <= 6000; ++i) {
    const c = centre(6 * i / 6000);
    least = Math.min(least, Math.hypot(p[0] - c[0], p[1] - c[1], p[2] - c[2]));
  }
  return least;
}

test('the nearest place is the one that looking at every triangle finds', () => {
  const {positions, indices} = pipe(0.3), tree = new TriangleTree(positions, indices), next = random(1);
  for (let i = 0; i < 200; ++i) {
    const p = [8 * next() - 1, 2 * next() - 1, 6 * next() - 3];
    let least = Infinity;
    for (let t = 0; t < indices.length / 3; ++t) least = Math.min(least, new TriangleTree(positions, indices.slice(3 * t, 3 * t + 3)).nearest(p).distance);
    const {distance, point} = tree.nearest(p);
    assert.ok(Math.abs(distance - least) < 1e-12);
    assert.ok(Math.abs(Math.hypot(...p.map((x, k) => x - point[k])) - least) < 1e-12);
  }
});

test('within and without are told apart', () => {
  const {positions, indices, inside} = pipe(0.3), tree = new TriangleTree(positions, indices), next = random(5);
  let within = 0;
  for (let i = 0; i < 300; ++i) {
    const p = [8 * next() - 1, 0.8 * next() - 0.4, 6 * next() - 3], far = tree.nearest(p).distance > 0.02;   // the pipe is not quite round
    if (far && p[0] > 0.02 && p[0] < 5.98) assert.equal(Math.abs(tree.winding(p)) > 0.5, inside(p), String(p));
    within += inside(p) ? 1 : 0;
  }
  assert.ok(within > 10);
});

test('a tree without triangles is infinitely far away', () => assert.equal(new TriangleTree([], []).nearest([0, 0, 0]).distance, Infinity));

/// 4,000 steps, some as long as the whole pipe, never come nearer than the body is wide, nor out.
function wander(move, seed) {
  const {positions, indices, inside} = pipe(0.3), tree = new TriangleTree(positions, indices), next = random(seed), body = 0.1;
  let p = [3, 0, 2 * Math.sin(3)], travelled = 0;
  for (let i = 0; i < 4000; ++i) {
    const far = i % 10 === 0 ? 40 : i % 3 === 0 ? 1 : 0.05, step = [0, 1, 2].map(() => far * (2 * next() - 1));
    const q = move(tree, p, step, body);
    travelled += Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    p = q;
    if (tree.nearest(p).distance < 0.998 * body || (i % 50 === 0 && !inside(p))) return {held: false, travelled};
  }
  return {held: inside(p), travelled};
}

test('walls hold, and one gets about', () => {
  for (const seed of [2, 3, 4]) {
    const {held, travelled} = wander(glide, seed);
    assert.ok(held);
    assert.ok(travelled > 50, `${travelled} mm`);
  }
});

test('this would be noticed: moving without looking', () => {
  assert.equal(wander((tree, p, step) => p.map((x, k) => x + step[k]), 2).held, false);
});

test('one slides along a wall instead of sticking to it', () => {
  const {positions, indices} = pipe(0.3), tree = new TriangleTree(positions, indices);
  let p = [0.5, 0, 2 * Math.sin(0.5)];
  for (let i = 0; i < 2000; ++i) p = glide(tree, p, [0.01, 0, 0], 0.1);   // always to +x, against the pipe's bends
  assert.ok(p[0] > 1.5, `came to x = ${p[0]}`);
});

test('where the ball does not fit it stays', () => {
  const {positions, indices} = pipe(0.3), tree = new TriangleTree(positions, indices);
  assert.deepEqual(glide(tree, [3, 0.28, 2 * Math.sin(3)], [1, 0, 0], 0.1), [3, 0.28, 2 * Math.sin(3)]);
});

/// The box from `low` to `high`, with 24 vertices, as drawing wants it.
function box(low, high) {
  const positions = [], indices = [];
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [0, 1]) {
      const first = positions.length / 3, [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      for (const [a, b] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
        const corner = [];
        corner[axis] = [low, high][side][axis];
        corner[u] = [low, high][a][u];
        corner[v] = [low, high][b][v];
        positions.push(...corner);
      }
      indices.push(...(side ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]).map(i => first + i));
    }
  return {positions, indices};
}
const joined = (...surfaces) => surfaces.reduce((all, {positions, indices}) => ({
  positions: [...all.positions, ...positions], indices: [...all.indices, ...indices.map(i => i + all.positions.length / 3)],
}), {positions: [], indices: []});
const cut = (surface, plane) => loopsOf({...surface, same: weldedVertices(surface.positions)}, plane);
const flatten = loops => loops.map(loop => loop.map(([x, y]) => [x, y]));   // for planes across z
const areaAt = (surface, z) => regionsOf(flatten(cut(surface, [0, 0, 1, z]).loops)).reduce((sum, region) => sum + areaOf(region), 0);

test('a cut has the area that it must have, hole in solid in hole too', () => {
  const nested = joined(box([0, 0, 0], [4, 4, 4]), box([1, 1, 1], [3, 3, 3]), box([1.5, 1.5, 1.5], [2.5, 2.5, 2.5]), box([6, 0, 0], [7, 2, 4]));
  for (const [z, area] of [[-1, 0], [0.5, 16 + 2], [1.2, 12 + 2], [2, 13 + 2], [5, 0]]) assert.ok(Math.abs(areaAt(nested, z) - area) < 1e-12, `${areaAt(nested, z)} at ${z}`);
  assert.equal(cut(nested, [0, 0, 1, 2]).joined, 0);
});

test('a plane through vertices, edges and faces is a cut like any other', () => {
  for (const z of [0, 1, 4]) assert.ok([0, 12, 16].some(area => Math.abs(areaAt(joined(box([0, 0, 0], [4, 4, 4]), box([1, 1, 0], [3, 3, 1])), z) - area) < 1e-12), String(z));
});

test('a vertex in the plane counts as above it, as in every section that the program makes', () => {
  const cube = box([0, 0, 0], [4, 4, 4]);
  assert.deepEqual([0, 4].map(z => areaAt(cube, z)), [0, 16]);
});

test('a bent pipe is cut into rings', () => {
  const surface = pipe(0.3), {loops, joined: gaps} = cut(surface, [0, 0, 1, 0]);   // its middle line crosses z = 0 at x = 0 and pi
  assert.equal(gaps, 0);
  assert.equal(loops.length, 2);
});

test('gaps and wrongly turned triangles leave no streaks: the cut is off by no more than the gaps', () => {
  const surface = pipe(0.3), next = random(7), whole = areaAt(surface, 0.5);
  const holed = {positions: surface.positions, indices: []};
  for (let i = 0; i < surface.indices.length; i += 3) {
    const [a, b, c] = surface.indices.slice(i, i + 3), lot = next();
    if (lot > 0.06) holed.indices.push(...(lot > 0.5 ? [a, b, c] : [a, c, b]));
  }
  const {joined: gaps} = cut(holed, [0, 0, 1, 0.5]);
  assert.ok(gaps > 2, `${gaps} gaps`);
  assert.ok(Math.abs(areaAt(holed, 0.5) / whole - 1) < 0.05, `${areaAt(holed, 0.5)} of ${whole}`);
});

test('a slow machine draws more simply while things move, one step at a time, and does not try again for ever', () => {
  const quality = new Quality(), frames = (count, seconds) => { for (let i = 0; i < count; ++i) quality.note(seconds); };
  frames(4, 0.1);
  frames(1, 0.02);
  frames(4, 0.1);
  assert.deepEqual(quality.moving, {layers: true, shade: true}, 'one quick frame forgives four slow ones');
  frames(1, 0.1);
  assert.deepEqual(quality.moving, {layers: true, shade: false});
  frames(5, 0.1);
  assert.deepEqual(quality.moving, {layers: false, shade: false});
  frames(50, 0.1);
  assert.deepEqual([quality.moving, quality.still, quality.reduced], [{layers: false, shade: false}, {layers: true, shade: true}, true]);
  frames(1000, 0.033);
  assert.equal(quality.level, 0, '30 frames a second are neither slow nor a reason for more');
  for (let k = 0; k < 10; ++k) {
    frames(120, 0.016);
    if (quality.level === 1) frames(5, 0.1);
  }
  assert.equal(quality.level, 0);
  assert.equal(new Quality({software: true}).level, 0);
});
