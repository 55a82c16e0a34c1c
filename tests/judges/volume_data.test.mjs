// Model against data in the page: surfaces in the colours of their distance to the CT's own, and of its slope, against
// the desktop's picture and what the programme tells.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {after, test} from 'node:test';
import {browser, folder, made, needPackages, odontoscope, openedIn, pageOrSkip} from './support.mjs';
import {compared, giveSeen, writeVolume} from './volume_scene.mjs';

needPackages();
const times = 37; // of the finer volume's values
writeVolume('ct.nrrd');
writeVolume('fine.nrrd', times);
pageOrSkip('ct.nrrd', '--iso', '100', '--show', 'both', '-o', 'ct.html');
odontoscope('web', 'fine.nrrd', '--iso', String(100 * times), '--show', 'both', '-o', 'fine.html');
odontoscope('web', 'ct.nrrd', '--show', 'volume', '-o', 'alone.html');

const chromium = await browser();
after(() => chromium.close());

/// What the programme tells of a volume: {median, within, most} in mm, and the median of slopes.
function toldBy(name, iso) {
  const words = ['render', name, '--iso', String(iso), '--colour-by', 'distance', '--size', '60x60', '-o', 'told.png'];
  const said = execFileSync(process.env.ODONTOSCOPE_PROGRAM, words, {
    cwd: folder,
    stdio: ['ignore', 'pipe', 'pipe'],
  }).toString();
  const [, median, within, most] = /lies ([\d.e-]+) mm from .*95 % within ([\d.e-]+) mm, the farthest ([\d.e-]+) mm/
    .exec(said)
    .map(Number);
  return {median, within, most, slope: Number(/rise by ([\d.e+-]+) a millimetre/.exec(said)[1])};
}

const slopesOf = page =>
  page.evaluate(async () => {
    await viewer.data.choose('distance');
    const slopes = viewer.models[0].parts
      .flatMap(({geometry}) => [...geometry.getAttribute('data').array].filter((_, i) => i % 2 === 1))
      .sort((a, b) => a - b);
    return {
      ...viewer.data.summary,
      unit: viewer.data.grid.unit,
      flat: slopes[Math.trunc(0.05 * slopes.length)],
      slope: slopes[slopes.length >> 1],
    };
  });

const near = (a, b, off) => Math.abs(a - b) <= off;

test('of whole numbers within 256 the page finds what the programme does', async () => {
  const {page, watched, close} = await openedIn(chromium, made('ct.html'), {size: {width: 560, height: 200}});
  const own = await slopesOf(page),
    right = toldBy('ct.nrrd', 100);
  assert.ok(near(own.most, right.most, 0.006 * right.most), JSON.stringify({own, right})); // as many digits are told
  // A corner is counted once for each of its normals, which the page's file parts at other edges than the desktop.
  for (const key of ['median', 'within', 'slope'])
    assert.ok(near(own[key], right[key], 0.02 * right[key]), JSON.stringify({key, own, right}));
  assert.ok(right.most > 0.02, JSON.stringify(right));
  assert.deepEqual(watched, []);
  await close();
});

test('of others it is off by half a step of eight bits over the slope, and not by more', async () => {
  const {page, watched, close} = await openedIn(chromium, made('fine.html'), {size: {width: 560, height: 200}});
  const own = await slopesOf(page),
    right = toldBy('fine.nrrd', 100 * times),
    least = (0.5 * own.unit) / own.flat;
  assert.ok(own.unit > 10, JSON.stringify(own)); // a step of several values
  for (const key of ['median', 'within', 'most'])
    assert.ok(near(own[key], right[key], least), JSON.stringify({key, least, own, right}));
  assert.ok(near(own.slope, right.slope, 0.05 * right.slope), JSON.stringify({own, right}));
  const aside = await page.evaluate(async () => {
    // this would be noticed: a value taken for another
    const {data, models} = viewer;
    data.summaries = data.comparing = null;
    data.isos.set('tooth', data.isos.get('tooth') + 3 * data.grid.unit);
    await data.choose('distance');
    return {...data.summary, parts: models[0].parts.length};
  });
  assert.ok(!near(aside.median, right.median, least), JSON.stringify({aside, right, least}));
  assert.deepEqual(watched, []);
  await close();
});

// Colours that end about where most distances do. The shortest way is looked for along normals, too, which the page's file
// and the desktop do not have quite alike.
for (const [data, reach] of [
  ['distance', 0.02],
  ['slope', 250],
])
  test(`nearly everywhere the picture is the desktop's within two levels: surfaces by ${data}`, async () => {
    const {page, watched, close} = await openedIn(chromium, made('ct.html'), {size: {width: 560, height: 200}});
    await giveSeen(page);
    const judged = await compared(page, 'ct.nrrd', {volume: {shows: 'surfaces'}, data, reach});
    assert.ok(judged.lit > 4000 && judged.off < 0.04 * judged.lit, JSON.stringify(judged));
    const noticed = await page.evaluate(() => {
      const right = seen().shown;
      viewer.shared.data_reach.value *= 2;
      return seen().shown.filter((value, i) => Math.abs(value - right[i]) > 2).length;
    });
    assert.ok(noticed > 3 * 0.04 * judged.lit, `${noticed} of ${judged.lit} pixels tell twice the reach`);
    assert.deepEqual(watched, []);
    await close();
  });

