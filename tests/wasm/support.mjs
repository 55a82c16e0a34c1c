// What the tests of the engine as WebAssembly have in common: the package under test, the native program beside it, inputs.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, relative} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
export const program = process.env.ODONTOSCOPE_PROGRAM ?? join(root, 'build/release/engine/app/odontoscope');
export const dist = process.env.ODONTOSCOPE_WASM_DIST ?? join(root, 'build/wasm/dist');
export const data = process.env.ODONTOSCOPE_DATA ?? join(root, '../shared/data');

export function skip(reason) {
  console.log(`SKIPPED: ${reason}`);
  process.exit(0);
}

if (!existsSync(join(dist, 'npm/odontoscope.wasm'))) skip('the engine for browsers is not built (web/wasm/build)');
if (!existsSync(program)) skip(`there is no program to compare with at ${program}`);

export const odontoscope = await import(pathToFileURL(join(dist, 'npm/index.mjs')).href);
/// On one thread, unless ODONTOSCOPE_WASM_THREADS says how many.
export const engine = await odontoscope.load({threads: Number(process.env.ODONTOSCOPE_WASM_THREADS ?? 1)});

export const folder = mkdtempSync(join(tmpdir(), 'odontoscope-wasm-'));
process.on('exit', () => rmSync(folder, {recursive: true, force: true}));

function filesIn(at, from = at) {
  return readdirSync(at).flatMap(name => {
    const path = join(at, name);
    return statSync(path).isDirectory() ? filesIn(path, from) : [relative(from, path)];
  });
}

/// Of the corpus: [name, bytes].
export const corpus = kind => readdirSync(join(root, 'tests/corpus', kind)).filter(name => name.endsWith('.json') && name !== 'expected.json').sort()
  .map(name => [name, readFileSync(join(root, 'tests/corpus', kind, name))]);

/// A folder's files by their names within it, as the package wants them.
export const filesOf = (at, within) => Object.fromEntries(filesIn(at).map(name => [`${within}/${name}`, readFileSync(join(at, name))]));

/// The native program on one thread, in a folder of its own with these files: as Engine.run answers.
export function native(words, files) {
  const at = mkdtempSync(join(folder, 'run-'));
  for (const [name, bytes] of Object.entries(files)) {
    mkdirFor(join(at, name));
    writeFileSync(join(at, name), bytes);
  }
  const begin = performance.now();
  const ended = spawnSync(program, ['--threads', '1', ...words], {cwd: at, maxBuffer: 1 << 28});
  const seconds = (performance.now() - begin) / 1000;
  const lines = text => text.toString().split('\n').slice(0, -1);
  const made = Object.fromEntries(filesIn(at).filter(name => !(name in files)).map(name => [name, readFileSync(join(at, name))]));
  rmSync(at, {recursive: true});
  return {exitCode: ended.status, said: lines(ended.stdout), complained: lines(ended.stderr).filter(line => line.startsWith('odontoscope: ')), files: made, seconds};
}

export async function inWasm(words, files, by = engine) {
  const begin = performance.now(), result = await by.run(words, {files});
  return {...result, seconds: (performance.now() - begin) / 1000};
}

/// Lines without those that tell seconds, which differ.
const words = lines => lines.filter(line => !/ s on \d+ thread/.test(line));

/// Both programs end alike, say the same and write the same bytes.
export async function same(line, files) {
  const there = native(line, files), here = await inWasm(line, files);
  const told = `${line.join(' ')}\nnative ${there.exitCode}: ${there.complained.join('\n')}\nwasm ${here.exitCode}: ${here.complained.join('\n')}`;
  assert.equal(here.exitCode, there.exitCode, told);
  assert.deepEqual(differing(here, there), [], told);
  assert.deepEqual(here.complained, there.complained, told);
  assert.deepEqual(words(here.said), words(there.said));
  return {there, here};
}

/// A report without what differs from run to run: seconds, memory, and threads.
export function timeless(json) {
  const without = value => Array.isArray(value) ? value.map(without)
    : value && typeof value === 'object' ? Object.fromEntries(Object.entries(value).filter(([key]) => !/second|_ms$|times|memory|^threads$/.test(key)).map(([key, inner]) => [key, without(inner)]))
    : value;
  return JSON.stringify(without(JSON.parse(json.toString())));
}

import {mkdirSync, writeFileSync} from 'node:fs';
function mkdirFor(path) { mkdirSync(dirname(path), {recursive: true}); }

/// Names of the files that differ, or that only one has.
export function differing(one, other) {
  const names = new Set([...Object.keys(one.files), ...Object.keys(other.files)]);
  return [...names].filter(name => {
    const a = one.files[name], b = other.files[name];
    if (!a || !b) return true;
    if (name.endsWith('report.json')) return timeless(Buffer.from(a)) !== timeless(Buffer.from(b));
    return Buffer.compare(Buffer.from(a), Buffer.from(b)) !== 0;
  });
}
