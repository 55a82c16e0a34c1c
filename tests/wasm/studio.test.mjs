// The studio's page in a browser: what is dropped on it becomes a model, what is bad is refused, and the page lives on.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, readFileSync, statSync, writeFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {after, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {browser, firefox, needPackages} from '../judges/support.mjs';
import {fragmentAt, series} from './dicom_series.mjs';
import {dist, folder, native, root} from './support.mjs';

needPackages();
const inFirefox = process.env.ODONTOSCOPE_STUDIO_IN === 'firefox';
const driven = await (inFirefox ? firefox() : browser());
after(() => driven.close());
const file = join(dist, 'studio.html'), watched = [];
const context = await driven.newContext({viewport: {width: 1280, height: 800}, acceptDownloads: true, colorScheme: 'dark'}), page = await context.newPage();
page.setDefaultTimeout(120_000);
page.on('pageerror', error => watched.push(`error ${error.message}`));
page.on('console', message => { if (!message.text().includes('GPU stall due to ReadPixels')) watched.push(`console ${message.type()}: ${message.text()}`); });
page.on('request', request => { if (!/^(blob|data|file):/.test(request.url())) watched.push(`request ${request.url()}`); });
await page.goto(pathToFileURL(file).href);

const put = (name, bytes) => { writeFileSync(join(folder, name), bytes); return join(folder, name); };
const molar = native(['sample', 'molar', '-o', 'molar.json'], {}).files['molar.json'];
const idle = () => page.waitForFunction(() => document.getElementById('working').hidden);
/// What a click saves: {name, bytes}. Firefox, spoken to by WebDriver BiDi, tells nothing of downloads: there the link that the page presses is caught instead.
async function saved(selector) {
  if (!inFirefox) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
    return {name: download.suggestedFilename(), bytes: readFileSync(await download.path())};
  }
  await page.evaluate(() => {
    const make = URL.createObjectURL.bind(URL);
    let blob = null;
    globalThis.caught = null;
    URL.createObjectURL = one => make(blob = one);
    HTMLAnchorElement.prototype.click = function () {
      const reader = new FileReader(), name = this.download;
      reader.onload = () => { globalThis.caught = {name, base64: reader.result.split(',')[1]}; };
      reader.readAsDataURL(blob);
    };
  });
  await page.click(selector);
  await page.waitForFunction(() => globalThis.caught);
  const {name, base64} = await page.evaluate(() => globalThis.caught);
  return {name, bytes: Buffer.from(base64, 'base64')};
}
const viewerFrame = async () => (await page.$('#viewer')).contentFrame();

test('it opens from disk, is at most 4 MB, and asks the network for nothing', async () => {
  assert.ok(statSync(file).size <= 4_000_000, `${statSync(file).size}`);
  assert.equal(await page.title(), 'Odontoscope studio');
  assert.deepEqual(watched, []);
});

test('contours become the certified model in the viewer', async () => {
  await page.setInputFiles('#file', put('molar.json', molar));
  await page.waitForSelector('#result:not([hidden])');
  assert.equal(await page.getAttribute('#verdict', 'class'), 'certified');
  const frame = await viewerFrame();
  await frame.waitForFunction(() => globalThis.odontoscope);
  assert.equal(await frame.evaluate(async () => { const viewer = await odontoscope; viewer.picture.mostSamples = 0; return viewer.tours?.length ?? 0; }) >= 0, true);
  assert.match(await frame.textContent('.verdict'), /ertified/);
  assert.equal(await frame.textContent('h1'), 'molar');
  assert.deepEqual(watched, []);
  if (process.env.ODONTOSCOPE_STUDIO_SHOT) {
    await page.waitForTimeout(1500);
    await page.screenshot({path: process.env.ODONTOSCOPE_STUDIO_SHOT});
  }
});

test('what is saved is what the program writes, and the model is not made again for it', async () => {
  const stages = new Set();
  await page.exposeFunction('toldStage', stage => stages.add(stage.replace(/:.*/, '')));
  await page.evaluate(() => new MutationObserver(() => toldStage(document.getElementById('stage').textContent)).observe(document.getElementById('stage'), {childList: true}));
  for (const ending of ['.stl', '.msh']) {
    const {bytes} = await saved(`#saves button:text-is("${ending}")`);
    const there = native(['reconstruct', 'molar.json', '-o', `molar${ending}`], {'molar.json': molar}).files[`molar${ending}`];
    assert.equal(Buffer.compare(bytes, there), 0, ending);
  }
  await idle();
  assert.ok(!stages.has('slabs') && !stages.has('certify'), [...stages].join());
});

test('elements for simulation are meshed of the model that is there, and both methods compared', async () => {
  await page.fill('#elements', '1.5');
  const vtu = await saved('#saves h3:text-is("Elements for simulation") + p button:text-is(".vtu")');
  assert.equal(vtu.name, 'molar-elements.vtu');
  assert.match(vtu.bytes.subarray(0, 400).toString(), /UnstructuredGrid/);
  assert.match(await page.textContent('#said'), /elements of about 1.5 mm/);
  await idle();
  await page.click('#options summary');
  await page.fill('input[name=more]', '--grid 24');
  const comparison = await saved('#saves button:text-is("both methods")');
  assert.match(comparison.bytes.toString(), /<table/);
  assert.match(await page.textContent('#said'), /DB decimated/);
  await idle();
  await page.fill('input[name=more]', '');
  await page.click('#options summary');
});