test('the panel switches between own colours, distance and slope, and has the legend', async () => {
  const {page, watched, close} = await openedIn(chromium, made('ct.html'), {size: {width: 1100, height: 900}});
  const panel = page.locator('#volume-controls'),
    colours = page.locator('#data-colours'),
    legend = panel.locator('canvas.legend');
  await page.evaluate(() => viewer.setVolume({shows: 'surfaces'}));
  await giveSeen(page);
  const ends = () =>
    legend.evaluate(canvas => {
      const copy = new OffscreenCanvas(48, 1).getContext('2d');
      copy.drawImage(canvas, 0, 0);
      const {data} = copy.getImageData(0, 0, 48, 1);
      return [0, 47].map(x => [...data.slice(4 * x, 4 * x + 3)]);
    });
  // The legend's 48 pieces show their middles, so that the outermost are no end colours: light runs straight between.
  const linear = x => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
  const encoded = x => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
  const channel = (hex, k) => linear(parseInt(hex.slice(2 * k, 2 * k + 2), 16) / 255);
  const mixed = (middle, end) => [0, 1, 2].map(k => 255 * encoded((channel(middle, k) + 47 * channel(end, k)) / 48));
  const like = (colour, middle, end) => colour.every((value, k) => Math.abs(value - mixed(middle, end)[k]) < 2);
  const own = await page.evaluate(() => seen().shown),
    differs = async () =>
      (await page.evaluate(() => seen().shown)).filter((value, i) => Math.abs(value - own[i]) > 4).length;
  await colours.getByRole('button', {name: 'Distance'}).click();
  await panel.getByText(/^Median [\d.]+ mm, 95 % within [\d.]+ mm, the farthest [\d.]+ mm\.$/).waitFor();
  const kind = () => page.evaluate(() => viewer.shown[0].parts[0].shown.material.uniforms.show_data.value);
  assert.ok((await differs()) > 2000);
  assert.equal(await kind(), 1);
  assert.ok(near(await page.evaluate(() => viewer.shared.data_reach.value), 0.28, 1e-9));
  const [least, most] = await ends();
  assert.ok(like(least, 'f7f7f7', '2166ac') && like(most, 'f7f7f7', 'b2182b'), JSON.stringify([least, most]));
  assert.match(await page.locator('#data-ends').textContent(), /^\u22120\.28 mm \(blue.*to \+0\.28 mm \(red/); // a voxel
  await panel.getByRole('slider', {name: 'Colours reach to, mm'}).press('Home');
  assert.ok(await page.evaluate(() => viewer.shared.data_reach.value < 0.28 && viewer.data.reach.distance < 0.28));
  await colours.getByRole('button', {name: 'Slope'}).click();
  assert.match(await page.locator('#data-ends').textContent(), /^0 to [\d.]+ grey values a millimetre$/);
  assert.equal(await kind(), 2);
  const [flat, steep] = await ends();
  assert.ok(like(flat, '7c7b78', '00204c') && like(steep, '7c7b78', 'ffe945'), JSON.stringify([flat, steep]));
  await colours.getByRole('button', {name: 'Own colours'}).click();
  assert.ok(await legend.isHidden());
  assert.deepEqual(
    await page.evaluate(() => [viewer.data.shown, viewer.shown[0].parts[0].shown.material.uniforms.show_data.value]),
    [null, 0],
  );
  assert.deepEqual(watched, []);
  await close();
});

test('inside, walls keep their depth, and the colours are there', async () => {
  const {page, watched, close} = await openedIn(chromium, made('ct.html'), {size: {width: 560, height: 400}});
  const told = await page.evaluate(async () => {
    viewer.setVolume({shows: 'surfaces'});
    viewer.startFlight();
    await viewer.data.choose('slope');
    viewer.draw();
    const part = viewer.models[0].parts.find(({kind}) => kind === 'cavity'),
      {position, wall_depth, data} = part.geometry.attributes;
    return {
      same: position.count === wall_depth.count && position.count === data.count,
      error: viewer.renderer.getContext().getError(),
    };
  });
  assert.deepEqual(told, {same: true, error: 0});
  assert.deepEqual(watched, []);
  await close();
});

test('a volume alone has no surface to compare', async () => {
  const {page, close} = await openedIn(chromium, made('alone.html'), {size: {width: 560, height: 200}});
  assert.deepEqual(await page.evaluate(() => [viewer.data, document.getElementById('data-colours')]), [null, null]);
  await close();
});
