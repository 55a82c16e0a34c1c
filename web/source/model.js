// The surfaces of one model in the scene: opaque ones, those that are seen through, and the caps where a section cuts them.
import {
  AlwaysStencilFunc, BackSide, BufferGeometry, DecrementWrapStencilOp, Float32BufferAttribute, FrontSide, Group, IncrementWrapStencilOp, KeepStencilOp, Matrix4, Mesh,
  NotEqualStencilFunc, Vector3, Vector4, ZeroStencilOp,
} from 'three';
import {voidsOf} from './data.js';
import {setFaces, surfaceMaterial} from './surface.js';

const capOrder = 100, seeThroughOrder = 1000;

/// A square of side 2 in the plane z = 0, facing +z.
function square() {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
  geometry.setAttribute('normal', new Float32BufferAttribute([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

/// Counts in the stencil how deep in a solid the section's plane lies behind each pixel.
function countingMaterial(shared, side) {
  const material = surfaceMaterial(shared, '#000000');
  Object.assign(material, {
    side, colorWrite: false, depthWrite: false, depthTest: false, stencilWrite: true, stencilFunc: AlwaysStencilFunc,
    stencilFail: KeepStencilOp, stencilZFail: KeepStencilOp,
    stencilZPass: side === BackSide ? IncrementWrapStencilOp : DecrementWrapStencilOp,
  });
  return material;
}

/// Fills where the count is not zero, and clears it for the next solid.
function capMaterial(shared, hex) {
  const material = surfaceMaterial({...shared, section: {value: new Vector4(0, 0, 0, 1)}}, hex);
  Object.assign(material, {
    stencilWrite: true, stencilRef: 0, stencilFunc: NotEqualStencilFunc, stencilFail: ZeroStencilOp, stencilZFail: ZeroStencilOp, stencilZPass: ZeroStencilOp,
  });
  return material;
}

export class ShownModel {
  /// `looks`: by name, {colour, opacity, visible, as_body, depth}; changed from outside, then `dress` is called.
  constructor(parts, looks, shared, bounds) {
    this.group = new Group();
    this.looks = looks;
    this.bounds = bounds;
    this.voids = new Set(voidsOf(parts).map(part => part.geometry));
    this.parts = parts.map(part => this.partMeshes(part, shared));
    const square_ = square();
    this.caps = [...new Set(parts.map(part => part.structure))].map((structure, index) => this.capMeshes(structure, index, shared, square_));
  }

  partMeshes(part, shared) {
    const material = surfaceMaterial(shared, this.looks.get(part.key).colour);
    const shown = new Mesh(part.geometry, material), first = new Mesh(part.geometry, material.clone());
    Object.assign(first.material.uniforms, shared);   // clone() copies the values
    first.material.colorWrite = false;
    this.group.add(shown, first);
    return {...part, shown, first};
  }

  capMeshes(structure, index, shared, square_) {
    const of = this.parts.filter(part => part.structure === structure);
    const order = capOrder + 3 * index, counting = [];
    for (const side of [BackSide, FrontSide]) {
      const material = countingMaterial(shared, side);
      for (const part of of) {
        const mesh = new Mesh(part.geometry, material);
        mesh.renderOrder = order + (side === BackSide ? 0 : 1);
        counting.push(mesh);
      }
    }
    const cap = new Mesh(square_, capMaterial(shared, this.looks.get(of[0].key).colour));
    cap.renderOrder = order + 2;
    cap.matrixAutoUpdate = false;
    this.group.add(...counting, cap);
    return {structure, key: of[0].key, counting, cap};
  }

  /// Puts looks, faces and section on. `inside`: from within the void, where walls are opaque and what fills the void is left out.
  dress({faces, section, inside}) {
    for (const part of this.parts) {
      const look = this.looks.get(part.key), opacity = inside ? 1 : look.opacity;
      const wall = inside && this.voids.has(part.geometry), left_out = inside && !wall && this.fills(part);
      const visible = look.visible && opacity > 0 && !left_out, clear = opacity < 1;
      const body = inside ? wall && part.kind !== 'cavity' : look.as_body;
      for (const mesh of [part.shown, part.first]) {
        setFaces(mesh.material, faces, body);
        mesh.material.uniforms.opacity.value = opacity;
        mesh.material.transparent = clear;
        // Deeper tissue first; of each only what is nearest to the eye.
        mesh.renderOrder = clear ? seeThroughOrder - 2 * look.depth + (mesh === part.shown ? 1 : 0) : 0;
      }
      part.shown.visible = visible;
      part.first.visible = visible && clear;
    }
    for (const cap of this.caps) {
      const look = this.looks.get(cap.key);
      const shown = Boolean(section) && look.visible && look.opacity > 0 && !inside;
      for (const mesh of [...cap.counting, cap.cap]) mesh.visible = shown;
      if (!shown) continue;
      cap.cap.matrix.copy(capMatrix(section, this.bounds));
      cap.cap.matrixWorldNeedsUpdate = true;
    }
  }

  /// Does this part fill a cavity of another solid?
  fills(part) {
    const box = part.geometry.boundingBox, spare = 0.05 * box.min.distanceTo(box.max);   // simplified surfaces fit less exactly
    return part.kind !== 'cavity' && this.parts.some(other => other.kind === 'cavity' && other.structure !== part.structure &&
      other.geometry.boundingBox.clone().expandByScalar(spare).containsBox(box));
  }
}

/// The square in the section's plane, as large as the model.
function capMatrix(section, bounds) {
  const normal = new Vector3(section.x, section.y, section.z);
  const side = Math.abs(normal.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
  const u = new Vector3().crossVectors(side, normal).normalize(), v = new Vector3().crossVectors(normal, u);
  const centre = bounds.centre.clone().addScaledVector(normal, section.w - normal.dot(bounds.centre));
  const size = 1.5 * bounds.radius;
  return new Matrix4().makeBasis(u.multiplyScalar(size), v.multiplyScalar(size), normal.clone()).setPosition(centre);
}
