// Distances to a surface of triangles.
import {BufferAttribute, BufferGeometry, Vector3} from 'three';
import {AVERAGE, MeshBVH} from 'three-mesh-bvh';

export class TriangleTree {
  /// `positions`: x, y, z of each vertex; `indices`: three a triangle.
  constructor(positions, indices) {
    this.positions = positions;
    this.indices = indices;
    if (indices.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(ArrayBuffer.isView(positions) ? positions : Float64Array.from(positions), 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(indices), 1));   // a copy: the tree sorts it
    this.tree = new MeshBVH(geometry, {strategy: AVERAGE, targetLeafSize: 4});   // what answers soonest for a tube's walls
  }

  /// The nearest place on the surface: {distance, point}; distance Infinity if it has no triangle.
  nearest(p) {
    if (!this.tree) return {distance: Infinity, point: [0, 0, 0]};
    const {distance, point} = this.tree.closestPointToPoint(new Vector3(...p));
    return {distance, point: point.toArray()};
  }

  /// How often the surface winds round p: about 1 or -1 within a closed one, 0 without; between where it is open. Looks at every triangle.
  winding(p) {
    let sum = 0;
    for (let t = 0; t < this.indices.length / 3; ++t) {
      const [a, b, c] = [0, 1, 2].map(k => minus(this.corner(t, k), p)), [la, lb, lc] = [a, b, c].map(v => Math.sqrt(dot(v, v)));
      const volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
      sum += 2 * Math.atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);   // the solid angle (Van Oosterom, Strackee 1983)
    }
    return sum / (4 * Math.PI);
  }

  corner(t, c) {
    const v = 3 * this.indices[3 * t + c];
    return [this.positions[v], this.positions[v + 1], this.positions[v + 2]];
  }
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
