// How much longer the engine takes as WebAssembly than the native program, each on one thread; each three times, the shortest counts.
//   node tests/wasm/benchmark.mjs
//   ODONTOSCOPE_THREADS=2 node tests/wasm/benchmark.mjs     against the engine for several threads, too
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {data, inWasm, native, odontoscope} from './support.mjs';

const inputs = ['incisor', 'premolar', 'molar'].map(tooth => [`sample ${tooth}`, ['tooth.json'], native(['sample', tooth, '-o', 'tooth.json'], {}).files]);
if (existsSync(join(data, 'ct_molar/tooth.nrrd'))) inputs.push(['CT molar', ['tooth.nrrd', '--iso', '120', '--min-area', '4'], {'tooth.nrrd': readFileSync(join(data, 'ct_molar/tooth.nrrd'))}]);

const threads = Number(process.env.ODONTOSCOPE_THREADS ?? 1), several = threads > 1 ? await odontoscope.load({threads}) : null;
console.log(`| input | method | native, s | wasm, s | ratio |${several ? ` ${threads} threads, s | faster |` : ''}\n|---|---|---|---|---|${several ? '---|---|' : ''}`);
for (const [name, input, files] of inputs)
  for (const [method, options] of [['DT', []], ['DB, grid 96', ['--method', 'db', '--grid', '96']]]) {
    const line = ['reconstruct', ...input, ...options, '-o', 'made.glb'], runs = {native: [], wasm: [], several: []};
    for (let i = 0; i < Number(process.env.ODONTOSCOPE_RUNS ?? 3); ++i) {
      runs.native.push(native(line, files).seconds);
      runs.wasm.push((await inWasm(line, files)).seconds);
      if (several) runs.several.push((await inWasm(line, files, several)).seconds);
    }
    const [there, here] = [Math.min(...runs.native), Math.min(...runs.wasm)];
    const more = several ? ` ${Math.min(...runs.several).toFixed(2)} | ${(here / Math.min(...runs.several)).toFixed(2)} |` : '';
    console.log(`| ${name} | ${method} | ${there.toFixed(2)} | ${here.toFixed(2)} | ${(here / there).toFixed(2)} |${more}`);
  }
