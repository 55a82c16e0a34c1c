// The grey values in the page, pixel by pixel, against the desktop's picture of the same scene.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {after, test} from 'node:test';
import {browser, folder, made, needPackages, odontoscope, openedIn, pageOrSkip} from './support.mjs';
import {compared as comparedOn, giveSeen, size, writeVolume} from './volume_scene.mjs';

needPackages();
writeVolume('ct.nrrd');
pageOrSkip('ct.nrrd', '--iso', '100', '--show', 'both', '-o', 'both.html');
odontoscope('web', 'ct.nrrd', '--show', 'volume', '--cast', 'maximum', '-o', 'alone.html');

const chromium = await browser();
after(() => chromium.close());
const {page, watched} = await openedIn(chromium, made('both.html'), {size: {width: 560, height: 200}});
await giveSeen(page);
const compared = change => comparedOn(page, 'ct.nrrd', change);

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

// Where a slope is nearly none, and on the edges of surfaces, rounding decides.
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
    assert.ok(judged.lit > 4000 && judged.off < 0.004 * judged.lit, JSON.stringify(judged));
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
