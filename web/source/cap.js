// What a section shows of a solid: the plane's part within it, as triangles.
import {BufferGeometry, Float32BufferAttribute, ShapeUtils, Vector2, Vector3} from 'three';
import {loopsOf, regionsOf, weldedVertices} from './slice.js';

const surfaces = new WeakMap();

function surfaceOf(geometry) {
  if (!surfaces.has(geometry)) {
    const positions = geometry.attributes.position.array;
    surfaces.set(geometry, {positions, indices: geometry.index.array, same: weldedVertices(positions)});
  }
  return surfaces.get(geometry);
}

/// `geometries` bound one solid together: its outside and its cavities. `plane`: a Vector4, (normal, distance). Its triangles face along the normal.
export function capGeometry(geometries, plane) {
  const normal = new Vector3(plane.x, plane.y, plane.z), side = Math.abs(normal.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
  const u = new Vector3().crossVectors(side, normal).normalize(), v = new Vector3().crossVectors(normal, u), p = new Vector3();
  const flat = geometries.flatMap(geometry => loopsOf(surfaceOf(geometry), plane.toArray()).loops).map(loop => loop.map(at => [p.fromArray(at).dot(u), p.dot(v)]));
  const positions = [], normals = [], indices = [];
  for (const {outline, holes} of regionsOf(flat)) {
    const rings = [outline, ...holes].map(loop => loop.map(([x, y]) => new Vector2(x, y)));
    const first = positions.length / 3, triangles = ShapeUtils.triangulateShape(rings[0], rings.slice(1)), corners = rings.flat();   // which may have shortened the rings
    for (const [a, b, c] of triangles) {
      const turns = ShapeUtils.isClockWise([a, b, c].map(i => corners[i]));
      indices.push(first + a, first + (turns ? c : b), first + (turns ? b : c));
    }
    for (const {x, y} of corners) {
      p.copy(normal).multiplyScalar(plane.w).addScaledVector(u, x).addScaledVector(v, y);
      positions.push(p.x, p.y, p.z);
      normals.push(normal.x, normal.y, normal.z);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  geometry.setIndex(indices);
  return geometry;
}
