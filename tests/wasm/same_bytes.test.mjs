// The engine as WebAssembly against the native program: the same files, the same words, the same refusals.
import assert from 'node:assert/strict';
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {corpus, data, filesOf, native, same} from './support.mjs';

const everyFormat = ['.glb', '.gltf', '.stl', '.ply', '.obj', '.3mf', '.wrl', '.x3d', '.vtp', '.vtu', '.msh', '.inp'].flatMap(ending => ['-o', `made${ending}`]);
const someFormats = ['-o', 'made.ply', '-o', 'made.vtu', '--report', 'report.json'];

for (const kind of ['good', 'engine'])
  test(`every stack of corpus/${kind} gives the same tetrahedra, surface and report`, async () => {
    let models = 0;
    for (const [name, bytes] of corpus(kind)) {
      const {here} = await same(['reconstruct', name, ...someFormats], {[name]: bytes});
      models += here.exitCode === 0 ? 1 : 0;
    }
    assert.ok(models >= 10, `${models} models`);
  });

test('every bad stack is refused in the same words', async () => {
  const stacks = corpus('bad');
  assert.ok(stacks.length > 30);
  for (const [name, bytes] of stacks) {
    const {here} = await same(['check', name], {[name]: bytes});
    assert.notEqual(here.exitCode, 0, name);
  }
});

for (const tooth of ['incisor', 'premolar', 'molar'])
  test(`the sample ${tooth} has the same contours, and becomes the same model in every format`, async () => {
    const {there} = await same(['sample', tooth, '-o', 'tooth.json'], {});
    await same(['reconstruct', 'tooth.json', ...everyFormat, '--report', 'report.json', '--tours'], {'tooth.json': there.files['tooth.json']});
  });

test('DB, simplified, partitioned and compressed models, anatomy and page are the same', async () => {
  const {files} = native(['sample', 'incisor', '-o', 'tooth.json'], {});
  await same(['reconstruct', 'tooth.json', '--method', 'db', '--grid', '48', '--cases', 'classic', '-o', 'made.ply', '--report', 'report.json'], files);
  await same(['reconstruct', 'tooth.json', '--triangles', '3000', '--compress', '-o', 'made.glb', '--report', 'report.json'], files);
  await same(['reconstruct', 'tooth.json', '--partition', '-o', 'made.msh', '--report', 'report.json'], files);
  await same(['anatomy', 'tooth.json', '-o', 'anatomy.json', '-o', 'anatomy.csv'], files);
  await same(['web', 'tooth.json', '--db', '--grid', '32', '-o', 'page.html'], files);
});

test('a mesh is checked, and cut into contours, in the same words', async () => {
  const {files} = native(['reconstruct', 'tooth.json', '-o', 'tooth.stl'], native(['sample', 'incisor', '-o', 'tooth.json'], {}).files);
  await same(['check', 'tooth.stl'], files);
  await same(['contours', 'tooth.stl', '--spacing-z', '0.5', '-o', 'cut.json'], files);
});

test('contours of other programs, and a CT volume, become the same models', async t => {
  if (!existsSync(join(data, 'ct_molar/tooth.nrrd'))) return t.skip('the real data sets are not here');
  await same(['contours', 'rtss.dcm', '-o', 'contours.json'], {'rtss.dcm': readFileSync(join(data, 'rtstruct/rtss.dcm'))});
  const series = filesOf(join(data, 'reconstruct_series'), 'series'), head = Object.keys(series).find(name => name.endsWith('.ser'));
  await same(['contours', head, '-o', 'contours.json'], series);
  await same(['reconstruct', 'tooth.nrrd', '--iso', '120', '--min-area', '4', '-o', 'tooth.ply', '--report', 'report.json'], {'tooth.nrrd': readFileSync(join(data, 'ct_molar/tooth.nrrd'))});
});
