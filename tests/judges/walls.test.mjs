// The page's walls: nothing passes through them, whatever is asked for. Needs Node.js alone.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {TriangleTree} from '../../web/source/bvh.js';
import {glide} from '../../web/source/walls.js';

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
    for (let t = 0; t < indices.length / 3; ++t) {
      const best = {squared: Infinity};
      tree.nearerOn(t, p, best);
      least = Math.min(least, Math.sqrt(best.squared));
    }
    assert.equal(tree.nearest(p).distance, least);
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
