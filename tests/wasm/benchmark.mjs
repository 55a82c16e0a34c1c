// How much longer the engine takes as WebAssembly than the native program, each on one thread; each three times, the shortest counts.
//   node tests/wasm/benchmark.mjs
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {data, inWasm, native} from './support.mjs';

const inputs = ['incisor', 'premolar', 'molar'].map(tooth => [`sample ${tooth}`, ['tooth.json'], native(['sample', tooth, '-o', 'tooth.json'], {}).files]);
if (existsSync(join(data, 'ct_molar/tooth.nrrd'))) inputs.push(['CT molar', ['tooth.nrrd', '--iso', '120', '--min-area', '4'], {'tooth.nrrd': readFileSync(join(data, 'ct_molar/tooth.nrrd'))}]);

console.log('| input | method | native, s | wasm, s | ratio |\n|---|---|---|---|---|');
for (const [name, input, files] of inputs)
  for (const [method, options] of [['DT', []], ['DB, grid 96', ['--method', 'db', '--grid', '96']]]) {
    const line = ['reconstruct', ...input, ...options, '-o', 'made.glb'], runs = {native: [], wasm: []};
    for (let i = 0; i < Number(process.env.ODONTOSCOPE_RUNS ?? 3); ++i) {
      runs.native.push(native(line, files).seconds);
      runs.wasm.push((await inWasm(line, files)).seconds);
    }
    const [there, here] = [Math.min(...runs.native), Math.min(...runs.wasm)];
    console.log(`| ${name} | ${method} | ${there.toFixed(2)} | ${here.toFixed(2)} | ${(here / there).toFixed(2)} |`);
  }
