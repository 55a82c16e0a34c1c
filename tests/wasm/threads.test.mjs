// The engine for several threads: the bytes of one, its errors, and no thread left behind.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {corpus, differing, dist, native, odontoscope} from './support.mjs';

const {load} = odontoscope, one = await load({threads: 1}), two = await load({threads: 2}), seven = await load({threads: 7});
const molar = native(['sample', 'molar', '-o', 'tooth.json'], {}).files, incisor = native(['sample', 'incisor', '--filled', '-o', 'tooth.json'], {}).files;

test('each run has as many threads as were asked for, and says so', async () => {
  assert.deepEqual([one.threads, two.threads, seven.threads], [1, 2, 7]);
  for (const [engine, words] of [[one, /s on 1 thread/], [two, /s on 2 threads/], [seven, /s on 7 threads/]])
    assert.match((await engine.run(['reconstruct', 'tooth.json', '-o', 'a.ply'], {files: molar})).said.join('\n'), words);
  const {said} = await seven.run(['--threads', '3', 'reconstruct', 'tooth.json', '-o', 'a.ply'], {files: molar});
  assert.match(said.join('\n'), /s on 3 threads/);
});

const lines = [
  ['molar by DT', molar, ['reconstruct', 'tooth.json', '-o', 'a.ply', '-o', 'a.vtu', '-o', 'a.glb', '--report', 'report.json']],
  ['molar by DB', molar, ['reconstruct', 'tooth.json', '--method', 'db', '--grid', '64', '-o', 'a.ply']],
  ['incisor simplified', incisor, ['reconstruct', 'tooth.json', '--triangles', '4000', '-o', 'a.ply']],
  ['incisor as a partition', incisor, ['reconstruct', 'tooth.json', '--partition', '-o', 'a.msh', '--report', 'report.json']],
  ['canals of the incisor', incisor, ['anatomy', 'tooth.json', '-o', 'a.json']],
];
for (const [name, files, line] of lines)
  test(`${name}: the same bytes on 1, 2 and 7 threads, run after run`, async () => {
    const expected = await one.run(line, {files});
    assert.equal(expected.exitCode, 0, expected.complained.join());
    for (const engine of [two, seven, seven]) assert.deepEqual(differing(await engine.run(line, {files}), expected), [], `${engine.threads} threads`);
  });

test('bad stacks are refused alike, whichever thread meets what is wrong first', async () => {
  for (const [name, bytes] of corpus('bad').filter((_, n) => n % 3 === 0)) {
    const [a, b] = [await one.run(['check', name], {files: {[name]: bytes}}), await seven.run(['check', name], {files: {[name]: bytes}})];
    assert.deepEqual([b.exitCode, b.complained], [a.exitCode, a.complained]);
  }
});

test("a page's model is saved after its threads have ended, and progress is told", async () => {
  const stages = new Set(), page = await seven.run(['web', 'tooth.json', '-o', 'a.html'], {files: incisor, onProgress: stage => stages.add(stage)});
  assert.ok(stages.size > 3, [...stages].join());
  const saved = await page.save({output: ['b.stl']}), made = await one.run(['reconstruct', 'tooth.json', '-o', 'b.stl'], {files: incisor});
  assert.deepEqual(differing(saved, made), []);
});

test('a script that has made its models ends', () => {
  const script = `import {load} from ${JSON.stringify(pathToFileURL(join(dist, 'npm/index.mjs')).href)};
    const engine = await load({threads: 4});
    for (let n = 0; n < 3; ++n) console.log((await engine.run(['sample', 'incisor', '-o', 'a.json'])).exitCode);`;
  assert.equal(execFileSync(process.execPath, ['--input-type=module', '-e', script], {encoding: 'utf8', timeout: 60_000}), '0\n0\n0\n');
});

test('bytes of its own are run on one thread', async () => {
  assert.equal((await load({wasm: readFileSync(join(dist, 'npm/odontoscope.wasm'))})).threads, 1);
  await assert.rejects(load({threads: 2, threaded: pathToFileURL('/nowhere/').href}));
});
