// The same contours given to @icr/polyseg-wasm (SlicerRT's rule for contours, as viewers in the browser use it) and to this engine, both as WebAssembly in
// Node.js: seconds, and what `check` says of each surface.
//   npm install --prefix /tmp/polyseg @icr/polyseg-wasm@0.4.0
//   node tests/wasm/polyseg.mjs /tmp/polyseg [TOOTH ...]
//   ODONTOSCOPE_TRUTH=build/release/tests/truth/odontoscope_truth node tests/wasm/polyseg.mjs /tmp/polyseg [SEED ...]     against teeth with known truth, and how far off
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {engine, folder, inWasm, native} from './support.mjs';

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

/// Of asObj's text.
function asPly(obj) {
  const lines = obj.split('\n'), points = lines.filter(line => line.startsWith('v ')), faces = lines.filter(line => line.startsWith('f '));
  return ['ply', 'format ascii 1.0', `element vertex ${points.length}`, 'property float x', 'property float y', 'property float z', `element face ${faces.length}`,
    'property list uchar int vertex_indices', 'end_header', ...points.map(line => line.slice(2)),
    ...faces.map(line => { const corners = line.slice(2).split(' ').map(k => k - 1); return `${corners.length} ${corners.join(' ')}`; }), ''].join('\n');
}

/// "closed, oriented manifold", or what is wanting.
async function verdict(name, bytes) {
  const {exitCode, said} = await engine.run(['check', name], {files: {[name]: bytes}});
  return exitCode === 0 ? 'closed, oriented manifold' : said.find(line => line.includes('wanting:'))?.trim() ?? said.at(-1);
}

const wasmOfOne = structure => ['reconstruct', 'tooth.json', '--structure', structure, '-o', 'tooth.ply'];

/// One structure by both: [engine, seconds, file's name, bytes].
async function byBoth(stack, files, structure) {
  const ours = await inWasm(wasmOfOne(structure), files);
  const {points, counts} = contoursOf(stack, structure), begin = performance.now(), surface = polyseg.convertContourRoiToSurface(points, counts);
  const seconds = (performance.now() - begin) / 1000;
  return [['Odontoscope, DT', ours.seconds, 'tooth.ply', ours.files['tooth.ply']], ['polyseg', seconds, 'surface.obj', asObj(surface)]];
}

const structuresOf = stack => [...new Set(stack.slices.flatMap(slice => slice.contours.map(contour => contour.structure)))];

async function samples(teeth) {
  console.log('| tooth | structure | engine | s | check |\n|---|---|---|---|---|');
  for (const tooth of teeth) {
    const {files} = native(['sample', tooth, '-o', 'tooth.json'], {}), stack = JSON.parse(files['tooth.json'].toString());
    for (const structure of structuresOf(stack))
      for (const [who, seconds, name, bytes] of await byBoth(stack, files, structure)) console.log(`| ${tooth} | ${structure} | ${who} | ${seconds.toFixed(1)} | ${await verdict(name, bytes)} |`);
  }
}

/// Teeth with known truth, which the program odontoscope_truth makes and holds the surfaces against.
async function family(truth, seeds) {
  console.log('| seed | structure | engine | s | check | mean distance, mm | largest | pieces, handles, bubbles (truth) |\n|---|---|---|---|---|---|---|---|');
  for (const seed of seeds) {
    execFileSync(truth, ['tooth', '--seed', seed, '--spacing', '0.25', '-o', join(folder, 'tooth.json')], {stdio: 'ignore'});
    const files = {'tooth.json': readFileSync(join(folder, 'tooth.json'))}, stack = JSON.parse(files['tooth.json'].toString());
    for (const structure of structuresOf(stack))
      for (const [who, seconds, name, bytes] of await byBoth(stack, files, structure)) {
        const said = await verdict(name, bytes);
        // It reads what we write: degenerate triangles and open borders stay.
        const ply = name.endsWith('.ply') ? bytes : asPly(bytes);
        writeFileSync(join(folder, 'held.ply'), ply);
        const held = JSON.parse(execFileSync(truth, ['mesh', '--seed', seed, `${structure}=${join(folder, 'held.ply')}`]).toString().split('\n')[0]);
        console.log(`| ${seed} | ${structure} | ${who} | ${seconds.toFixed(1)} | ${said} | ${held.mean.toFixed(4)} | ${held.largest.toFixed(2)} | ${held.found?.join(', ') ?? 'open'} (${held.true.join(', ')}) |`);
      }
  }
}

const asked = process.argv.slice(3), truth = process.env.ODONTOSCOPE_TRUTH;
await (truth ? family(truth, asked.length ? asked : ['1', '2']) : samples(asked.length ? asked : ['incisor', 'premolar', 'molar']));
