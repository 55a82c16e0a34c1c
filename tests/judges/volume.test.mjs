// The grey values in the page, pixel by pixel, against the desktop's picture of the same scene; and its film of a model against rays through every triangle.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {after, test} from 'node:test';
import {inflateSync} from 'node:zlib';
import {browser, folder, made, needPackages, odontoscope, openedIn, pageOrSkip} from './support.mjs';

needPackages();

/// A tooth of three greys with a hollow, different along each axis.
const size = [36, 32, 44], spacing = [0.25, 0.28, 0.22];
function writeVolume(name) {
  const values = new Uint8Array(size[0] * size[1] * size[2]), edge = (a, b, x) => 1 / (1 + Math.exp((x - 1) * 14));
  for (let k = 0, at = 0; k < size[2]; ++k)
    for (let j = 0; j < size[1]; ++j)
      for (let i = 0; i < size[0]; ++i, ++at) {
        const [x, y, z] = [i - 17, j - 15.4, k - 21].map((v, axis) => v * spacing[axis]);
        const body = edge(0, 1, Math.hypot(x / 3.1, y / 2.6, z / 4)), crown = edge(0, 1, Math.hypot(x / 3, y / 2.7, (z - 2.2) / 1.5)), hollow = edge(0, 1, Math.hypot((x - 0.5) / 1, y / 0.8, (z + 0.4) / 2.2));
        values[at] = Math.round(40 + 120 * body + 70 * body * crown - 135 * hollow * body + 4 * Math.sin(i + 2 * j + 3 * k));
      }
  writeFileSync(made(name), Buffer.concat([Buffer.from(`NRRD0004\ntype: uint8\ndimension: 3\nsizes: ${size.join(' ')}\nspacings: ${spacing.join(' ')}\nencoding: raw\n\n`), values]));
}
writeVolume('ct.nrrd');
pageOrSkip('ct.nrrd', '--iso', '100', '--show', 'both', '-o', 'both.html');
odontoscope('web', 'ct.nrrd', '--iso', '100', '-o', 'model.html');
odontoscope('web', 'ct.nrrd', '--show', 'volume', '--cast', 'maximum', '-o', 'alone.html');

const chromium = await browser();
after(() => chromium.close());
const {page, watched} = await openedIn(chromium, made('both.html'), {size: {width: 560, height: 200}});
await page.evaluate(() => {
  viewer.renderer.setAnimationLoop(null);
  /// As a screen shows it before black: the shoulder and the sRGB curve of shaders/tone.glsl, exactly.
  const shown = light => {
    const soft = light > 0.78 ? 0.78 + 0.22 * (1 - Math.exp(-(light - 0.78) / 0.22)) : light;
    return 255 * (soft <= 0.0031308 ? 12.92 * soft : 1.055 * soft ** (1 / 2.4) - 0.055);
  };
  globalThis.seen = () => {
    while (viewer.orbit.move) viewer.orbit.update(0.2);
    viewer.orbit.update(0);
    const {width, height} = viewer.canvas, gl = viewer.renderer.getContext(), light = new Float32Array(4 * width * height), {layers} = viewer.picture;
    viewer.picture.draw(viewer.scene, viewer.camera, viewer.current, {...viewer.wayOf({layers: true, shade: false}), complete: true});
    viewer.renderer.setRenderTarget(layers.sum);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, light);
    viewer.renderer.setRenderTarget(null);
    return {width, height, shown: Array.from(light, shown)};
  };
  /// The same for the desktop, as a scene file has it.
  globalThis.told = () => {
    const {orbit, volume, section} = viewer, plane = section.plane(), camera = orbit.camera;
    return {
      format: 'odontoscope.scene', version: 1, volume: volume.look, ambient_occlusion: {on: false}, background: {kind: 'plain', top: '#000000', bottom: '#000000'},
      camera: {projection: 'perspective', position: camera.position.toArray(), target: orbit.controls.target.toArray(), up: [0, 0, 1], field_of_view_deg: camera.fov, height_mm: 25},
      structures: [...viewer.looks.values()].map(({structure, colour, opacity, visible, as_body}) => ({name: structure, colour, opacity, visible, as_body})),
      ...(plane ? {section: {point: [plane.x * plane.w, plane.y * plane.w, plane.z * plane.w], normal: [plane.x, plane.y, plane.z]}} : {}),
    };
  };
});

