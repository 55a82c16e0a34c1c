// The page of `odontoscope web` in a browser: what it loads, says, shows and does.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {browser, made, modules, needPackages, odontoscope, openedIn, pageOrSkip, writeBrokenPillar} from './support.mjs';

needPackages();
const chromium = await browser();
after(() => chromium.close());

const hostile = `</title><script>globalThis.bitten=1</script><img src=x onerror="globalThis.bitten=2">'"&`;
pageOrSkip('--triangles', '12000', '--db', '--grid', '24', '--cases', 'classic-unoriented', '-o', 'page.html');

const opened = (file, options) => openedIn(chromium, file, options);

/// How many of the picture's pixels, each 9th in x and y, differ between two looks, and how many are not of the plainest colour.
const helpers = () => {
  globalThis.look = () => {
    viewer.frame(0);
    viewer.draw({way: viewer.quality.moving});
    const canvas = document.createElement('canvas'), {width, height} = viewer.canvas;
    Object.assign(canvas, {width: width / 4, height: height / 4});
    const context = canvas.getContext('2d');
    context.drawImage(viewer.canvas, 0, 0, canvas.width, canvas.height);
    return context.getImageData(0, 0, canvas.width, canvas.height).data;
  };
  globalThis.different = (a, b) => {
    let count = 0;
    for (let i = 0; i < a.length; i += 4) if (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]) > 24) count += 1;
    return 4 * count / a.length;
  };
  /// The share of the picture that an action changes.
  globalThis.changedBy = async action => {
    const before = look();
    await action();
    return different(before, look());
  };
};

const one = await opened(made('page.html'));
await one.page.evaluate(helpers);
after(() => one.close());

test('it loads from disk, asks the network for nothing and complains of nothing', async () => {
  assert.equal(await one.page.title(), 'Sample molar');
  assert.equal(await one.page.textContent('h1'), 'Sample molar');
  assert.match(await one.page.textContent('.verdict'), /ertified/);
  assert.deepEqual(one.watched, []);
  assert.ok(readFileSync(made('page.html')).length > 500_000);
});

test('a request would be stopped, and noticed', async () => {
  const two = await opened(made('page.html'));
  const stopped = await two.page.evaluate(() => fetch('http://example.invalid/').then(() => 'came through', error => error.name));
  assert.equal(stopped, 'TypeError');
  assert.ok(two.watched.some(words => words.includes('Content Security Policy')), two.watched.join('\n'));
  await two.close();
});

test('an amber certificate says so with a sign and words, and its places lead there', async () => {
  writeBrokenPillar('pillar.json');
  odontoscope('web', 'pillar.json', '-o', 'pillar.html');
  const two = await opened(made('pillar.html'));
  assert.match(await two.page.textContent('.verdict'), /^! Amber: certified, but look at 1 place/);
  assert.ok(await two.page.evaluate(() => document.querySelector('.verdict').classList.contains('amber')));
  const place = two.page.locator('.places button');
  assert.match(await place.textContent(), /slices 4 and 5 .*link tooth:4:0-0/);
  const before = await two.page.evaluate(() => viewer.orbit.controls.target.toArray());
  await place.click();
  const after = await two.page.evaluate(() => {
    for (let i = 0; i < 60; ++i) viewer.frame(0.02);
    viewer.draw();
    const ring = document.querySelector('#labels .ring');
    return {target: viewer.orbit.controls.target.toArray(), ring: [ring.style.display, Number(ring.getAttribute('cx')), Number(ring.getAttribute('cy'))], middle: [viewer.canvas.clientWidth / 2, viewer.canvas.clientHeight / 2]};
  });
  for (const [i, at] of [1.25, 0.5, 4.5].entries()) assert.ok(Math.abs(after.target[i] - at) < 1e-6, `${before} to ${after.target}`);
  assert.equal(after.ring[0], '');
  assert.ok(Math.abs(after.ring[1] - after.middle[0]) < 1 && Math.abs(after.ring[2] - after.middle[1]) < 1, JSON.stringify(after));
  await two.close();
});

