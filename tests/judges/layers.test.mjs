// The page's picture, pixel by pixel, against what rays say lies there.
import assert from 'node:assert/strict';
import {after, test} from 'node:test';
import {browser, made, needPackages, odontoscope, openedIn, pageOrSkip} from './support.mjs';

needPackages();
const chromium = await browser();
after(() => chromium.close());
pageOrSkip('--triangles', '6000', '-o', 'layers.html');
const {page, watched} = await opened('layers.html');

async function opened(name) {
  const window = await openedIn(chromium, made(name), {size: {width: 680, height: 240}});
  await window.page.evaluate(prepare);
  return window;
}

/// What is on a ray, found by looking at every triangle; and the light of one thing on it alone, drawn between two planes of its own.
function prepare() {
  const {renderer} = viewer, V = viewer.bounds.centre.constructor;
  globalThis.Vector = V;

  globalThis.lightAt = (camera, {x, y}, way, complete = true) => {
    const {layers} = viewer.picture, gl = renderer.getContext(), rgba = new Float32Array(4);
    viewer.picture.draw(viewer.scene, camera, viewer.current, {...viewer.wayOf(way), complete});
    renderer.setRenderTarget(layers.sum);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.FLOAT, rgba);
    renderer.setRenderTarget(null);
    return [...rgba];
  };

  const corners = new Map();
  /// Nine numbers a triangle.
  const cornersOf = geometry => {
    if (!corners.has(geometry)) corners.set(geometry, Float64Array.from([...geometry.index.array].flatMap(v => [0, 1, 2].map(k => geometry.attributes.position.array[3 * v + k]))));
    return corners.get(geometry);
  };

  /// Distances along the camera's axis, nearest first, up to the first that nothing is seen through.
  globalThis.hitsAt = (camera, {x, y}) => {
    const {width, height} = viewer.canvas, eye = camera.position.toArray();
    const way = new V(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1, 0).unproject(camera).sub(camera.position).normalize();
    const [wx, wy, wz] = way.toArray(), axis = way.dot(camera.getWorldDirection(new V())), plane = viewer.section.plane(), hits = [];
    for (const {shown, seen, key, clear, geometries} of viewer.current.drawn) {
      if (!seen) continue;
      const body = !geometries && viewer.looks.get(key).as_body, t = cornersOf(shown.geometry);
      for (let i = 0; i < t.length; i += 9) {
        const ax = t[i + 3] - t[i], ay = t[i + 4] - t[i + 1], az = t[i + 5] - t[i + 2], bx = t[i + 6] - t[i], by = t[i + 7] - t[i + 1], bz = t[i + 8] - t[i + 2];
        const nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx, slope = nx * wx + ny * wy + nz * wz;
        if (slope === 0 || (viewer.faces === 'cull' && (slope < 0) === body)) continue;
        const ox = eye[0] - t[i], oy = eye[1] - t[i + 1], oz = eye[2] - t[i + 2], far = -(ox * nx + oy * ny + oz * nz) / slope;
        if (far <= 0) continue;
        const px = ox + far * wx, py = oy + far * wy, pz = oz + far * wz, area = nx * nx + ny * ny + nz * nz;
        const u = ((py * bz - pz * by) * nx + (pz * bx - px * bz) * ny + (px * by - py * bx) * nz) / area;
        const v = ((ay * pz - az * py) * nx + (az * px - ax * pz) * ny + (ax * py - ay * px) * nz) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        if (plane && !geometries && plane.x * (eye[0] + far * wx) + plane.y * (eye[1] + far * wy) + plane.z * (eye[2] + far * wz) > plane.w) continue;
        hits.push({deep: far * axis, clear, key, cap: Boolean(geometries)});
      }
    }
    hits.sort((p, q) => p.deep - q.deep);
    const last = hits.findIndex(hit => !hit.clear);
    return last < 0 ? hits : hits.slice(0, last + 1);
  };

  /// Pixels whose rays meet so many `layers` or more, well apart: {place, hits}, no more than `count`.
  globalThis.pixelsWithLayers = (camera, count, layers) => {
    const {width, height} = viewer.canvas, found = [];
    for (let k = 0; k < 6000 && found.length < count; ++k) {
      const place = {x: Math.floor(width * (0.2 + 0.6 * ((0.5 + k * 0.7548776662) % 1))), y: Math.floor(height * (0.1 + 0.8 * ((0.5 + k * 0.5698402910) % 1)))};
      const hits = hitsAt(camera, place);
      if (hits.length < layers || !hits.every((hit, i) => i === 0 || hit.deep - hits[i - 1].deep > 0.05)) continue;
      // Where the neighbours meet the same things the pixel lies on no edge.
      const alike = [[-1, 0], [1, 0], [0, -1], [0, 1]].every(([dx, dy]) => {
        const there = hitsAt(camera, {x: place.x + dx, y: place.y + dy});
        return there.length === hits.length && there.every((hit, i) => hit.key === hits[i].key && Math.abs(hit.deep - hits[i].deep) < 0.3);
      });
      if (alike) found.push({place, hits});
    }
    return found;
  };

  /// The light at these pixels, as drawn and as computed from each thing's own, and how many things there are.
  globalThis.compared = (camera, count, layers = 3) => pixelsWithLayers(camera, count, layers).map(({place, hits}) => {
    const way = {layers: true, shade: false}, drawn = lightAt(camera, place, way), nearest = lightAt(camera, place, {layers: false, shade: false});
    const sum = [0, 0, 0, 0];
    viewer.picture.layers.counter.limit = 3;   // one thing alone needs no more
    hits.forEach(({deep}, i) => {
      const between = camera.clone();
      between.near = i > 0 ? 0.5 * (deep + hits[i - 1].deep) : Math.max(0.5 * deep, deep - 1);
      between.far = i + 1 < hits.length ? 0.5 * (deep + hits[i + 1].deep) : deep + 0.02;
      between.updateProjectionMatrix();
      const alone = lightAt(between, place, way, false), through = 1 - sum[3];
      for (let k = 0; k < 4; ++k) sum[k] += through * alone[k];
    });
    const off = other => Math.max(...sum.map((x, k) => Math.abs(x - other[k])));
    return {things: hits.map(hit => hit.key + (hit.cap ? ' (cap)' : '')), off: off(drawn), nearest: off(nearest), light: sum};
  });

  globalThis.settled = () => {
    while (viewer.orbit.move) viewer.orbit.update(0.2);
    viewer.orbit.update(0);
    const camera = viewer.orbit.camera.clone();
    camera.updateMatrixWorld();
    return camera;
  };

  /// In the pulp chamber, where the first tour is soon after its start.
  globalThis.within = () => {
    const camera = settled();
    camera.position.copy(viewer.tours[0].place(0));
    camera.near = 0.02;
    camera.fov = 70;
    camera.lookAt(camera.position.clone().add(new V(0.3, 1, 0.2)));
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  };
}