/// Rows of RGB or RGBA bytes from the top, of a PNG as ours are: eight bits, not interlaced.
function pixelsOf(png) {
  let at = 8, width = 0, height = 0, channels = 0;
  const parts = [];
  while (at < png.length) {
    const length = png.readUInt32BE(at), kind = png.toString('latin1', at + 4, at + 8), body = png.subarray(at + 8, at + 8 + length);
    if (kind === 'IHDR') [width, height, channels] = [body.readUInt32BE(0), body.readUInt32BE(4), {2: 3, 6: 4}[body[9]]];
    if (kind === 'IDAT') parts.push(body);
    at += 12 + length;
  }
  const raw = inflateSync(Buffer.concat(parts)), row = width * channels, pixels = Buffer.alloc(row * height);
  const nearest = (a, b, c) => { const p = a + b - c, [da, db, dc] = [a, b, c].map(x => Math.abs(p - x)); return da <= db && da <= dc ? a : db <= dc ? b : c; };
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < row; ++x) {
      const a = x >= channels ? pixels[y * row + x - channels] : 0, b = y > 0 ? pixels[(y - 1) * row + x] : 0, c = x >= channels && y > 0 ? pixels[(y - 1) * row + x - channels] : 0;
      pixels[y * row + x] = raw[y * (row + 1) + 1 + x] + [0, a, b, (a + b) >> 1, nearest(a, b, c)][raw[y * (row + 1)]];
    }
  return {width, height, channels, pixels};
}

/// How far the page is off the desktop: the worst of 255, how many pixels are more than two off, and how many are not black.
async function compared(change) {
  const {drawn, scene} = await page.evaluate(change => {
    viewer.setVolume(change.volume ?? {});
    viewer.section.put(null);
    if (change.cut) viewer.cut({on: true, at: 0.6});
    viewer.dress();
    return {drawn: seen(), scene: told()};
  }, change);
  writeFileSync(made('page.scene.json'), JSON.stringify(scene));
  odontoscope('render', 'ct.nrrd', '--iso', '100', '--scene', 'page.scene.json', '--show', scene.volume.shows, '--samples', '1', '--size', `${drawn.width}x${drawn.height}`, '-o', 'desktop.png');
  const {pixels, channels, width, height} = pixelsOf(readFileSync(made('desktop.png')));
  assert.deepEqual([width, height], [drawn.width, drawn.height]);
  const judged = {worst: 0, off: 0, lit: 0};
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const here = [0, 1, 2].map(k => [pixels[(y * width + x) * channels + k], drawn.shown[4 * ((height - 1 - y) * width + x) + k]]);
      const worst = Math.max(...here.map(([desktop, own]) => Math.abs(desktop - own)));
      judged.worst = Math.max(judged.worst, worst);
      if (worst > 2) judged.off += 1;
      if (here.some(([desktop]) => desktop > 20)) judged.lit += 1;
    }
  return judged;
}

const shaded = {shows: 'volume', cast: 'shaded', lit: true, slopes: [0, 0]}, unlit = {...shaded, lit: false};
for (const [what, change] of [
  ['unlit', {volume: unlit}],
  ['its greatest values', {volume: {shows: 'volume', cast: 'maximum', window: [40, 230]}}],
  ['its average', {volume: {shows: 'volume', cast: 'average', window: [40, 160]}, cut: true}],
  ['an X-ray of it', {volume: {shows: 'volume', cast: 'radiograph', window: [40, 160], attenuation: 0.23, latitude: 2}}],
])
  test(`the volume is the desktop's within two levels: ${what}`, async () => {
    const judged = await compared(change);
    assert.ok(judged.lit > 4000, JSON.stringify(judged));
    assert.ok(judged.worst <= 2, JSON.stringify(judged));
  });

