// How thick the wall is: from the void's wall to the nearest place on the outside of the solid that it runs in, as `anatomy` measures its thinnest walls.
import {TriangleTree} from './bvh.js';
import {trianglesOf} from './data.js';

export const thicknessStep = 0.2;   // mm, of the colours' steps: a bold line every five
const thickest = 15;                // steps; where the wall is thicker it keeps its own colour

/// The outside of what walls this void in; null: nothing does, as where the void is the pulp's own body.
export const outsideOf = (part, parts) => part.kind === 'cavity' ? parts.filter(other => other.structure === part.structure && other.kind !== 'cavity') : [];

/// Of every place of `positions`, in steps below the thickest: the thinner the wall, the deeper the colour (shaders/wall_depth.glsl). `scale`: 1, and more for a
/// model that is measured in voxels.
export function thicknessColours(positions, outside, scale = 1) {
  const {positions: corners, indices} = trianglesOf(outside), tree = new TriangleTree(corners, indices), colours = new Float32Array(positions.length / 3);
  for (let v = 0; v < colours.length; ++v) {
    const {distance} = tree.nearest([positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]]);
    colours[v] = thickest - distance / (thicknessStep * scale);
  }
  return colours;
}
