// What the judges of grey values have in common: a made-up volume, and the page's picture against the desktop's.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {inflateSync} from 'node:zlib';
import {made, odontoscope} from './support.mjs';

export const size = [36, 32, 44];
const spacing = [0.25, 0.28, 0.22];

/// A tooth of three greys with a hollow, different along each axis: from 40 to 230. In 16 bits, `times` that and finer.
export function writeVolume(name, times = 0) {
  const values = new (times ? Uint16Array : Uint8Array)(size[0] * size[1] * size[2]),
    edge = x => 1 / (1 + Math.exp((x - 1) * 14));
  for (let k = 0, at = 0; k < size[2]; ++k)
    for (let j = 0; j < size[1]; ++j)
      for (let i = 0; i < size[0]; ++i, ++at) {
        const [x, y, z] = [i - 17, j - 15.4, k - 21].map((v, axis) => v * spacing[axis]);
        const body = edge(Math.hypot(x / 3.1, y / 2.6, z / 4)),
          crown = edge(Math.hypot(x / 3, y / 2.7, (z - 2.2) / 1.5));
        const hollow = edge(Math.hypot((x - 0.5) / 1, y / 0.8, (z + 0.4) / 2.2)),
          noise = 4 * Math.sin(i + 2 * j + 3 * k);
        values[at] = Math.round((times || 1) * (40 + 120 * body + 70 * body * crown - 135 * hollow * body + noise));
      }
  const type = times ? 'uint16\nendian: little' : 'uint8';
  const header = `NRRD0004\ntype: ${type}\ndimension: 3\nsizes: ${size.join(' ')}\nspacings: ${spacing.join(' ')}\nencoding: raw\n\n`;
  writeFileSync(made(name), Buffer.concat([Buffer.from(header), Buffer.from(values.buffer)]));
}

/// Gives a page seen(), its picture as a screen shows it, and told(), the same for the desktop, as a scene file has it.
export const giveSeen = page =>
  page.evaluate(() => {
    viewer.renderer.setAnimationLoop(null);
    /// As a screen shows it before black: the shoulder and the sRGB curve of shaders/tone.glsl, exactly.
    const shown = (sum, alpha) => {
      if (alpha === 0) return 0;
      const light = sum / alpha;
      const soft = alpha * (light > 0.78 ? 0.78 + 0.22 * (1 - Math.exp(-(light - 0.78) / 0.22)) : light);
      return 255 * (soft <= 0.0031308 ? 12.92 * soft : 1.055 * soft ** (1 / 2.4) - 0.055);
    };
    globalThis.seen = () => {
      while (viewer.orbit.move) viewer.orbit.update(0.2);
      viewer.orbit.update(0);
      const {width, height} = viewer.canvas,
        gl = viewer.renderer.getContext(),
        light = new Float32Array(4 * width * height),
        {layers} = viewer.picture;
      viewer.picture.draw(viewer.scene, viewer.camera, viewer.current, {
        ...viewer.wayOf({layers: true, shade: false}),
        complete: true,
      });
      viewer.renderer.setRenderTarget(layers.sum);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, light);
      viewer.renderer.setRenderTarget(null);
      return {width, height, shown: Array.from(light, (sum, i) => shown(sum, light[i - (i % 4) + 3]))};
    };
    globalThis.told = () => {
      const {orbit, camera, volume, section, data} = viewer,
        plane = section.plane(),
        parallel = camera.isOrthographicCamera ?? false;
      const black = {kind: 'plain', top: '#000000', bottom: '#000000'};
      return {
        format: 'odontoscope.scene',
        version: 1,
        volume: volume.look,
        ambient_occlusion: {on: false},
        background: black,
        camera: {
          projection: parallel ? 'parallel' : 'perspective',
          position: camera.position.toArray(),
          target: orbit.controls.target.toArray(),
          up: [0, 0, 1],
          field_of_view_deg: orbit.camera.fov,
          height_mm: parallel ? camera.top - camera.bottom : 25,
        },
        structures: [...viewer.looks.values()].map(({structure, colour, opacity, visible, as_body}) => ({
          name: structure,
          colour,
          opacity,
          visible,
          as_body,
        })),
        ...(plane
          ? {
              section: {
                point: [plane.x * plane.w, plane.y * plane.w, plane.z * plane.w],
                normal: [plane.x, plane.y, plane.z],
              },
            }
          : {}),
        ...(data?.shown ? {data_colours: {of: data.shown, reach: data.reach[data.shown]}} : {}),
      };
    };
  });