// A browser interpolates between values more coarsely, which tells where they are cut and where their slope is nearly none; on an edge rounding decides.
for (const [what, change] of [
  ['unlit and cut open', {volume: unlit, cut: true}],
  ['lit', {volume: shaded}],
  ['lit and cut open', {volume: shaded, cut: true}],
  ['its borders only', {volume: {...unlit, slopes: [20, 160]}}],
  ['surfaces within it', {volume: {...unlit, shows: 'both'}}],
  ['the raw surface of one value', {volume: {shows: 'volume', cast: 'surface', iso: 150}}],
])
  test(`nearly everywhere the picture is the desktop's within two levels: ${what}`, async () => {
    const judged = await compared(change);
    assert.ok(judged.lit > 4000 && judged.off < 0.04 * judged.lit, JSON.stringify(judged));
  });

test('this would be noticed: a step of a value aside, and surfaces left out', async () => {
  const aside = await page.evaluate(() => { viewer.volume.ray.first.x += 0.25; return viewer.volume.ray.first.x; });
  assert.ok(Number.isFinite(aside) && (await compared({volume: shaded})).worst > 8);
  await page.evaluate(() => { viewer.volume.ray.first.x -= 0.25; Object.defineProperty(viewer.volume, 'showsSurfaces', {value: false, configurable: true}); });
  const {off, lit} = await compared({volume: {...shaded, shows: 'both'}});
  assert.ok(off > 0.1 * lit);
  await page.evaluate(() => { delete viewer.volume.showsSurfaces; });
});

test('a volume alone has no word about surfaces; the page is told to be still and asks for nothing', async () => {
  const alone = await openedIn(chromium, made('alone.html'), {size: {width: 560, height: 200}});
  const told = await alone.page.evaluate(() => ({
    cast: viewer.volume.look.cast, structures: document.getElementById('controls').textContent.includes('Structures'), size: viewer.volume.told.size, controls: document.querySelector('#volume-controls h2').textContent,
  }));
  assert.deepEqual({...told, size: null}, {cast: 'maximum', structures: false, size: null, controls: 'Volume'});
  assert.ok(told.size.every((count, axis) => count > 10 && count <= size[axis]), told.size.join());
  assert.deepEqual(alone.watched, []);
  assert.deepEqual(watched, []);
  await alone.close();
});

/// Gives a page rayThroughModel(n): the nth of rays strewn over the middle of the picture, by its pixel and its way from the camera, and all its hits on the
/// first model, [distance, 1 where it enters and -1 where it leaves]. Every triangle is asked. The camera's matrices are to be up to date.
const giveRays = page => page.evaluate(() => {
  window.rayThroughModel = n => {
    const {width, height} = viewer.canvas, camera = viewer.camera, V = viewer.bounds.centre.constructor, hits = [];
    const x = Math.floor(width * (0.35 + 0.3 * ((0.5 + n * 0.7548776662) % 1))), y = Math.floor(height * ((0.5 + n * 0.5698402910) % 1));
    const way = new V(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1, 0).unproject(camera).sub(camera.position).normalize();
    for (const {geometry} of viewer.models[0].parts) {
      const p = geometry.attributes.position, index = geometry.index.array, [a, u, v, s] = [0, 0, 0, 0].map(() => new V());
      for (let i = 0; i < index.length; i += 3) {
        a.fromBufferAttribute(p, index[i]);
        u.fromBufferAttribute(p, index[i + 1]).sub(a);
        v.fromBufferAttribute(p, index[i + 2]).sub(a);
        s.copy(camera.position).sub(a);
        const det = u.dot(new V().crossVectors(way, v)), q = new V().crossVectors(s, u), b = s.dot(new V().crossVectors(way, v)) / det, c = way.dot(q) / det;
        if (b >= 0 && c >= 0 && b + c <= 1) hits.push([v.dot(q) / det, Math.sign(det)]);
      }
    }
    return {x, y, way, hits};
  };
});