test('structures, section, faces and method change the picture', async () => {
  const changes = await one.page.evaluate(async () => ({
    nothing: await changedBy(() => {}),
    hidden: await changedBy(() => viewer.setLook('pulp', {visible: false})),
    back: await changedBy(() => viewer.setLook('pulp', {visible: true})),
    clear: await changedBy(() => viewer.setLook('enamel', {opacity: 1})),
    cut: await changedBy(() => viewer.cut({on: true})),
    moved: await changedBy(() => viewer.cut({at: 2})),
    whole: await changedBy(() => { viewer.cut({on: false}); viewer.setLook('enamel', {opacity: 0.22}); }),
    db: await changedBy(() => viewer.show(1)),
    dt: await changedBy(() => viewer.show(0)),
  }));
  assert.equal(changes.nothing, 0);
  for (const what of ['hidden', 'back', 'clear', 'cut', 'moved', 'whole', 'db', 'dt']) assert.ok(changes[what] > 0.004, `${what}: ${changes[what]}`);
  assert.match(await one.page.textContent('.verdict'), /ertified/);
  await one.page.getByRole('button', {name: 'DB', exact: true}).click();
  assert.match(await one.page.textContent('.verdict'), /Found wanting/);
  await one.page.getByRole('button', {name: 'DT', exact: true}).click();
});

test('culling changes nothing of DT and makes holes in DB, whose wrong faces are magenta when tinted', async () => {
  const changes = await one.page.evaluate(async () => {
    const opacities = [['enamel', 0.22], ['dentine', 0.36], ['dentine cavity', 0.36]];
    for (const [key] of opacities) viewer.setLook(key, {opacity: 1});
    const result = {};
    for (const [index, name] of [[0, 'dt'], [1, 'db']]) {
      viewer.show(index);
      viewer.setFaces('show');
      result[name] = {culled: await changedBy(() => viewer.setFaces('cull')), shown: await changedBy(() => viewer.setFaces('show')), tinted: await changedBy(() => viewer.setFaces('tint'))};
    }
    viewer.show(0);
    viewer.setFaces('cull');
    for (const [key, opacity] of opacities) viewer.setLook(key, {opacity});
    return result;
  });
  // But for the outline, where both sides meet in one pixel.
  for (const change of Object.values(changes.dt)) assert.ok(change < 0.008, JSON.stringify(changes.dt));
  for (const change of Object.values(changes.db)) assert.ok(change > 0.04, JSON.stringify(changes.db));
});

test('a cut solid is filled: no face is seen from behind where the plane is looked at squarely', async () => {
  const magenta = await one.page.evaluate(async () => {
    for (const key of ['enamel', 'dentine', 'dentine cavity']) viewer.setLook(key, {opacity: 1});
    viewer.setFaces('tint');
    viewer.cut({on: true, at: 0.5});
    viewer.look('buccal');
    while (viewer.orbit.move) viewer.frame(0.2);
    const count = pixels => {
      let found = 0;
      for (let i = 0; i < pixels.length; i += 4) if (pixels[i] > 120 && pixels[i + 1] < 60 && pixels[i + 2] > 90) found += 1;
      return found;
    };
    const capped = count(look());
    for (const {shown} of viewer.shown[0].caps) shown.material.colorWrite = shown.material.depthWrite = false;
    viewer.touch();
    const open = count(look());
    for (const {shown} of viewer.shown[0].caps) shown.material.colorWrite = shown.material.depthWrite = true;
    viewer.cut({on: false});
    viewer.setFaces('cull');
    for (const [key, opacity] of [['enamel', 0.22], ['dentine', 0.36], ['dentine cavity', 0.36]]) viewer.setLook(key, {opacity});
    return {capped, open};
  });
  assert.ok(magenta.open > 500, `without caps ${magenta.open} pixels would be magenta`);
  assert.ok(magenta.capped < 0.01 * magenta.open, `${magenta.capped} of ${magenta.open} pixels`);
});