function allMatch(pixels, what) {
  assert.ok(pixels.length >= 3, `${what}: only ${pixels.length} pixels`);
  for (const {off, things, light} of pixels) assert.ok(off < 0.004, `${what}: off by ${off} of ${light} at ${things}`);
}

test('from outside every layer is there, in its order', async () => {
  const pixels = await page.evaluate(() => compared(settled(), 4));
  allMatch(pixels, 'outside');
  assert.ok(pixels.some(({things}) => things.includes('enamel') && things.includes('dentine') && things.includes('pulp')), JSON.stringify(pixels));
});

test('this would be noticed: of each structure only what is nearest', async () => {
  const pixels = await page.evaluate(() => { viewer.setLook('pulp', {opacity: 0.4}); const made = compared(settled(), 4); viewer.setLook('pulp', {opacity: 1}); return made; });
  allMatch(pixels, 'a pulp that is seen through');
  assert.ok(pixels.some(({nearest}) => nearest > 0.02), JSON.stringify(pixels));
});

test('seen from both sides', async () => {
  // Where two structures touch, two faces lie in one place: those pixels are not looked at.
  const pixels = await page.evaluate(() => { viewer.setFaces('show'); const made = compared(settled(), 4); viewer.setFaces('cull'); return made; });
  allMatch(pixels, 'both sides');
});

