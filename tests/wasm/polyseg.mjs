// The same contours given to @icr/polyseg-wasm (SlicerRT's rule for contours, as viewers in the browser use it) and to this engine, both as WebAssembly in
// Node.js: seconds, and what `check` says of each surface.
//   npm install --prefix /tmp/polyseg @icr/polyseg-wasm@0.4.0
//   node tests/wasm/polyseg.mjs /tmp/polyseg
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {engine, inWasm, native} from './support.mjs';

if (!process.argv[2]) {
  console.error('polyseg.mjs: name the folder that @icr/polyseg-wasm was installed into');
  process.exit(2);
}
const dist = join(process.argv[2], 'node_modules/@icr/polyseg-wasm/dist');
// Its module is written for bundlers, and its launcher for a page: a window is all that it asks for.
globalThis.window = globalThis;
const launcher = new Function(`${readFileSync(join(dist, 'ICRPolySeg.js'), 'utf8').replace(/export default[^;]*;?\s*$/, '')}\nreturn ICRPolySegApp;`)();
const polyseg = await launcher({wasmBinary: readFileSync(join(dist, 'ICRPolySeg.wasm'))});

function contoursOf(stack, structure) {
  const points = [], counts = [];
  for (const {z, contours} of stack.slices)
    for (const contour of contours.filter(one => one.structure === structure)) {
      counts.push(contour.points.length);
      for (const [x, y] of contour.points) points.push(x, y, z);
    }
  return {points: new Float32Array(points), counts: new Float32Array(counts)};
}

function asObj({points, polys}) {
  const lines = [];
  for (let i = 0; i < points.length; i += 3) lines.push(`v ${points[i]} ${points[i + 1]} ${points[i + 2]}`);
  for (let i = 0; i < polys.length; i += polys[i] + 1) lines.push(`f ${[...polys.slice(i + 1, i + 1 + polys[i])].map(k => k + 1).join(' ')}`);
  return lines.join('\n');
}

/// "closed, oriented manifold", or what is wanting.
async function verdict(name, bytes) {
  const {exitCode, said} = await engine.run(['check', name], {files: {[name]: bytes}});
  return exitCode === 0 ? 'closed, oriented manifold' : said.find(line => line.includes('wanting:'))?.trim() ?? said.at(-1);
}

console.log('| tooth | engine | s | structure | check |\n|---|---|---|---|---|');
for (const tooth of process.argv.length > 3 ? process.argv.slice(3) : ['incisor', 'premolar', 'molar']) {
  const {files} = native(['sample', tooth, '-o', 'tooth.json'], {}), stack = JSON.parse(files['tooth.json'].toString());
  const structures = [...new Set(stack.slices.flatMap(slice => slice.contours.map(contour => contour.structure)))];
  const ours = await inWasm(['reconstruct', 'tooth.json', '-o', 'tooth.ply'], files);
  console.log(`| ${tooth} | Odontoscope, DT | ${ours.seconds.toFixed(1)} | all | ${await verdict('tooth.ply', ours.files['tooth.ply'])} |`);
  for (const structure of structures) {
    const {points, counts} = contoursOf(stack, structure), begin = performance.now(), surface = polyseg.convertContourRoiToSurface(points, counts);
    console.log(`| ${tooth} | polyseg | ${((performance.now() - begin) / 1000).toFixed(1)} | ${structure} | ${await verdict('surface.obj', asObj(surface))} |`);
  }
}