test('the keyboard does everything', async () => {
  const {page} = one, state = () => page.evaluate(() => ({
    at: viewer.orbit.camera.position.toArray(), cut: viewer.section.on, faces: viewer.faces, model: viewer.chosen, mode: viewer.journey.mode, playing: viewer.journey.playing,
    help: document.getElementById('help').open, labels: viewer.labels.on,
  }));
  const press = async key => { await page.keyboard.press(key); return state(); };
  await page.focus('#canvas');
  const first = await state();
  assert.notDeepEqual((await press('ArrowLeft')).at, first.at);
  assert.equal((await press('s')).cut, true);
  assert.equal((await press('s')).cut, false);
  assert.equal((await press('b')).faces, 'show');
  await press('b');
  assert.equal((await press('b')).faces, 'cull');
  assert.equal((await press('x')).model, 1);
  assert.equal((await press('x')).model, 0);
  assert.equal((await press('l')).labels, false);
  await press('l');
  const touring = await press('t');
  assert.deepEqual([touring.mode, touring.playing], ['tour', true]);
  assert.equal((await press(' ')).playing, false);
  assert.equal((await press('Escape')).mode, null);
  assert.equal((await press('c')).mode, 'fly');
  assert.equal((await press('2')).mode, 'tour');
  assert.equal((await press('c')).mode, null);
  await press('-');
  const distance = () => page.evaluate(() => viewer.orbit.camera.position.distanceTo(viewer.orbit.controls.target));
  const farther = await distance();
  await page.keyboard.press('f');
  await page.waitForFunction(before => viewer.orbit.camera.position.distanceTo(viewer.orbit.controls.target) < before, farther);
  assert.equal((await press('c')).mode, 'fly');
  assert.equal((await press('Escape')).mode, null);
  assert.equal((await press('?')).help, true);
  assert.equal((await press('Escape')).help, false);
  // Every control can be reached, and is named.
  const unnamed = await page.evaluate(() => [...document.querySelectorAll('button, input, summary, canvas[tabindex]')].filter(element => element.offsetParent !== null)
    .filter(element => !(element.textContent.trim() || element.getAttribute('aria-label') || element.labels?.[0]?.textContent.trim())).map(element => element.outerHTML));
  assert.deepEqual(unnamed, []);
});

test('a tour plays, can be moved by its slider, and stays within the walls', async () => {
  const {page} = one;
  await page.getByRole('button', {name: /distal canal/}).click();
  const from = await page.evaluate(() => viewer.journey.mm);
  await page.waitForFunction(before => viewer.journey.mm > before, from);
  const tour = await page.evaluate(async () => {
    viewer.play(false);
    const {journey} = viewer, length = journey.tour.length, rooms = [];
    for (let i = 0; i <= 50; ++i) {
      viewer.seek(length * i / 50);
      rooms.push(journey.room());
    }
    const slider = document.querySelector('#bar input');
    slider.value = length / 2;
    slider.dispatchEvent(new Event('input'));
    const middle = journey.mm, changed = await changedBy(() => viewer.seek(0.1 * length));
    viewer.leave();
    return {length, least: Math.min(...rooms.slice(0, 48)), middle, changed, mode: journey.mode};
  });
  assert.ok(tour.length > 10 && tour.length < 22, `${tour.length} mm`);
  assert.ok(tour.least > 0.02, `comes to ${tour.least} mm from the wall`);
  assert.ok(Math.abs(tour.middle - tour.length / 2) < 0.01);
  assert.ok(tour.changed > 0.05, `${tour.changed}`);
  assert.equal(tour.mode, null);
});

test('inside, the wall tells by colour how far it is to the outside, or how deep it lies', async () => {
  const {page} = one;
  const found = await page.evaluate(() => {
    viewer.startTour(0);
    viewer.play(false);
    viewer.seek(0.3 * viewer.journey.tour.length);
    const parts = viewer.models[0].parts, cavity = parts.find(part => part.kind === 'cavity'), outside = parts.find(part => part.structure === cavity.structure && part.kind !== 'cavity');
    const colours = () => cavity.geometry.getAttribute('wall_depth').array, depth = [...colours()], before = look();
    viewer.setWallThickness(true);
    const shown = different(before, look()), thickness = [...colours()], boxes = [viewer.wallDepth, viewer.wallThickness];
    // By hand, at some places: to the nearest corner of the outside, which is near enough where corners are many.
    const p = cavity.geometry.getAttribute('position'), q = outside.geometry.getAttribute('position');
    const off = [];
    for (let v = 0; v < p.count; v += Math.floor(p.count / 60)) {
      let nearest = Infinity;
      for (let w = 0; w < q.count; ++w) nearest = Math.min(nearest, Math.hypot(p.getX(v) - q.getX(w), p.getY(v) - q.getY(w), p.getZ(v) - q.getZ(w)));
      off.push(nearest - (15 - thickness[v]) * 0.2);
    }
    const numbers = [...document.querySelectorAll('#cues .number')].filter(e => e.style.display !== 'none').length;
    viewer.setWallThickness(false);
    viewer.setWallDepth(true);
    const back = [...colours()];
    viewer.leave();
    return {shown, off, boxes, numbers, same: back.every((value, i) => value === depth[i]), thinnest: 3 - 0.2 * Math.max(...thickness)};
  });
  assert.ok(found.shown > 0.1, `${found.shown}`);
  assert.deepEqual(found.boxes, [false, true]);
  assert.equal(found.numbers, 0);   // of depths
  assert.ok(found.off.every(off => off > -1e-3 && off < 0.5), found.off.join(' '));
  assert.ok(found.off.filter(off => off < 0.12).length > 0.8 * found.off.length, found.off.join(' '));
  assert.ok(found.thinnest > 0.2 && found.thinnest < 1.5, `${found.thinnest}`);
  assert.ok(found.same);
});