/// Rows of RGB or RGBA bytes from the top, of a PNG as ours are: eight bits, not interlaced.
function pixelsOf(png) {
  let at = 8,
    width = 0,
    height = 0,
    channels = 0;
  const parts = [];
  while (at < png.length) {
    const length = png.readUInt32BE(at),
      kind = png.toString('latin1', at + 4, at + 8),
      body = png.subarray(at + 8, at + 8 + length);
    if (kind === 'IHDR')
      [width, height, channels] = [body.readUInt32BE(0), body.readUInt32BE(4), {2: 3, 6: 4}[body[9]]];
    if (kind === 'IDAT') parts.push(body);
    at += 12 + length;
  }
  const raw = inflateSync(Buffer.concat(parts)),
    row = width * channels,
    pixels = Buffer.alloc(row * height);
  const nearest = (a, b, c) => {
    const p = a + b - c,
      [da, db, dc] = [a, b, c].map(x => Math.abs(p - x));
    return da <= db && da <= dc ? a : db <= dc ? b : c;
  };
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < row; ++x) {
      const a = x >= channels ? pixels[y * row + x - channels] : 0,
        b = y > 0 ? pixels[(y - 1) * row + x] : 0,
        c = x >= channels && y > 0 ? pixels[(y - 1) * row + x - channels] : 0;
      pixels[y * row + x] = raw[y * (row + 1) + 1 + x] + [0, a, b, (a + b) >> 1, nearest(a, b, c)][raw[y * (row + 1)]];
    }
  return {width, height, channels, pixels};
}

const legend = {right: 215, tall: 60}; // in the desktop's lower left corner; beside the model

/// How far the page, which is made of the volume `name` at 100, is off the desktop: the worst of 255, how many pixels
/// are more than two off, and how many are not black. `change`: {volume, cut, beam, data, reach}, each as the viewer's
/// own words have it.
export async function compared(page, name, change) {
  const {drawn, scene} = await page.evaluate(async change => {
    viewer.setVolume(change.volume ?? {});
    viewer.setBeam(change.beam ?? 'cone');
    viewer.section.put(null);
    if (change.cut) viewer.cut({on: true, at: 0.6});
    await viewer.data.choose(change.data ?? null);
    if (change.reach) viewer.data.setReach(change.reach);
    viewer.dress();
    return {drawn: seen(), scene: told()};
  }, change);
  writeFileSync(made('page.scene.json'), JSON.stringify(scene));
  const as_seen = ['--show', scene.volume.shows, '--samples', '1', '--size', `${drawn.width}x${drawn.height}`];
  odontoscope('render', name, '--iso', '100', '--scene', 'page.scene.json', ...as_seen, '-o', 'desktop.png');
  const {pixels, channels, width, height} = pixelsOf(readFileSync(made('desktop.png')));
  assert.deepEqual([width, height], [drawn.width, drawn.height]);
  const judged = {worst: 0, off: 0, lit: 0};
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      if (change.data && x < legend.right && y >= height - legend.tall) continue;
      const here = [0, 1, 2].map(k => [
        pixels[(y * width + x) * channels + k],
        drawn.shown[4 * ((height - 1 - y) * width + x) + k],
      ]);
      const worst = Math.max(...here.map(([desktop, own]) => Math.abs(desktop - own)));
      judged.worst = Math.max(judged.worst, worst);
      if (worst > 2) judged.off += 1;
      if (here.some(([desktop]) => desktop > 20)) judged.lit += 1;
    }
  return judged;
}