test('the film of a model is the length of each ray inside it, times what its tissue swallows', async () => {
  const {page, watched, close} = await openedIn(chromium, made('model.html'), {size: {width: 560, height: 200}});
  await giveRays(page);
  const judged = await page.evaluate(() => {
    viewer.renderer.setAnimationLoop(null);
    viewer.setFilm(true);
    viewer.swingTube(20);
    viewer.orbit.update(0);
    const {width, height} = viewer.canvas, camera = viewer.camera, gl = viewer.renderer.getContext();
    viewer.draw();
    const sums = new Float32Array(4 * width * height);
    viewer.renderer.setRenderTarget(viewer.shadow.sums);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, sums);
    viewer.renderer.setRenderTarget(null);
    camera.updateMatrixWorld();
    const judged = {worst: 0, most: 0, rays: 0}, mu = viewer.looks.get('tooth').attenuation;
    for (let n = 0; n < 60; ++n) {
      const {x, y, hits} = rayThroughModel(n);
      let sum = 0;
      for (const [distance, sign] of hits) sum -= sign * distance;
      judged.rays += 1;
      judged.most = Math.max(judged.most, mu * sum);
      judged.worst = Math.max(judged.worst, Math.abs(mu * sum - sums[4 * (y * width + x)]));
    }
    return judged;
  });
  assert.ok(judged.most > 0.5, JSON.stringify(judged));
  assert.ok(judged.worst < 4 / 255, JSON.stringify(judged));   // one level of a film that shows an attenuation of 4 white
  assert.deepEqual(watched, []);
  await close();
});

test('the film is cut by a section: rays count only where they run through what is left', async () => {
  const {page, watched, close} = await openedIn(chromium, made('model.html'), {size: {width: 560, height: 200}});
  await giveRays(page);
  for (const side of ['mesial', 'buccal', 'occlusal']) {
    const judged = await page.evaluate(side => {
      viewer.renderer.setAnimationLoop(null);
      viewer.setFilm(true);
      viewer.cut({on: true, side, at: 0.3});
      viewer.swingTube(20);
      viewer.orbit.update(0);
      const {width, height} = viewer.canvas, camera = viewer.camera, V = viewer.bounds.centre.constructor, gl = viewer.renderer.getContext(), light = new Float32Array(4 * width * height);
      viewer.picture.draw(viewer.scene, camera, viewer.current, {...viewer.wayOf({layers: true, shade: false}), complete: true});
      viewer.renderer.setRenderTarget(viewer.picture.layers.sum);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, light);
      viewer.renderer.setRenderTarget(null);
      camera.updateMatrixWorld();
      const shown = l => { const soft = l > 0.78 ? 0.78 + 0.22 * (1 - Math.exp(-(l - 0.78) / 0.22)) : l; return soft <= 0.0031308 ? 12.92 * soft : 1.055 * soft ** (1 / 2.4) - 0.055; };
      const plane = viewer.section.plane(), judged = {worst: 0, most: 0, cut: 0}, mu = viewer.looks.get('tooth').attenuation;
      for (let n = 0; n < 80; ++n) {
        const {x, y, way, hits} = rayThroughModel(n);
        hits.sort(([a], [b]) => a - b);
        const normal = new V(plane.x, plane.y, plane.z), speed = normal.dot(way), pass = (plane.w - normal.dot(camera.position)) / speed;
        const kept = (from, to) => (speed > 0 ? Math.max(0, Math.min(to, pass) - from) : Math.max(0, to - Math.max(from, pass)));
        let sum = 0, whole = 0;
        for (let i = 0, depth = 0; i + 1 < hits.length; ++i) {
          depth += hits[i][1];
          if (depth > 0) { sum += kept(hits[i][0], hits[i + 1][0]); whole += hits[i + 1][0] - hits[i][0]; }
        }
        judged.cut += whole - sum > 0.2 && sum > 0.2 ? 1 : 0;
        judged.most = Math.max(judged.most, mu * sum);
        judged.worst = Math.max(judged.worst, Math.abs(mu * sum - viewer.shadow.latitude * shown(light[4 * (y * width + x)])));
      }
      return judged;
    }, side);
    assert.ok(judged.cut > 3 || side === 'occlusal', JSON.stringify({side, ...judged}));   // nearly along the rays
    assert.ok(judged.worst < 8 / 255, JSON.stringify({side, ...judged}));   // two levels: the film is kept in halves of floats
  }
  assert.deepEqual(watched, []);
  await close();
});

