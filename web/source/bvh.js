// Distances to a surface of triangles: a tree of boxes over them. Plain arrays and numbers, so that it runs without a browser too.

const leafSize = 6;

export class TriangleTree {
  /// `positions`: x, y, z of each vertex; `indices`: three a triangle.
  constructor(positions, indices) {
    this.positions = positions;
    this.indices = indices;
    const count = indices.length / 3;
    this.order = new Uint32Array(count);
    const centres = new Float64Array(3 * count);
    for (let t = 0; t < count; ++t) {
      this.order[t] = t;
      for (let k = 0; k < 3; ++k) for (let c = 0; c < 3; ++c) centres[3 * t + k] += positions[3 * indices[3 * t + c] + k] / 3;
    }
    this.boxes = [];   // six numbers a node: low, high
    this.nodes = [];   // two numbers a node: leaf: first, -count; inner: left child, right child
    if (count > 0) this.build(0, count, centres);
  }

  build(from, to, centres) {
    const node = this.nodes.length / 2;
    this.nodes.push(0, 0);
    this.boxes.push(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = from; i < to; ++i) {
      const t = this.order[i];
      for (let k = 0; k < 3; ++k) {
        low[k] = Math.min(low[k], centres[3 * t + k]);
        high[k] = Math.max(high[k], centres[3 * t + k]);
        for (let c = 0; c < 3; ++c) {
          const value = this.positions[3 * this.indices[3 * t + c] + k];
          this.boxes[6 * node + k] = Math.min(this.boxes[6 * node + k], value);
          this.boxes[6 * node + 3 + k] = Math.max(this.boxes[6 * node + 3 + k], value);
        }
      }
    }
    if (to - from <= leafSize) {
      this.nodes[2 * node] = from;
      this.nodes[2 * node + 1] = -(to - from);
      return node;
    }
    const size = [0, 1, 2].map(k => high[k] - low[k]);
    const axis = size.indexOf(Math.max(...size));
    this.order.subarray(from, to).sort((a, b) => centres[3 * a + axis] - centres[3 * b + axis]);
    const middle = (from + to) >> 1;
    this.nodes[2 * node] = this.build(from, middle, centres);
    this.nodes[2 * node + 1] = this.build(middle, to, centres);
    return node;
  }

  squaredDistanceToBox(node, p) {
    let sum = 0;
    for (let k = 0; k < 3; ++k) {
      const off = Math.max(this.boxes[6 * node + k] - p[k], 0, p[k] - this.boxes[6 * node + 3 + k]);
      sum += off * off;
    }
    return sum;
  }

  /// The nearest place on the surface: {distance, point}; distance Infinity if it has no triangle.
  nearest(p) {
    const best = {squared: Infinity, point: [0, 0, 0]};
    const stack = this.nodes.length > 0 ? [0] : [];
    while (stack.length > 0) {
      const node = stack.pop();
      if (this.squaredDistanceToBox(node, p) >= best.squared) continue;
      const first = this.nodes[2 * node], second = this.nodes[2 * node + 1];
      if (second < 0) {
        for (let i = first; i < first - second; ++i) this.nearerOn(this.order[i], p, best);
        continue;
      }
      const leftIsNearer = this.squaredDistanceToBox(first, p) < this.squaredDistanceToBox(second, p);
      stack.push(leftIsNearer ? second : first, leftIsNearer ? first : second);   // the nearer is looked at first
    }
    return {distance: Math.sqrt(best.squared), point: best.point};
  }

  /// How often the surface winds round p: about 1 or -1 within a closed one, 0 without; between where it is open. Looks at every triangle.
  winding(p) {
    let sum = 0;
    for (let t = 0; t < this.order.length; ++t) {
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

  nearerOn(t, p, best) {
    const q = nearestOnTriangle(p, this.corner(t, 0), this.corner(t, 1), this.corner(t, 2));
    const squared = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2 + (q[2] - p[2]) ** 2;
    if (squared < best.squared) {
      best.squared = squared;
      best.point = q;
    }
  }
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a, d, s) => [a[0] + s * d[0], a[1] + s * d[1], a[2] + s * d[2]];

/// By the regions of Voronoi of corners, edges and face (Ericson, Real-Time Collision Detection, 5.1.5). A triangle without area is its edges.
export function nearestOnTriangle(p, a, b, c) {
  const ab = minus(b, a), ac = minus(c, a), ap = minus(p, a);
  const d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const bp = minus(p, b), d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const cp = minus(p, c), d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const vc = d1 * d4 - d3 * d2, va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(a, ab, d1 - d3 > 0 ? d1 / (d1 - d3) : 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(a, ac, d2 - d6 > 0 ? d2 / (d2 - d6) : 0);
  if (va <= 0 && d4 >= d3 && d5 >= d6) return along(b, minus(c, b), (d4 - d3) + (d5 - d6) > 0 ? (d4 - d3) / ((d4 - d3) + (d5 - d6)) : 0);
  const sum = va + vb + vc;
  return along(along(a, ab, vb / sum), ac, vc / sum);
}
