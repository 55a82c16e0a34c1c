// Transfer functions: what material of a value looks like. A list of {value, colour, extinction} as scene files have it; between its points colour (in linear light) and
// extinction (1/mm) run straight, beyond the outermost they stay. As on the desktop (engine/scene/volume_look.h).

export const entries = 4096;

const linearChannel = part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
const linearOf = hex => [1, 3, 5].map(at => linearChannel(parseInt(hex.slice(at, at + 2), 16) / 255));

/// The same with linear colours: [value, r, g, b, extinction].
export const understood = transfer => transfer.map(({value, colour, extinction}) => [value, ...linearOf(colour), extinction]);

/// [r, g, b, extinction].
export function transferred(points, value) {
  if (points.length === 0) return [0, 0, 0, 0];
  const above = points.findIndex(point => value < point[0]);
  if (above === 0) return points[0].slice(1);
  if (above < 0) return points.at(-1).slice(1);
  const [from, to] = [points[above - 1], points[above]], part = (value - from[0]) / (to[0] - from[0]);
  return from.slice(1).map((x, k) => x + part * (to[k + 1] - x));
}

export function anyExtinction(points, low, high) {
  return transferred(points, low)[3] > 0 || transferred(points, high)[3] > 0 || points.some(([value, , , , extinction]) => value > low && value < high && extinction > 0);
}

/// What volume.frag wants: the transfer function summed over the values from `low` to each entry, up to `high`; colours times extinctions, and extinctions. Over what the shader
/// counts by, of which there are `span`.
export function transferTable(points, low, high, span) {
  const sums = new Float32Array(4 * entries), sum = [0, 0, 0, 0], step = span / (entries - 1);
  for (let i = 0, before = null; i < entries; ++i) {
    const [r, g, b, extinction] = transferred(points, low + (high - low) * i / (entries - 1)), here = [r * extinction, g * extinction, b * extinction, extinction];
    if (before) here.forEach((x, k) => { sum[k] += 0.5 * step * (before[k] + x); });
    before = here;
    sums.set(sum, 4 * i);
  }
  return sums;
}