test('walls hold in flight: a minute against them at ten times the speed', async () => {
  const flight = await one.page.evaluate(() => {
    viewer.startFlight();
    const {journey} = viewer, {min, max} = viewer.cavities[0].geometry.boundingBox;
    let least = Infinity, travelled = 0, outside = 0;
    for (let i = 0; i < 600; ++i) {
      journey.turnBy(Math.sin(i) * 0.7, Math.cos(0.7 * i) * 0.5);
      journey.speed.forward = 10;
      const before = journey.camera.position.clone();
      journey.update(0.1);
      const p = journey.camera.position;
      travelled += before.distanceTo(p);
      least = Math.min(least, journey.room() / journey.body);
      if (p.x < min.x || p.x > max.x || p.y < min.y || p.y > max.y || p.z < min.z || p.z > max.z) outside += 1;
    }
    journey.speed.forward = 0;
    viewer.leave();
    return {least, travelled, outside};
  });
  assert.ok(flight.least > 0.998, `${flight.least}`);
  assert.equal(flight.outside, 0);
  assert.ok(flight.travelled > 5, `${flight.travelled} mm`);
});

test('text of the input stays text', async () => {
  const molar = JSON.stringify({format: 'odontoscope.contours', version: 1, unit: 'mm', slices: [0, 1].map(z => ({z, contours: [{structure: hostile, points: [[0, 0], [8, 0], [8, 8], [0, 8]]}]}))});
  writeFileSync(made('hostile.json'), molar);
  odontoscope('web', 'hostile.json', '--title', hostile, '-o', 'hostile.html');
  const two = await opened(made('hostile.html'));
  assert.equal(await two.page.title(), hostile);
  assert.equal(await two.page.textContent('h1'), hostile);
  assert.ok((await two.page.textContent('#controls')).includes(hostile));
  assert.equal(await two.page.evaluate(() => globalThis.bitten), undefined);
  assert.equal(await two.page.locator('img').count(), 0);
  assert.deepEqual(two.watched, []);
  await two.close();
});

test('less motion: a view changes at once', async () => {
  const two = await opened(made('page.html'), {context: {reducedMotion: 'reduce'}});
  assert.equal(await two.page.evaluate(() => { viewer.look('occlusal'); return viewer.orbit.move; }), null);
  await two.close();
});

test('on a phone the picture has the room, and the controls unfold', async () => {
  const two = await opened(made('page.html'), {size: {width: 390, height: 780}, context: {hasTouch: true, isMobile: true}});
  const {page} = two, box = await page.locator('#canvas').boundingBox();
  assert.ok(box.width === 390 && box.height > 600, JSON.stringify(box));
  await page.getByRole('button', {name: 'Controls'}).tap();
  assert.ok(await page.getByRole('button', {name: 'Fly inside'}).isVisible());
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await two.close();
});

