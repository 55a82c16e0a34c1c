// gltf-validator and manifold-3d look at the files; each must also turn a mutant down.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {bytesOf, glbOf, glbParts, importFile, made, needPackages, odontoscope, packageNamed} from './support.mjs';

needPackages();
const validator = packageNamed('gltf-validator');
const {default: loadManifold} = await importFile('manifold-3d/manifold.js');
const manifold = await loadManifold();
manifold.setup();

odontoscope('sample', 'molar', '-o', 'molar.json');
odontoscope('reconstruct', 'molar.json', '-o', 'molar.glb', '-o', 'molar.gltf', '--report', 'molar-report.json');
odontoscope('reconstruct', 'molar.json', '--tours', '-o', 'tours.glb', '-o', 'tours.gltf');
odontoscope('reconstruct', 'molar.json', '--tours', '--compress', '-o', 'compressed.glb', '-o', 'compressed.gltf');
odontoscope('sample', 'molar', '--filled-dentine', '-o', 'filled.json');
odontoscope('reconstruct', 'filled.json', '--together', 'dentine,pulp', '-o', 'hollow.glb');
odontoscope('reconstruct', 'molar.json', '--method', 'db', '--grid', '40', '--cases', 'classic-unoriented', '-o', 'db.glb');
const dt = ['molar.glb', 'hollow.glb'];
const ct = process.env.ODONTOSCOPE_DATA && join(process.env.ODONTOSCOPE_DATA, 'ct_molar/tooth.nrrd');
if (ct) {
  odontoscope('reconstruct', ct, '--iso', '120', '--min-area', '4', '-o', 'ct.glb');
  dt.push('ct.glb');
} else console.log('the CT molar is not here, and not judged');

async function validated(bytes) {
  const {issues} = await validator.validateBytes(bytes, {maxIssues: 20});
  return {...issues, codes: issues.messages.map(m => m.code), words: issues.messages.map(m => `${m.code} ${m.pointer ?? ''}: ${m.message}`).join('\n')};
}

for (const name of [...dt, 'db.glb', 'molar.gltf', 'tours.glb', 'tours.gltf']) {
  test(`gltf-validator finds nothing wrong with ${name}`, async () => {
    const found = await validated(bytesOf(name));
    assert.equal(found.numErrors + found.numWarnings, 0, found.words);
  });
}

for (const name of ['compressed.glb', 'compressed.gltf']) {
  test(`gltf-validator knows no meshopt, and finds nothing else with ${name}`, async () => {
    const found = await validated(bytesOf(name));
    assert.equal(found.numErrors + found.numWarnings, 0, found.words);
    assert.deepEqual(found.codes, ['UNSUPPORTED_EXTENSION', 'UNUSED_OBJECT'], found.words);   // it sees no use of the buffer that the extension reads
  });
}

test('gltf-validator finds what is wrong with mutants', async () => {
  const {json, binary} = glbParts(bytesOf('molar.glb'));
  const position = json.accessors[json.meshes[0].primitives[0].attributes.POSITION];
  const outOfBounds = structuredClone(json), longNormal = binary.slice();
  outOfBounds.accessors[json.meshes[0].primitives[0].attributes.POSITION].max[0] -= 0.001;
  const normals = json.bufferViews[json.accessors[json.meshes[0].primitives[0].attributes.NORMAL].bufferView];
  new DataView(longNormal.buffer, normals.byteOffset ?? 0).setFloat32(0, 7, true);
  const strayIndex = binary.slice(), indices = json.bufferViews[json.accessors[json.meshes[0].primitives[0].indices].bufferView];
  new DataView(strayIndex.buffer, indices.byteOffset ?? 0).setUint32(0, position.count, true);
  const tours = glbParts(bytesOf('tours.glb')), backwards = tours.binary.slice();
  const times = tours.json.bufferViews[tours.json.accessors[tours.json.animations[0].samplers[0].input].bufferView];
  new DataView(backwards.buffer, times.byteOffset).setFloat32(8, 0, true);
  for (const mutant of [{json: outOfBounds, binary}, {json, binary: longNormal}, {json, binary: strayIndex}, {json: tours.json, binary: backwards}])
    assert.notEqual((await validated(glbOf(mutant))).numErrors, 0);
});

/// Each structure's triangles, all nodes together, vertices of one place joined: {structure, volume, positions, triangles}. Millimetres.
function structuresIn(bytes) {
  const {json, binary} = glbParts(bytes), found = new Map();
  const numbers = (index, Type) => {
    const accessor = json.accessors[index], view = json.bufferViews[accessor.bufferView], per = accessor.type === 'VEC3' ? 3 : 1;
    const from = view.byteOffset ?? 0;
    return new Type(binary.slice(from, from + 4 * per * accessor.count).buffer);
  };
  for (const node of json.nodes.filter(node => node.mesh !== undefined)) {
    const {structure, volume_mm3} = node.extras;
    if (!found.has(structure)) found.set(structure, {structure, volume: 0, positions: [], triangles: [], known: new Map()});
    const solid = found.get(structure), [primitive] = json.meshes[node.mesh].primitives;
    const points = numbers(primitive.attributes.POSITION, Float32Array);
    solid.volume += volume_mm3;
    for (const v of numbers(primitive.indices, Uint32Array)) {
      const place = [points[3 * v], points[3 * v + 1], points[3 * v + 2]], key = place.join();
      if (!solid.known.has(key)) {
        solid.known.set(key, solid.known.size);
        solid.positions.push(...place.map(metres => 1000 * metres));
      }
      solid.triangles.push(solid.known.get(key));
    }
  }
  return [...found.values()];
}

function accepted({positions, triangles}) {
  const mesh = new manifold.Mesh({numProp: 3, vertProperties: Float32Array.from(positions), triVerts: Uint32Array.from(triangles)});
  const solid = new manifold.Manifold(mesh);
  const result = {volume: solid.volume(), status: solid.status(), triangles: solid.numTri()};
  solid.delete();
  return result;
}

for (const name of dt) {
  test(`manifold-3d takes every solid of ${name}, with our volume`, () => {
    for (const solid of structuresIn(bytesOf(name))) {
      const judged = accepted(solid);
      assert.equal(judged.status, 'NoError', solid.structure);
      assert.ok(judged.volume > 0, solid.structure);
      assert.ok(Math.abs(judged.volume - solid.volume) < 1e-4 * solid.volume, `${solid.structure}: ${judged.volume} and ${solid.volume} mm3`);
    }
  });
}

test('the volumes compared are those of the tetrahedra', () => {
  const {structures} = JSON.parse(readFileSync(made('molar-report.json')));
  const told = new Map(structures.map(one => [one.structure, one.tetrahedra.volume]));
  for (const {structure, volume} of structuresIn(bytesOf('molar.glb'))) assert.ok(Math.abs(volume - told.get(structure)) < 1e-9 * volume, `${structure}: ${volume} and ${told.get(structure)}`);
});

test('manifold-3d turns mutants and DB down', () => {
  const [solid] = structuresIn(bytesOf('molar.glb')), {positions, triangles} = solid;
  const flipped = [...triangles], missing = triangles.slice(3), doubled = [...triangles, ...triangles.slice(0, 3)];
  [flipped[0], flipped[1]] = [flipped[1], flipped[0]];
  for (const mutant of [flipped, missing, doubled]) assert.throws(() => accepted({positions, triangles: mutant}));
  const inverted = accepted({positions, triangles: [...triangles].reverse()});
  assert.ok(inverted.volume < 0, `all inverted: ${inverted.volume}`);
  assert.throws(() => structuresIn(bytesOf('db.glb')).forEach(accepted));
});
