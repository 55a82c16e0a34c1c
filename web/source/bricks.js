// A volume in bricks, so that rays pass over those that have nothing to show; as the desktop has them (engine/raycast/brick_grid.h).

export const brickSide = 8;   // values

/// Of each brick the lowest and the highest byte that interpolation within it makes use of. x runs fastest, then y, then z.
export function brickGrid([nx, ny, nz], bytes) {
  const size = [nx, ny, nz].map(count => Math.ceil(count / brickSide)), lowest = new Uint8Array(size[0] * size[1] * size[2]).fill(255), highest = new Uint8Array(lowest.length);
  const first = index => index > 0 && index % brickSide === 0 ? index / brickSide - 1 : Math.floor(index / brickSide);   // a value that begins a brick is the one before's last, too
  const firstX = Array.from({length: nx}, (_, i) => first(i));
  for (let k = 0, at = 0; k < nz; ++k)
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i, ++at) {
        const value = bytes[at];
        for (let z = first(k); z <= Math.floor(k / brickSide); ++z)
          for (let y = first(j); y <= Math.floor(j / brickSide); ++y)
            for (let x = firstX[i]; x <= i >> 3; ++x) {
              const brick = (z * size[1] + y) * size[0] + x;
              if (value < lowest[brick]) lowest[brick] = value;
              if (value > highest[brick]) highest[brick] = value;
            }
      }
  return {size, lowest, highest};
}

/// Of each brick, how many bricks away the nearest is that `shows(lowest, highest)`, the larger of the axes' counts; 255 at most.
export function distancesToShown({size: [nx, ny, nz], lowest, highest}, shows) {
  const distance = new Uint8Array(lowest.length).fill(255);
  for (let i = 0; i < distance.length; ++i) if (shows(lowest[i], highest[i])) distance[i] = 0;
  const sweep = towards => {
    const count = nx * ny * nz;
    for (let step = 0; step < count; ++step) {
      const own = towards < 0 ? step : count - 1 - step, x = own % nx, y = Math.floor(own / nx) % ny, z = Math.floor(own / (nx * ny));
      for (let dz = -1; dz <= 1; ++dz)
        for (let dy = -1; dy <= 1; ++dy)
          for (let dx = -1; dx <= 1; ++dx) {
            const i = x + dx, j = y + dy, k = z + dz;
            if ((9 * dz + 3 * dy + dx) * towards <= 0 || i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) continue;
            distance[own] = Math.min(distance[own], distance[(k * ny + j) * nx + i] + 1);
          }
    }
  };
  sweep(-1);   // forth and back over the neighbours, each time those that were visited already
  sweep(1);
  return distance;
}