test('a headset shows two different eyes that follow the head', async () => {
  const emulator = readFileSync(join(modules, 'iwer/build/iwer.js'), 'utf8');
  const two = await opened(made('page.html'), {before: `${emulator}
    globalThis.device = new IWER.XRDevice(IWER.metaQuest3);
    device.installRuntime({forceInstall: true});
    device.stereoEnabled = true;`});
  const {page} = two;
  await page.getByRole('button', {name: 'Enter VR'}).click();
  await page.waitForFunction(() => viewer.headset.present && viewer.headset.placed);
  const seen = await page.evaluate(async () => {
    const next = count => new Promise(done => { viewer.addEventListener('drawn', function heard() { if (--count > 0) return; viewer.removeEventListener('drawn', heard); done(); }); });
    /// Both halves of the picture, left eye and right, of the frame just drawn.
    const eyes = async () => {
      await next(3);
      const gl = viewer.renderer.getContext(), {drawingBufferWidth: width, drawingBufferHeight: height} = gl, pixels = new Uint8Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      const half = from => {
        const values = [];
        for (let y = 0; y < height; y += 6) for (let x = from; x < from + (width >> 1); x += 6) values.push(pixels[4 * (y * width + x)], pixels[4 * (y * width + x) + 1], pixels[4 * (y * width + x) + 2], 255);
        return values;
      };
      return [half(0), half(width >> 1)];
    };
    const different = (a, b) => {
      let count = 0;
      for (let i = 0; i < a.length; i += 4) if (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]) > 24) count += 1;
      return 4 * count / a.length;
    };
    const covered = eye => different(eye, eye.map((_, i) => eye[i % 4]));
    const first = await eyes(), again = await eyes();
    device.position.x += 0.15;
    const moved = await eyes();
    device.quaternion.set(0, Math.sin(0.1), 0, Math.cos(0.1));
    const turned = await eyes();
    const size = viewer.world.scale.x * 2 * viewer.bounds.radius, distance = viewer.bounds.centre.clone().applyMatrix4(viewer.world.matrixWorld).distanceTo(viewer.headset.head().position);
    return {covered: first.map(covered), apart: different(...first), still: different(first[0], again[0]), moved: different(first[0], moved[0]), turned: different(moved[0], turned[0]), size, distance};
  });
  for (const share of seen.covered) assert.ok(share > 0.02, `the tooth covers ${share} of an eye`);
  assert.ok(seen.apart > 0.005, `the eyes differ in ${seen.apart}`);
  assert.equal(seen.still, 0);
  assert.ok(seen.moved > 0.01 && seen.turned > 0.01, `${seen.moved}, ${seen.turned}`);
  assert.ok(seen.size > 0.3 && seen.size < 0.6 && seen.distance < 0.9, `${seen.size} m at ${seen.distance} m`);

  const used = await page.evaluate(async () => {
    const next = () => new Promise(done => viewer.addEventListener('drawn', done, {once: true}));
    const settle = async () => { for (let i = 0; i < 4; ++i) await next(); };
    const middle = () => viewer.bounds.centre.clone().applyMatrix4(viewer.world.matrixWorld), hands = [device.controllers.left, device.controllers.right];
    const before = middle();
    hands[1].updateButtonValue('trigger', 1);
    await settle();
    hands[1].position.y += 0.2;
    await settle();
    hands[1].updateButtonValue('trigger', 0);
    const lifted = middle().y - before.y;
    await settle();
    const scale = viewer.world.scale.x;
    for (const hand of hands) hand.updateButtonValue('squeeze', 1);
    await settle();
    hands[0].position.x -= 0.2;
    hands[1].position.x += 0.2;
    await settle();
    for (const hand of hands) hand.updateButtonValue('squeeze', 0);
    const grown = viewer.world.scale.x / scale;
    await settle();
    hands[1].updateButtonValue('a-button', 1);
    await settle();
    hands[1].updateButtonValue('a-button', 0);
    const {journey} = viewer, mode = journey.mode, from = journey.camera.position.clone();
    let least = Infinity;
    hands[0].updateAxes?.('thumbstick', 0, -1);
    for (let i = 0; i < 20; ++i) {
      device.position.z -= 0.15;   // the head, too, leans against the walls
      await next();
      least = Math.min(least, journey.room() / journey.body);
    }
    const flown = journey.camera.position.distanceTo(from), eye = viewer.world.localToWorld(journey.camera.position.clone()).distanceTo(viewer.headset.head().position);
    return {lifted, grown, mode, flown, least, eye};
  });
  assert.ok(Math.abs(used.lifted - 0.2) < 0.01, `lifted by ${used.lifted} m`);
  assert.ok(used.grown > 1.2, `grown to ${used.grown}`);
  assert.equal(used.mode, 'fly');
  assert.ok(used.flown > 0.1 && used.least > 0.998 && used.eye < 0.01, JSON.stringify(used));
  assert.deepEqual(two.watched, []);
  await two.close();
});
