// The page flies a canal as the desktop does: its tours against the cameras of a GLB file, which are the desktop's own. Needs Node.js alone.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import {Way} from '../../web/source/way.js';
import {bytesOf, glbParts, made, odontoscope, pageOrSkip} from './support.mjs';

odontoscope('sample', 'molar', '--slice-spacing', '0.35', '-o', 'molar.json');
pageOrSkip('molar.json', '-o', 'molar.html');
odontoscope('reconstruct', 'molar.json', '--tours', '-o', 'tours.glb');
const html = readFileSync(made('molar.html'), 'utf8');
const {tours, horns} = JSON.parse(/<script type="application\/json" id="description">(.*?)<\/script>/s.exec(html)[1]);

const {json, binary} = glbParts(bytesOf('tours.glb'));
function values(accessor) {
  const {bufferView, byteOffset = 0, count, type} = json.accessors[accessor], view = json.bufferViews[bufferView], width = {SCALAR: 1, VEC3: 3, VEC4: 4}[type];
  const numbers = new Float32Array(binary.slice((view.byteOffset ?? 0) + byteOffset).buffer, 0, width * count);
  return Array.from({length: count}, (_, i) => [...numbers.subarray(width * i, width * (i + 1))]);
}
/// As glTF plays it: {seconds, at, view, up} of each key, in millimetres and the model's axes, which the node above turns.
function keysOf({channels, samplers}) {
  const sampler = path => samplers[channels.find(({target}) => target.path === path).sampler];
  const turned = ([x, y, z, w], [a, b, c]) => {
    const t = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
    return [a + w * t[0] + y * t[2] - z * t[1], b + w * t[1] + z * t[0] - x * t[2], c + w * t[2] + x * t[1] - y * t[0]];
  };
  const places = values(sampler('translation').output), turns = values(sampler('rotation').output);
  return values(sampler('translation').input).map(([seconds], i) => ({seconds, at: places[i].map(x => 1000 * x), view: turned(turns[i], [0, 0, -1]), up: turned(turns[i], [0, 1, 0])}));
}
const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

test('the page has a flight for each of the canals, and none for the horns', () => {
  assert.equal(tours.length, json.animations.length);
  assert.ok(tours.length >= 3);
  assert.ok(tours.every(({keys}) => keys) && horns.every(({keys}) => !keys));
});

test('at every time it stands where the desktop stands, and looks where it looks', () => {
  for (const [i, tour] of tours.entries()) {
    const way = new Way(tour), keys = keysOf(json.animations[i]);
    assert.equal(json.animations[i].name, tour.name);
    assert.ok(Math.abs(way.seconds - keys.at(-1).seconds) < 1e-4);
    assert.ok(keys.length > 50);
    for (const {seconds, at, view, up} of keys) {
      const here = way.atTime(seconds);
      assert.ok(far(here.place, at) < 1e-4, `${tour.name}, ${seconds} s: ${here.place} for ${at}`);
      assert.ok(far(here.direction, view) < 1e-4);
      assert.ok(far(here.up, up) < 1e-4);
    }
  }
});

test('time and length along the line lead to each other', () => {
  for (const tour of tours) {
    const way = new Way(tour);
    assert.equal(way.atTime(0).mm, way.atLength(0).mm);
    assert.ok(Math.abs(way.length - way.atTime(way.seconds).mm) < 1e-9);
    for (let share = 0; share <= 1; share += 0.05) {
      const mm = share * way.length, {place} = way.atTime(way.timeAt(mm));
      assert.ok(Math.abs(way.atTime(way.timeAt(mm)).mm - mm) < 1e-6);
      assert.ok(far(place, way.atLength(mm).place) < 1e-6);
      assert.ok(way.nearest(place).distance < 1e-9);
    }
  }
});

test('a way of points alone goes straight from one to the next', () => {
  const way = new Way({points_mm: [[0, 0, 0], [3, 0, 0], [3, 4, 0]]});
  assert.equal(way.length, 7);
  assert.deepEqual(way.atLength(5).place, [3, 2, 0]);
  assert.deepEqual(way.nearest([4, 2, 0]), {mm: 5, distance: 1});
});
