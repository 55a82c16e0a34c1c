// The surfaces of one model in the scene: opaque ones, those that are seen through, and the caps where a section cuts them.
import {BufferGeometry, CustomBlending, Group, Mesh, NoBlending, Vector4} from 'three';
import {capGeometry} from './cap.js';
import {voidsOf} from './data.js';
import {setColour, setFaces, surfaceMaterial} from './surface.js';

const seeThroughOrder = 1000;
const mostBehindCap = 6;     // walls of a material that its cap stands for
const grainShare = 0.018;    // of the model's radius, as on the desktop

export class ShownModel {
  /// `looks`: by name, {colour, opacity, visible, as_body, depth}; changed from outside, then `dress` is called.
  constructor(parts, looks, shared, bounds) {
    this.group = new Group();
    this.looks = looks;
    this.bounds = bounds;
    this.voids = new Set(voidsOf(parts).map(part => part.geometry));
    // One is inside a body itself: what touches it lies in the very place of its wall (the dentine round a pulp whose apex is open).
    this.bodies = this.voids.size > 0 && !parts.some(part => part.kind === 'cavity');
    this.parts = parts.map(part => this.partMeshes(part, shared));
    this.caps = [...new Set(parts.map(part => part.structure))].map(structure => this.capMeshes(structure, shared));
    this.cutBy = null;
  }

  partMeshes(part, shared) {
    const material = surfaceMaterial(shared, this.looks.get(part.key).colour);
    return {...part, ...this.twice(part.geometry, material, shared)};
  }

  capMeshes(structure, shared) {
    const of = this.parts.filter(part => part.structure === structure), key = of[0].key;
    const material = surfaceMaterial({...shared, section: {value: new Vector4(0, 0, 0, 1)}}, this.looks.get(key).colour);
    material.uniforms.grain_size.value = grainShare * this.bounds.radius;
    return {structure, key, geometries: of.map(part => part.geometry), ...this.twice(new BufferGeometry(), material, {})};
  }

  /// One mesh to be seen, and one that where layers are not told apart goes before it and leaves only its depth.
  twice(geometry, material, shared) {
    const shown = new Mesh(geometry, material), first = new Mesh(geometry, material.clone());
    Object.assign(first.material.uniforms, {...material.uniforms, ...shared});   // clone() copies the values
    first.material.colorWrite = false;
    for (const mesh of [shown, first]) mesh.frustumCulled = false;   // a cap's geometry changes, and a model is mostly seen whole
    this.group.add(shown, first);
    return {shown, first, seen: false, clear: false};
  }

  /// Puts looks, faces and section on. `inside`: from within the void, where walls are opaque and what fills the void is left out.
  /// `data`: 1 or 2 for the colours of distance or slope, of parts that have them.
  dress({faces, section, inside, wallDepth, data = 0}) {
    const cut = section && !inside;
    for (const part of this.parts) {
      const look = this.looks.get(part.key), opacity = inside ? 1 : look.opacity;
      const wall = inside && this.voids.has(part.geometry), left_out = inside && !wall && (this.bodies || this.fills(part));
      const body = inside ? wall && part.kind !== 'cavity' : look.as_body && !cut;   // cut open, a cavity shows its wall
      part.seen = look.visible && opacity > 0 && !left_out;
      for (const {material: {uniforms}} of [part.shown, part.first]) {
        uniforms.show_depth.value = Boolean(wall && wallDepth);
        uniforms.show_data.value = part.geometry.hasAttribute('data') ? data : 0;
      }
      this.put(part, {colour: look.colour, opacity, faces, body, depth: look.depth});
    }
    if (cut && !this.cutBy?.equals(section)) {
      this.cutBy = section.clone();
      for (const cap of this.caps) {
        cap.shown.geometry.dispose();
        cap.shown.geometry = cap.first.geometry = capGeometry(cap.geometries, section);
      }
    }
    for (const cap of this.caps) {
      const look = this.looks.get(cap.key);
      cap.seen = Boolean(cut) && look.visible && look.opacity > 0;
      // All of the material lies behind it: it is denser than one wall.
      this.put(cap, {colour: look.colour, opacity: 1 - (1 - look.opacity) ** mostBehindCap, faces: faces === 'tint' ? 'show' : faces, body: false, depth: look.depth});
    }
  }

  put(drawn, {colour, opacity, faces, body, depth}) {
    drawn.clear = opacity < 1;
    for (const mesh of [drawn.shown, drawn.first]) {
      setColour(mesh.material, colour);
      setFaces(mesh.material, faces, body);
      mesh.material.uniforms.opacity.value = opacity;
      mesh.material.transparent = drawn.clear;
      // Deeper tissue first, for where layers are not told apart.
      mesh.renderOrder = drawn.clear ? seeThroughOrder - 2 * depth + (mesh === drawn.shown ? 1 : 0) : 0;
    }
  }

  get drawn() { return [...this.parts, ...this.caps]; }
  get anyOpaque() { return this.drawn.some(({seen, clear}) => seen && !clear); }
  get anyClear() { return this.drawn.some(({seen, clear}) => seen && clear); }

  /// Makes ready for drawing only the 'opaque' surfaces, only the 'clear' ones, of which the nearest is kept, or 'all', blended.
  prepare(pass) {
    for (const {shown, first, seen, clear} of this.drawn) {
      shown.visible = seen && (pass === 'all' || clear === (pass === 'clear'));
      first.visible = seen && clear && pass === 'all';
      shown.material.blending = pass === 'all' ? CustomBlending : NoBlending;
    }
  }

  /// Does this part fill a cavity of another solid?
  fills(part) {
    const box = part.geometry.boundingBox, spare = 0.05 * box.min.distanceTo(box.max);   // simplified surfaces fit less exactly
    return part.kind !== 'cavity' && this.parts.some(other => other.kind === 'cavity' && other.structure !== part.structure &&
      other.geometry.boundingBox.clone().expandByScalar(spare).containsBox(box));
  }
}