test('beside the film stand the canals\u2019 lengths on it and their own', async () => {
  odontoscope('web', '-o', 'molar.html');
  const {page, watched, close} = await openedIn(chromium, made('molar.html'), {size: {width: 560, height: 400}});
  const told = await page.evaluate(() => {
    viewer.renderer.setAnimationLoop(null);
    viewer.setFilm(true);
    return [0, 35].map(degrees => {
      viewer.swingTube(degrees);
      viewer.orbit.update(0);
      viewer.draw();
      const {camera, bounds: {centre}} = viewer, V = centre.constructor;
      camera.updateMatrixWorld();
      // On the screen: how many parts of the picture's height, and how many millimetres these are at the middle of the tooth.
      const depth = -centre.clone().applyMatrix4(camera.matrixWorldInverse).z, tall = 2 * depth * Math.tan(camera.fov * Math.PI / 360);
      const rows = [...document.querySelectorAll('#film-lengths tbody tr')].map(row => [...row.children].map(cell => cell.textContent));
      return viewer.description.tours.map((tour, index) => {
        const places = tour.points_mm.map(point => new V(...point).project(camera)).map(({x, y}) => [0.5 * x * camera.aspect * tall, 0.5 * y * tall]);
        const film = places.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - places[i][0], y - places[i][1]), 0);
        const own = tour.points_mm.slice(1).reduce((sum, point, i) => sum + new V(...point).distanceTo(new V(...tour.points_mm[i])), 0);
        return {film, own, row: rows[index]};
      });
    });
  });
  for (const {film, own, row} of told.flat()) {
    assert.ok(Math.abs(parseFloat(row[1]) - film) < 0.11, JSON.stringify({film, own, row}));
    assert.ok(Math.abs(parseFloat(row[2]) - own) < 0.11, JSON.stringify({film, own, row}));
  }
  assert.ok(told[0].length >= 3 && told[0].some(({film}, i) => Math.abs(film - told[1][i].film) > 0.1), 'swinging the tube changes what the film shows');
  assert.deepEqual(watched, []);
  await close();
});

test('two places of the film are measured where they are clicked; a film has an edge, and a negative', async () => {
  const {page, watched, close} = await openedIn(chromium, made('model.html'), {size: {width: 900, height: 700}});
  await page.evaluate(() => { viewer.setFilm(true); viewer.swingTube(10); document.getElementById('film-ruler').click(); });
  await page.waitForFunction(() => viewer.picture.finished(viewer.wayOf(viewer.quality.still)));
  const box = await page.locator('canvas').first().boundingBox(), middle = [box.x + 0.5 * box.width, box.y + 0.5 * box.height];
  await page.mouse.click(middle[0] - 60, middle[1] + 20);
  await page.mouse.click(middle[0] + 40, middle[1] - 55);
  const {words, right} = await page.evaluate(([across, down]) => {
    const {camera, bounds: {centre}, canvas} = viewer, depth = -centre.clone().applyMatrix4(camera.matrixWorldInverse).z;
    return {words: document.getElementById('pins').textContent, right: Math.hypot(across, down) * 2 * depth * Math.tan(camera.fov * Math.PI / 360) / canvas.clientHeight};
  }, [100, 75]);
  assert.match(words, /^[0-9.]+ mm on the film$/);
  assert.ok(Math.abs(parseFloat(words) - right) < 0.06, JSON.stringify({words, right}));
  // The film's own sheet, drawn to a target of eight bits: the usual one, a negative, and one with an edge.
  const shown = await page.evaluate(() => {
    viewer.renderer.setAnimationLoop(null);
    const {shadow, renderer, camera, section, canvas} = viewer, gl = renderer.getContext(), {width, height} = canvas, target = shadow.sums.clone();
    target.setSize(width, height);
    const seen = () => {
      renderer.setRenderTarget(target);
      renderer.clear(true, false, false);
      shadow.drawProjection({camera, pixels: new shadow.film.uniforms.pixels.value.constructor(width, height), section: section.plane() ?? shadow.film.uniforms.section.value.clone().set(0, 0, 0, 1)}, target);
      const light = new Float32Array(4 * width * height);
      renderer.setRenderTarget(target);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, light);
      renderer.setRenderTarget(null);
      return [[0.5, 0.5], [0.02, 0.5]].map(([x, y]) => light[4 * (Math.floor(y * height) * width + Math.floor(x * width))]);
    };
    const usual = seen();
    shadow.inverted = true;
    const negative = seen();
    shadow.inverted = false;
    shadow.size = [4, 4];
    return {usual, negative, edged: seen()};
  });
  assert.ok(shown.usual[0] > 0.02 && shown.usual[1] < 0.001, JSON.stringify(shown));      // the tooth, and nothing in the way
  assert.ok(shown.negative[1] > 0.9 && shown.negative[0] < shown.negative[1], JSON.stringify(shown));
  assert.ok(Math.abs(shown.edged[0] - shown.usual[0]) < 1e-3 && Math.abs(shown.edged[1] - ((0.16 + 0.055) / 1.055) ** 2.4) < 1e-3, JSON.stringify(shown));
  assert.deepEqual(watched, []);
  await close();
});

