// Compressed DICOM in the engine as WebAssembly: what other programs packed is read to the native program's bytes, and what is damaged is refused in its words.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {test} from 'node:test';
import {fragmentAt, series, syntaxOf} from './dicom_series.mjs';
import {engine, folder, inWasm, same, skip} from './support.mjs';

for (const tool of ['gdcmconv', 'dcmcjpeg', 'dcmconv', 'dcmcjpls'])
  if (spawnSync(tool, ['--version']).error) skip(`${tool} was not found`);

const eight = {bits: 8, signed: false}, twelve = {bits: 12, signed: false};
const kinds = [
  ['JPEG lossless, any predictor', '1.2.840.10008.1.2.4.57', ['dcmcjpeg', '+el', 'in', 'out'], twelve],
  ['JPEG lossless', '1.2.840.10008.1.2.4.70', ['gdcmconv', '--jpeg', 'in', 'out']],
  ['JPEG lossless of DCMTK', '1.2.840.10008.1.2.4.70', ['dcmcjpeg', '+e1', 'in', 'out'], {bits: 16, signed: false}],
  ['JPEG-LS', '1.2.840.10008.1.2.4.80', ['gdcmconv', '--jpegls', 'in', 'out']],
  ['JPEG-LS of DCMTK', '1.2.840.10008.1.2.4.80', ['dcmcjpls', '+el', 'in', 'out'], twelve],
  ['JPEG-LS near lossless', '1.2.840.10008.1.2.4.81', ['gdcmconv', '--jpegls', '--lossy', '-e', '3', 'in', 'out']],
  ['JPEG 2000', '1.2.840.10008.1.2.4.90', ['gdcmconv', '--j2k', 'in', 'out']],
  ['JPEG 2000 of 12 bits', '1.2.840.10008.1.2.4.90', ['gdcmconv', '--j2k', 'in', 'out'], twelve],
  ['JPEG 2000 with losses', '1.2.840.10008.1.2.4.91', ['gdcmconv', '--j2k', '--lossy', '--irreversible', '-r', '8', 'in', 'out'], twelve],
  ['RLE', '1.2.840.10008.1.2.5', ['gdcmconv', '--rle', 'in', 'out']],
  ['JPEG lossless in pieces', '1.2.840.10008.1.2.4.70', ['dcmcjpeg', '+e1', '+fs', '1', 'in', 'out'], {bits: 16, signed: false}],
  ['deflated', '1.2.840.10008.1.2.1.99', ['dcmconv', '+td', 'in', 'out']],
  ['baseline JPEG', '1.2.840.10008.1.2.4.50', ['dcmcjpeg', '+eb', 'in', 'out'], eight],
  ['extended JPEG of 12 bits', '1.2.840.10008.1.2.4.51', ['dcmcjpeg', '+ee', 'in', 'out'], twelve],
];
const made = new Map(kinds.map(([name, , line, pixelsAre]) => [name, series(folder, name.replace(/\W/g, '-'), line, pixelsAre)]));
const isoOf = pixelsAre => pixelsAre === eight ? '60' : pixelsAre === twelve ? '500' : '300';

for (const [name, syntax, , pixelsAre] of kinds)
  test(`a series in ${name} becomes the native program's contours and model`, async () => {
    const files = made.get(name);
    assert.equal(syntaxOf(files['series/0.dcm']), syntax);
    const {here} = await same(['contours', 'series', '--iso', isoOf(pixelsAre), '-o', 'ring.json'], files);
    assert.equal(here.exitCode, 0, here.complained.join());
    await same(['reconstruct', 'series', '--iso', isoOf(pixelsAre), '-o', 'ring.ply', '-o', 'ring.vtu', '--report', 'report.json'], files);
  });

test('what loses nothing has the contours of the series as it was', async () => {
  const contours = async files => Buffer.from((await inWasm(['contours', 'series', '--iso', '300', '-o', 'ring.json'], files)).files['ring.json']).toString();
  const plain = await contours(series(folder, 'plain', null));
  for (const name of ['JPEG lossless', 'JPEG-LS', 'JPEG 2000', 'RLE', 'deflated']) assert.equal(await contours(made.get(name)), plain, name);
  assert.notEqual(await contours(made.get('JPEG-LS near lossless')), plain);
});