test('cut open, with caps that are seen through', async () => {
  const pixels = await page.evaluate(() => {
    viewer.cut({on: true, at: 0.8});
    for (const key of ['enamel', 'dentine', 'pulp']) viewer.setLook(key, {opacity: 0.15});
    const made = compared(settled(), 6);
    for (const [key, opacity] of [['enamel', 0.22], ['dentine', 0.36], ['pulp', 1]]) viewer.setLook(key, {opacity});
    viewer.cut({on: false});
    return made;
  });
  allMatch(pixels, 'cut');
  assert.ok(pixels.some(({things}) => things.some(thing => thing.includes('(cap)'))), JSON.stringify(pixels));
});

test('from within the pulp: the walls of the chamber, and enamel behind them', async () => {
  const pixels = await page.evaluate(() => compared(within(), 3, 2));
  allMatch(pixels, 'within');
  assert.ok(pixels.every(({things}) => things[0] === 'dentine cavity' && things.at(-1) === 'enamel'), JSON.stringify(pixels));
});

test('from within the pulp, seen from both sides', async () => {
  odontoscope('sample', 'molar', '--apart', '-o', 'apart.json');   // where walls are shared, a ray meets two faces in one place
  pageOrSkip('apart.json', '--triangles', '6000', '-o', 'apart.html');
  const apart = await opened('apart.html'), pixels = await apart.page.evaluate(() => {
    viewer.setFaces('show');
    viewer.setLook('pulp', {opacity: 0.3});
    return compared(within(), 3);
  });
  allMatch(pixels, 'within, from both sides');
  assert.deepEqual(apart.watched, []);
  await apart.page.close();
});

test('hollows are darker, nothing is lighter, and it can be switched off', async () => {
  const seen = await page.evaluate(() => {
    for (const key of viewer.looks.keys()) viewer.setLook(key, {opacity: 1});
    viewer.look('occlusal');
    const camera = settled(), {width, height} = viewer.canvas, gl = viewer.renderer.getContext();
    const light = shade => {
      viewer.setShade(shade);
      const values = new Float32Array(4 * width * height);
      viewer.picture.draw(viewer.scene, camera, viewer.current, viewer.wayOf({layers: true, shade: true}));
      viewer.renderer.setRenderTarget(viewer.picture.layers.sum);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, values);
      viewer.renderer.setRenderTarget(null);
      return values;
    };
    const off = light(false), on = light(true), result = {covered: 0, darker: 0, lighter: 0, muchDarker: 0};
    for (let i = 0; i < on.length; i += 4) {
      if (off[i + 3] < 0.5) continue;
      result.covered += 1;
      const part = on[i + 1] / off[i + 1];
      if (part < 0.97) result.darker += 1;
      if (part < 0.75) result.muchDarker += 1;
      if (part > 1.003) result.lighter += 1;
    }
    return result;
  });
  assert.ok(seen.covered > 10_000 && seen.lighter === 0, JSON.stringify(seen));
  assert.ok(seen.darker > 0.05 * seen.covered && seen.muchDarker > 50 && seen.muchDarker < 0.3 * seen.covered, JSON.stringify(seen));
});

test('a picture that rests is made finer, and then rests', async () => {
  const drawn = await page.evaluate(async () => {
    viewer.picture.mostSamples = 3;
    viewer.touch();
    const next = () => new Promise(done => requestAnimationFrame(done)), counts = [];
    const until = performance.now() + 40_000;
    for (let idle = 0; idle < 10 && performance.now() < until;) {
      const before = viewer.picture.samples;
      await next();
      counts.push(viewer.picture.samples);
      idle = viewer.picture.samples === before && before === 3 ? idle + 1 : 0;
    }
    viewer.picture.mostSamples = 0;
    return counts;
  });
  assert.equal(Math.max(...drawn), 3);
  assert.equal(drawn.at(-1), 3);
  assert.deepEqual(watched, []);
});
