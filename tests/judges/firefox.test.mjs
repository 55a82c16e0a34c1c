// The page of `odontoscope web` in a browser that is not Chromium.
import assert from 'node:assert/strict';
import {after, test} from 'node:test';
import {firefox, made, needPackages, openedIn, pageOrSkip} from './support.mjs';

needPackages();
pageOrSkip('--triangles', '6000', '--db', '--grid', '20', '--cases', 'classic-unoriented', '-o', 'page.html');
const driven = await firefox();
after(() => driven.close());
const {page, watched} = await openedIn(driven, made('page.html'), {size: {width: 760, height: 400}});

await page.evaluate(() => {
  globalThis.look = () => {
    viewer.frame(0);
    viewer.draw();
    const canvas = document.createElement('canvas'), {width, height} = viewer.canvas;
    Object.assign(canvas, {width: width / 4, height: height / 4});
    const context = canvas.getContext('2d');
    context.drawImage(viewer.canvas, 0, 0, canvas.width, canvas.height);
    return context.getImageData(0, 0, canvas.width, canvas.height).data;
  };
  /// The share of the picture that an action changes.
  globalThis.changedBy = action => {
    const before = look();
    action();
    const now = look();
    let count = 0;
    for (let i = 0; i < now.length; i += 4) if (Math.abs(now[i] - before[i]) + Math.abs(now[i + 1] - before[i + 1]) + Math.abs(now[i + 2] - before[i + 2]) > 24) count += 1;
    return 4 * count / now.length;
  };
});

test('it loads from disk, asks the network for nothing and complains of nothing', async () => {
  assert.match(driven.version(), /^\d+\./);
  assert.match(await page.evaluate(() => navigator.userAgent), /Firefox/);
  assert.equal(await page.title(), 'Sample molar');
  assert.match(await page.textContent('.verdict'), /ertified/);
  assert.deepEqual(watched, []);
});

test('layers, culling, section, DT and DB change the picture', async () => {
  const changes = await page.evaluate(() => ({
    layers: Boolean(viewer.picture.layers),
    nothing: changedBy(() => {}),
    hidden: changedBy(() => viewer.setLook('pulp', {visible: false})),
    back: changedBy(() => viewer.setLook('pulp', {visible: true})),
    cut: changedBy(() => viewer.cut({on: true})),
    whole: changedBy(() => viewer.cut({on: false})),
    db: changedBy(() => { for (const key of viewer.looks.keys()) viewer.setLook(key, {opacity: 1}); viewer.show(1); viewer.setFaces('show'); }),
    dbCulled: changedBy(() => viewer.setFaces('cull')),
    dt: changedBy(() => viewer.show(0)),
    dtShown: changedBy(() => viewer.setFaces('show')),
  }));
  assert.equal(changes.layers, true);
  assert.equal(changes.nothing, 0);
  for (const what of ['hidden', 'back', 'cut', 'whole', 'db', 'dt']) assert.ok(changes[what] > 0.004, JSON.stringify(changes));
  assert.ok(changes.dbCulled > 0.03 && changes.dtShown < 0.008, JSON.stringify(changes));
});

test('a tour plays', async () => {
  await page.keyboard.press('t');
  const from = await page.evaluate(() => viewer.journey.mm);
  await page.waitForFunction(before => viewer.journey.mm > before, from);
  const there = await page.evaluate(() => {
    viewer.play(false);
    const changed = changedBy(() => viewer.seek(0.5 * viewer.journey.tour.length)), mode = viewer.journey.mode;
    viewer.leave();
    return {changed, mode};
  });
  assert.equal(there.mode, 'tour');
  assert.ok(there.changed > 0.05, JSON.stringify(there));
  assert.deepEqual(watched, []);
});
