// The npm package as somebody else meets it: packed, installed into an empty folder, imported by name; its types; its errors.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {differing, dist, folder, odontoscope, timeless} from './support.mjs';

const {OdontoscopeError, compare, load, reconstruct, run, sample, words} = odontoscope;

test('it is packed, installed without the network, and imported by its name', () => {
  const at = join(folder, 'user');
  mkdirSync(at);
  writeFileSync(join(at, 'package.json'), '{"name": "user", "private": true, "type": "module"}');
  const npm = (...line) => execFileSync('npm', line, {cwd: at, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']});
  const [{filename, files}] = JSON.parse(npm('pack', '--json', join(dist, 'npm')));
  assert.deepEqual(files.map(file => file.path).sort(), ['LICENSE', 'README.md', 'decoder.mjs', 'decoder.wasm', 'index.d.ts', 'index.mjs', 'odontoscope.mjs', 'odontoscope.wasm', 'package.json', 'page.html',
    'threads/odontoscope.js', 'threads/odontoscope.mjs', 'threads/odontoscope.wasm', 'threads/odontoscope.worker.js', 'threads/package.json']);
  npm('install', '--offline', '--no-audit', '--no-fund', `./${filename}`);
  writeFileSync(join(at, 'use.mjs'), `import {sample} from 'odontoscope';\nconst {files} = await sample('incisor', {output: 'tooth.json'});\nconsole.log(JSON.parse(new TextDecoder().decode(files['tooth.json'])).format);\n`);
  assert.equal(execFileSync(process.execPath, ['use.mjs'], {cwd: at, encoding: 'utf8'}).trim(), 'odontoscope.contours');
});

test('options are those of the program', () => {
  assert.deepEqual(words('reconstruct', {input: 'a.nrrd', output: ['a.glb', 'b.stl'], minArea: 4, strict: true, partition: false, together: ['a,b', 'c,d'], voxels: [0.1, 0.1, 0.2]}),
    ['reconstruct', 'a.nrrd', '-o', 'a.glb', '-o', 'b.stl', '--min-area', '4', '--strict', '--together', 'a,b', '--together', 'c,d', '--voxels', '0.1,0.1,0.2']);
});

test('progress is told, and refusals are errors with cause and exit code', async () => {
  const {files} = await sample('incisor', {output: 'tooth.json'}), stages = [];
  const made = await reconstruct({files, input: 'tooth.json', output: 'tooth.glb', onProgress: (stage, fraction) => stages.push([stage, fraction])});
  assert.equal(Buffer.from(made.files['tooth.glb'].subarray(0, 4)).toString(), 'glTF');
  assert.ok(stages.length > 5 && stages.every(([stage, fraction]) => typeof stage === 'string' && fraction >= 0 && fraction <= 1));
  await assert.rejects(reconstruct({files: {'bad.json': '{'}, input: 'bad.json', output: 'x.glb'}),
    error => error instanceof OdontoscopeError && error.exitCode === 3 && typeof error.causeId === 'string' && error.message.includes('bad.json'));
  await assert.rejects(reconstruct({files, input: 'tooth.json', output: 'x.glb', nonsense: 1}), {exitCode: 2});
  await assert.rejects(run(['check', 'x'], {files: {'../x': ''}}), OdontoscopeError);
});

test('runs share nothing, and one that ends badly harms no other', async () => {
  const engine = await load();
  assert.equal((await engine.run(['check', 'none.json'])).exitCode, 4);
  assert.equal((await engine.run(['check', 'deep.json'], {files: {'deep.json': '['.repeat(300_000)}})).exitCode, 3);
  assert.equal((await engine.run(['sample', 'incisor', '-o', 'none.json'])).exitCode, 0);
  assert.equal((await engine.run(['check', 'none.json'])).exitCode, 4);
});

test("a page's model is saved without making it again, and meshed for simulation", async () => {
  const {files} = await sample('incisor', {output: 'tooth.json'}), engine = await load();
  const page = await engine.run(['web', 'tooth.json', '-o', 'tooth.html'], {files});
  assert.equal(page.exitCode, 0, page.complained.join());
  const made = await engine.reconstruct({files, input: 'tooth.json', output: ['a.ply', 'a.vtu', 'a.inp'], report: 'a.json'}), stages = new Set();
  const saved = await page.save({output: ['a.ply', 'a.vtu', 'a.inp'], report: 'a.json', onProgress: stage => stages.add(stage)});
  assert.deepEqual(differing(saved, made).filter(name => name !== 'a.json'), []);
  assert.equal(timeless(Buffer.from(saved.files['a.json'])), timeless(Buffer.from(made.files['a.json'])));
  assert.ok(!stages.has('slabs'), [...stages].join());
  const meshed = await page.save({output: 'b.vtu', elements: 1.5, report: 'b.json'});
  assert.equal(meshed.exitCode, 0, meshed.complained.join());
  assert.equal(JSON.parse(Buffer.from(meshed.files['b.json']).toString()).elements.asked, 1.5);
  const again = await page.save({output: 'a.ply'});
  assert.deepEqual(Buffer.from(again.files['a.ply']), Buffer.from(made.files['a.ply']));   // it is as it was
  assert.equal((await page.save({output: 'a.docx'})).exitCode, 2);
  assert.equal((await engine.run(['check', 'tooth.json'], {files})).save, null);
  assert.equal((await engine.run(['save', '-o', 'a.ply'], {files})).exitCode, 2);
});

test('both methods are compared', async () => {
  const {files} = await sample('incisor', {output: 'tooth.json'});
  const {said, files: {'c.html': page}} = await compare({files, input: 'tooth.json', grid: 24, html: 'c.html'});
  assert.match(Buffer.from(page).toString(), /DB decimated/);
  assert.ok(said.some(line => line.includes('does not draw')));
});