test('a run can be cancelled, and the next one goes well', async () => {
  await page.click('#make');
  await page.waitForSelector('#cancel:not([hidden])');
  await page.click('#cancel');
  await page.waitForSelector('#failure:not([hidden])');
  assert.match(await page.textContent('#failure'), /^Cancelled/);
  await page.click('.sample[value=incisor]');
  await page.waitForFunction(() => document.getElementById('given').textContent === 'incisor.json');
  await idle();
  assert.equal(await page.getAttribute('#verdict', 'class'), 'certified');
});

test('hostile files end in errors with a remedy, and the page lives', async () => {
  const bad = {
    'crossing.json': readFileSync(join(root, 'tests/corpus/bad', 'contours-cross.squares.json')),
    'noise.json': Buffer.from(Array.from({length: 4096}, (_, i) => (i * 7919 + 13) % 256)),
    'deep.json': Buffer.from('['.repeat(200_000)),
    'huge.nrrd': Buffer.from('NRRD0004\ntype: short\ndimension: 3\nsizes: 2000000 2000000 2000000\nencoding: raw\nendian: little\n\n'),
    '-o.json': Buffer.from('{}'),
    'empty.stl': Buffer.alloc(0),
  };
  for (const [name, bytes] of Object.entries(bad)) {
    await page.fill('input[name=iso]', name.endsWith('.nrrd') ? '1' : '');
    await page.setInputFiles('#file', put(name, bytes));
    await page.waitForSelector('#failure:not([hidden])');
    await idle();
    const words = await page.textContent('#failure');
    assert.ok(words.length > 20 && !/bug|unreachable|RuntimeError/.test(words), `${name}: ${words}`);
  }
  await page.fill('input[name=iso]', '');
  await page.evaluate(() => Object.defineProperty(navigator, 'languages', {value: ['de-AT', 'en'], configurable: true}));
  await page.setInputFiles('#file', put('crossing.json', bad['crossing.json']));
  await page.waitForSelector('#failure [lang=de]');
  await idle();
  assert.match(await page.textContent('#failure'), /^Konturen einer Struktur kreuzen einander nicht\..+\n.*crossing\.json: slice 1 .*\[contours-cross\]$/s);   // and precisely in English
  await page.evaluate(() => delete navigator.languages);
  await page.click('.sample[value=molar]');
  await page.waitForFunction(() => document.getElementById('given').textContent === 'molar.json' && document.getElementById('failure').hidden);
  await idle();
  assert.equal(await page.getAttribute('#verdict', 'class'), 'certified');
});

test('compressed DICOM becomes a model, a damaged slice is refused, and the page lives', async t => {
  const packing = ['gdcmconv', '--jpeg', 'in', 'out'];
  if (spawnSync(packing[0], ['--version']).error) return t.skip('gdcmconv was not found');
  const drop = async name => {
    const files = series(folder, name, packing), slices = Object.keys(files).map(one => join(folder, name, basename(one)));
    if (name === 'damaged') {   // under a name of its own: Firefox takes files of the same names for no change
      const bytes = files['series/3.dcm'];
      slices[3] = join(folder, name, 'damaged.dcm');
      writeFileSync(slices[3], bytes.fill(0, fragmentAt(bytes), bytes.length - 8));
    }
    await page.setInputFiles('#file', slices);
    return files;
  };
  await page.fill('input[name=iso]', '300');
  const files = await drop('packed');
  await page.waitForFunction(() => document.getElementById('given').textContent.includes('0.dcm'));
  await idle();
  assert.equal(await page.getAttribute('#verdict', 'class'), 'certified', await page.textContent('#failure'));
  const {bytes} = await saved('#saves button:text-is(".ply")');
  const there = native(['reconstruct', 'series', '--iso', '300', '-o', 'ring.ply'], files).files['ring.ply'];
  assert.equal(Buffer.compare(bytes, there), 0);
  await idle();
  await drop('damaged');
  await page.waitForSelector('#failure:not([hidden])');
  assert.match(await page.textContent('#failure'), /damaged\.dcm: .*\[damaged-volume\]/);
  await idle();
  await page.fill('input[name=iso]', '');
});

test('a mesh is shown with what is wrong with it, and DB stands beside DT', async () => {
  const made = native(['reconstruct', 'molar.json', '--method', 'db', '--grid', '24', '--cases', 'classic-unoriented', '-o', 'db.stl'], {'molar.json': molar}).files['db.stl'];
  await page.setInputFiles('#file', put('db.stl', made));
  await page.waitForFunction(() => document.getElementById('given').textContent === 'db.stl');
  await idle();
  assert.equal(await page.getAttribute('#verdict', 'class'), 'wanting');
  await page.check('input[name=db]');
  await page.click('#options summary');
  await page.fill('input[name=more]', '--grid 24');
  await page.setInputFiles('#file', put('both.json', molar));
  await page.waitForFunction(() => document.getElementById('given').textContent === 'both.json');
  await idle();
  const frame = await viewerFrame();
  await frame.waitForFunction(() => globalThis.odontoscope);
  assert.equal(await frame.evaluate(() => JSON.parse(document.getElementById('description').textContent).models.length), 2);
  assert.deepEqual(watched, []);
});
