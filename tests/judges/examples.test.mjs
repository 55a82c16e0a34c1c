// examples/web as a web developer meets them: served by a static server, in Chromium. And the files they show, by the validator.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {dirname, extname, join, normalize} from 'node:path';
import {fileURLToPath} from 'node:url';
import {browser, folder, glbParts, modules, needPackages, packageNamed, pageOrSkip} from './support.mjs';

needPackages();
const root = join(dirname(fileURLToPath(import.meta.url)), '../..'), source = join(root, 'examples/web'), site = join(folder, 'site');
pageOrSkip('-o', 'probe.html', '--triangles', '2000');

// As its own script makes it, with the program of this build.
mkdirSync(site);
const bin = join(folder, 'bin');
mkdirSync(bin);
symlinkSync(process.env.ODONTOSCOPE_PROGRAM, join(bin, 'odontoscope'));
for (const file of readdirSync(source)) if (/\.(html|js)$/.test(file)) copyFileSync(join(source, file), join(site, file));
copyFileSync(join(root, 'web/component/odontoscope-tooth.js'), join(site, 'odontoscope-tooth.js'));
execFileSync(join(source, 'make'), [site], {env: {...process.env, PATH: `${bin}:${process.env.PATH}`}, stdio: 'inherit'});

// Pinned as here, so that what is tested is what the lockfile of the examples installs.
const versions = file => Object.fromEntries(Object.entries(JSON.parse(readFileSync(file)).packages).map(([name, {version}]) => [name, version]));
const theirs = versions(join(source, 'package-lock.json')), ours = versions(join(root, 'tests/judges/package-lock.json'));
for (const name of ['node_modules/three', 'node_modules/@google/model-viewer']) assert.equal(theirs[name], ours[name], `${name} is another in examples/web/package-lock.json`);

const glb = new Uint8Array(readFileSync(join(site, 'tooth.glb'))), {json} = glbParts(glb);
const report = await packageNamed('gltf-validator').validateBytes(glb);
assert.equal(report.issues.numErrors + report.issues.numWarnings, 0, JSON.stringify(report.issues.messages.slice(0, 5)));
const variants = json.extensions.KHR_materials_variants.variants.map(({name}) => name);
assert.deepEqual(variants, ['natural', 'see-through', 'plaster']);
const hotspots = json.nodes.filter(node => node.extras?.hotspot);
assert.ok(hotspots.length >= 3, 'a chamber, an orifice and a tip');
assert.ok(readFileSync(join(site, 'tooth.html')).length <= 1_600_000, '--budget');

const kinds = {'.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.glb': 'model/gltf-binary', '.png': 'image/png', '.json': 'application/json'};
const server = createServer(({url}, answer) => {
  const path = normalize(decodeURIComponent(new URL(url, 'http://x').pathname)), file = path.startsWith('/node_modules/') ? join(modules, path.slice('/node_modules/'.length)) : join(site, path);
  if (!existsSync(file)) return answer.writeHead(404).end();
  answer.writeHead(200, {'content-type': kinds[extname(file)] ?? 'application/octet-stream'}).end(readFileSync(file));
});
await new Promise(done => server.listen(0, '127.0.0.1', done));
const base = `http://127.0.0.1:${server.address().port}`;

const chromium = await browser();
const problems = [];
async function opened(name) {
  const page = await chromium.newPage({viewport: {width: 700, height: 700}});
  page.on('pageerror', error => problems.push(`${name}: ${error.message}`));
  page.on('console', message => { if (message.type() === 'error' && !/favicon/.test(message.location().url)) problems.push(`${name}: ${message.text()} ${message.location().url}`); });
  await page.goto(`${base}/${name}`);
  return page;
}
const shown = process.env.ODONTOSCOPE_SHOTS;   // a folder to look at
const shoot = async (page, name) => { const bytes = await page.screenshot(shown ? {path: join(shown, name)} : {}); return bytes; };
const until = (page, check, argument) => page.waitForFunction(check, argument, {timeout: 120_000});

{ // The element: a poster first, then the page; attributes, events, address.
  const page = await opened('component.html');
  await until(page, () => document.querySelector('odontoscope-tooth').shadowRoot.querySelector('img')?.naturalWidth > 0);
  assert.equal(page.frames().length, 1, 'nothing is loaded before somebody asks');
  await shoot(page, 'poster.png');
  await page.locator('odontoscope-tooth').click();
  await until(page, () => /Premolar is there/.test(document.querySelector('output').textContent));
  const inner = page.frames()[1];
  assert.match(inner.url(), /#view=buccal&bare=&parent=/);
  assert.equal(await inner.evaluate(() => getComputedStyle(document.getElementById('panel')).display), 'none');
  const before = await shoot(page, 'whole.png');
  await page.getByText('Cut it open').click();
  await until(page, () => document.querySelector('odontoscope-tooth').state?.section === 'buccal,0');
  await page.getByText('The pulp alone').click();
  await until(page, () => document.querySelector('odontoscope-tooth').state?.hide === 'dentine,enamel');
  assert.match(inner.url(), /section=buccal%2C0&hide=dentine%2Cenamel/);
  assert.notDeepEqual(await shoot(page, 'pulp.png'), before);
  // What somebody does within is told, and an attribute that is taken away shows all again.
  await page.evaluate(() => document.querySelector('odontoscope-tooth').removeAttribute('hide'));
  await until(page, () => document.querySelector('odontoscope-tooth').state?.hide === '');
  // A message from elsewhere changes nothing.
  await page.evaluate(() => postMessage({source: 'odontoscope', event: 'state', state: {hide: 'all'}}, '*'));
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => document.querySelector('odontoscope-tooth').state.hide), '');
  await page.close();
}

{ // A plain frame.
  const page = await opened('iframe.html');
  await until(page, () => /ready/.test(document.querySelector('output').textContent));
  const inner = page.frames()[1];
  assert.deepEqual(await inner.evaluate(async () => { const {section} = await globalThis.odontoscope; return [section.on, section.side.name, section.at]; }), [true, 'mesial', 0.5]);
  await shoot(page, 'frame.png');
  await page.locator('button').click();
  await until(page, () => /"hide":"dentine,enamel"/.test(document.querySelector('output').textContent));
  await page.close();
}

{ // model-viewer.
  const page = await opened('model-viewer.html');
  await until(page, () => document.querySelector('select')?.value === 'see-through');
  assert.deepEqual(await page.evaluate(() => [...document.querySelector('select').options].map(option => option.text)), variants);
  await until(page, count => document.querySelectorAll('model-viewer .place').length === count, hotspots.length);
  await page.waitForTimeout(1500);
  const clear = await shoot(page, 'model-viewer.png');
  await page.selectOption('select', 'plaster');
  await page.waitForTimeout(1500);
  assert.notDeepEqual(await shoot(page, 'model-viewer-plaster.png'), clear);
  await page.close();
}

{ // three.js.
  const page = await opened('three.html');
  await until(page, () => globalThis.example);
  assert.deepEqual(await page.evaluate(() => [example.places.length, example.variants]), [hotspots.length, variants]);
  const clear = await shoot(page, 'three.png');
  await page.getByText('plaster').click();
  await page.waitForTimeout(500);
  assert.notDeepEqual(await shoot(page, 'three-plaster.png'), clear);
  await page.close();
}

await chromium.close();
server.close();
assert.deepEqual(problems, []);
console.log('examples: the element, a frame, model-viewer and three.js show the tooth');