/// The same series with one slice changed.
function changed(files, change) {
  const bytes = Buffer.from(files['series/3.dcm']);
  return {...files, 'series/3.dcm': change(bytes, fragmentAt(bytes)) ?? bytes};
}

const damages = {
  'cut short': (bytes, at) => bytes.subarray(0, at + 40),
  'a fragment longer than the file': (bytes, at) => { bytes.writeUInt32LE(0x7ffffff0, at - 4); },
  'an empty fragment': (bytes, at) => Buffer.concat([bytes.subarray(0, at - 4), Buffer.alloc(4), Buffer.from([0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0])]),
  'zeros': (bytes, at) => { bytes.fill(0, at, bytes.length - 8); },
  'noise': (bytes, at) => { for (let n = at; n < bytes.length - 8; ++n) bytes[n] = n * 7919 % 251; },
  'another size within': (bytes, at) => {   // of JPEG and JPEG-LS: the frame's head; of JPEG 2000: SIZ
    for (let n = at; n < at + 200; ++n)
      if (bytes[n] === 0xff && [0xc0, 0xc1, 0xc3, 0xf7].includes(bytes[n + 1])) return void bytes.writeUInt32BE(0xfff0fff0, n + 5);
      else if (bytes[n] === 0xff && bytes[n + 1] === 0x51) return void bytes.writeUInt32BE(0x7ffffff0, n + 6);
    bytes.writeUInt32LE(0xfffffff0, at);   // of RLE: the number of segments
  },
  'another syntax': bytes => {
    const syntax = syntaxOf(bytes), at = bytes.indexOf(syntax, 'latin1');
    bytes.write(syntax.replace(/.$/, digit => digit === '0' ? '1' : '0'), at, 'latin1');
  },
};

for (const [damage, change] of Object.entries(damages))
  test(`${damage}: refused as natively, whatever the packing`, async () => {
    let refused = 0;
    for (const [name, files] of made) {
      if (name === 'deflated') continue;
      const {here} = await same(['contours', 'series', '--iso', '300', '-o', 'ring.json'], changed(files, change));
      assert.ok([0, 3].includes(here.exitCode), `${name}: ${here.complained}`);
      refused += here.exitCode === 3;
    }
    assert.ok(refused >= 3, `${refused} refused`);
  });

test('a head that claims other sizes than its pixels have is refused, and the next run goes well', async () => {
  const files = made.get('JPEG lossless');
  for (const [tag, value] of [[0x10, 65535], [0x11, 0], [0x10, 47], [0x101, 17], [0x100, 32]]) {
    const claim = changed(files, bytes => {
      bytes.writeUInt16LE(value, bytes.indexOf(Buffer.from([0x28, 0, tag & 255, tag >> 8, 0x55, 0x53])) + 8);
    });
    const {here} = await same(['contours', 'series', '--iso', '300', '-o', 'ring.json'], claim);
    assert.equal(here.exitCode, 3, `${tag} ${value}: ${here.complained}`);
  }
  assert.equal((await engine.run(['contours', 'series', '--iso', '300', '-o', 'ring.json'], {files})).exitCode, 0);
});

test('bytes that flip at random end in a model or a refusal, never in a bug', async () => {
  let seed = 7;
  const random = below => { seed = (seed * 48271) % 2147483647; return seed % below; };
  for (const [name, files] of made)
    for (let run = 0; run < 12; ++run) {
      const flipped = changed(files, (bytes, at) => { for (let n = 0; n < 4; ++n) bytes[at + random(bytes.length - at)] ^= 1 << random(8); });
      const {exitCode, complained} = await inWasm(['contours', 'series', '--iso', '300', '-o', 'ring.json'], flipped);
      assert.ok([0, 3].includes(exitCode), `${name}, ${run}: ${exitCode} ${complained}`);
    }
});
