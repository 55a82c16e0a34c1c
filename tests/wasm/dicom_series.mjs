// A small DICOM series, and what gdcmconv and DCMTK make of it: one file a slice of a tapering ring, 16 bits.
import {spawnSync} from 'node:child_process';
import {mkdirSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

export const size = 48, slices = 7;

function element(group, number, vr, value) {
  let bytes = Buffer.isBuffer(value) ? value : Buffer.from(value, 'latin1');
  if (bytes.length % 2) bytes = Buffer.concat([bytes, Buffer.from(vr === 'UI' ? '\0' : ' ')]);
  const long = ['OB', 'OW'].includes(vr), head = Buffer.alloc(long ? 12 : 8);
  head.writeUInt16LE(group, 0);
  head.writeUInt16LE(number, 2);
  head.write(vr, 4, 'latin1');
  if (long) head.writeUInt32LE(bytes.length, 8);
  else head.writeUInt16LE(bytes.length, 6);
  return Buffer.concat([head, bytes]);
}

const short = value => { const bytes = Buffer.alloc(2); bytes.writeUInt16LE(value); return bytes; };

/// Grey values of slice k: hard within the ring, soft outside, with noise that no coder finds trivial.
function pixels(k, {bits, signed}) {
  const raw = Buffer.alloc(size * size * (bits > 8 ? 2 : 1)), top = bits > 8 ? 1800 : 200;
  let noise = 12345 + k;
  for (let y = 0; y < size; ++y)
    for (let x = 0; x < size; ++x) {
      noise = (noise * 1103515245 + 12345) % 2147483648;
      const away = Math.hypot(x - size / 2 + 0.3, y - size / 2 - 0.2), hard = Math.max(0, Math.min(1, (17 - k - away) / 4)) * Math.max(0, Math.min(1, (away - 4) / 3));
      const value = Math.round(hard * top + (noise >> 16) % (top / 50)) - (signed ? 900 : 0);
      if (bits <= 8) raw[y * size + x] = value;
      else raw.writeInt16LE(value, 2 * (y * size + x));
    }
  return raw;
}

function slice(k, {bits, signed}) {
  const study = '1.2.826.0.1.3680043.2.1125.77', instance = `${study}.${k + 1}`, ct = '1.2.840.10008.5.1.4.1.1.2';
  const data = Buffer.concat([
    element(8, 0x16, 'UI', ct), element(8, 0x18, 'UI', instance), element(8, 0x60, 'CS', 'CT'), element(0x10, 0x10, 'PN', 'Ring'), element(0x10, 0x20, 'LO', '1'),
    element(0x20, 0xd, 'UI', study), element(0x20, 0xe, 'UI', `${study}.100`), element(0x20, 0x13, 'IS', String(k + 1)),
    element(0x20, 0x32, 'DS', `1\\2\\${k / 2}`), element(0x20, 0x37, 'DS', '1\\0\\0\\0\\1\\0'), element(0x28, 2, 'US', short(1)), element(0x28, 4, 'CS', 'MONOCHROME2'),
    element(0x28, 0x10, 'US', short(size)), element(0x28, 0x11, 'US', short(size)), element(0x28, 0x30, 'DS', '0.25\\0.25'),
    element(0x28, 0x100, 'US', short(bits > 8 ? 16 : 8)), element(0x28, 0x101, 'US', short(bits)), element(0x28, 0x102, 'US', short(bits - 1)),
    element(0x28, 0x103, 'US', short(signed ? 1 : 0)), element(0x28, 0x1052, 'DS', signed ? '0' : '-100'), element(0x28, 0x1053, 'DS', '1'),
    element(0x7fe0, 0x10, bits > 8 ? 'OW' : 'OB', pixels(k, {bits, signed})),
  ]);
  const meta = Buffer.concat([element(2, 1, 'OB', Buffer.from([0, 1])), element(2, 2, 'UI', ct), element(2, 3, 'UI', instance),
    element(2, 0x10, 'UI', '1.2.840.10008.1.2.1'), element(2, 0x12, 'UI', '1.2.826.0.1.3680043.2.1125.1')]);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(meta.length);
  return Buffer.concat([Buffer.alloc(128), Buffer.from('DICM'), element(2, 0, 'UL', length), meta, data]);
}

/// {'series/0.dcm': bytes, ...}: `line` of a program, called with each file, "in" and "out" being its names; null: as they are.
export function series(folder, name, line, pixelsAre = {bits: 16, signed: true}) {
  const plain = join(folder, `${name}-plain`), made = join(folder, name);
  for (const one of [plain, made]) mkdirSync(one);
  for (let k = 0; k < slices; ++k) {
    const [from, to] = [join(plain, `${k}.dcm`), join(made, `${k}.dcm`)];
    writeFileSync(line ? from : to, slice(k, pixelsAre));
    if (!line) continue;
    const ended = spawnSync(line[0], line.slice(1).map(word => word === 'in' ? from : word === 'out' ? to : word), {encoding: 'utf8'});
    if (ended.status !== 0) throw new Error(`${line.join(' ')}: ${ended.error ?? ended.stderr}`);
  }
  return Object.fromEntries(readdirSync(made).map(file => [`series/${file}`, readFileSync(join(made, file))]));
}

/// Of a file with a preamble: its transfer syntax.
export function syntaxOf(bytes) {
  const at = bytes.indexOf(Buffer.from([2, 0, 0x10, 0, 0x55, 0x49]));
  return bytes.subarray(at + 8, at + 8 + bytes.readUInt16LE(at + 6)).toString('latin1').replace(/\0/g, '');
}

/// Where the compressed bytes of a file begin, behind the table of offsets and the fragment's own head.
export function fragmentAt(bytes) {
  const table = bytes.lastIndexOf(Buffer.from([0xe0, 0x7f, 0x10, 0])) + 12;
  return table + 8 + bytes.readUInt32LE(table + 4) + 8;
}