test('the transfer function is edited on the histogram, by hand and by number', async () => {
  const {page, watched, close} = await openedIn(chromium, made('both.html'), {size: {width: 1100, height: 900}});
  await page.evaluate(() => viewer.setVolume({shows: 'volume', cast: 'shaded'}));
  const canvas = page.locator('#volume-controls canvas.histogram'), before = await page.evaluate(() => viewer.volume.look.transfer);
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox(), at = (right, up) => [box.x + right * box.width, box.y + (1 - up) * box.height], {low, high} = await page.evaluate(() => viewer.volume.told);
  await page.mouse.move(...at(0.05, 0.6));
  await page.mouse.down();
  await page.mouse.move(...at(0.1, 0.8));
  await page.mouse.up();
  const after = await page.evaluate(() => viewer.volume.look.transfer);
  assert.equal(after.length, before.length + 1);
  assert.ok(Math.abs(after[0].value - (low + 0.1 * (high - low))) < 0.02 * (high - low), JSON.stringify(after[0]));
  assert.ok(Math.abs(Math.log1p(after[0].extinction) / Math.log1p(60) - 0.8) < 0.03, JSON.stringify(after[0]));
  await page.getByRole('slider', {name: 'Its extinction'}).press('Home');
  assert.equal((await page.evaluate(() => viewer.volume.look.transfer))[0].extinction, 0);
  await page.getByRole('button', {name: 'Remove point'}).click();
  assert.deepEqual((await page.evaluate(() => viewer.volume.look.transfer)).map(point => point.value), before.map(point => point.value));
  assert.deepEqual(watched, []);
  await close();
});

const refusal = (...words) => {
  try {
    odontoscope('web', ...words, '-o', 'refused.html');
  } catch (error) {
    return String(error.stderr);
  }
  return '';
};

test('what makes no sense is refused, and says what to do', () => {
  assert.match(refusal('ct.nrrd', '--show', 'both'), /nothing says where in the volume the surface lies.*--iso/s);
  assert.match(refusal('--show', 'volume'), /only a volume has grey values/);
  assert.match(refusal('ct.nrrd', '--iso', '100', '--transfer', 'pulp'), /--show volume/);
  assert.match(refusal('ct.nrrd', '--show', 'volume', '--db'), /about surfaces/);
});

test('the terminal tells the size of what the page carries, and the same input gives the same bytes', () => {
  const said = execFileSync(process.env.ODONTOSCOPE_PROGRAM, ['web', 'ct.nrrd', '--show', 'volume', '-o', 'again.html'], {cwd: folder, stdio: ['ignore', 'pipe', 'pipe']}).toString();
  assert.match(said, /The page carries \d+ x \d+ x \d+ values of 8 bits: \d+ KB/);
  const first = readFileSync(made('again.html'));
  odontoscope('web', 'ct.nrrd', '--show', 'volume', '-o', 'again.html');
  assert.ok(first.equals(readFileSync(made('again.html'))));
});
