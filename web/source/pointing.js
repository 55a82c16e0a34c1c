// What one points at in the picture: the structures that the line of sight passes, and the named part of the pulp there.
import {Raycaster, Vector2, Vector3} from 'three';

const seeThrough = 0.95;     // what is less opaque is looked through
const dragPixels = 6;        // a pointer that moves farther between down and up drags
const crossStep = 0.04;      // of the picture's height
const chamber = 'pulp chamber';

export class Pointing {
  constructor(viewer) {
    this.viewer = viewer;
    this.cross = document.getElementById('cross');
    this.at = {x: 0, y: 0};   // of the cross, from the middle, in halves of the picture
    this.take = null;         // called with what was pointed at
    this.listen();
  }

  /// `take` is called with each thing that is pointed at; null: no more.
  ask(take) {
    this.take = take;
    this.at = {x: 0, y: 0};
    this.cross.hidden = true;
    this.viewer.canvas.classList.toggle('asks', take !== null);
  }

  listen() {
    const {canvas} = this.viewer;
    let down = null;
    canvas.addEventListener('pointerdown', event => { down = event.isPrimary && event.button === 0 ? event : null; });
    canvas.addEventListener('pointerup', event => {
      if (!down || !this.take || Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > dragPixels) return;
      const box = canvas.getBoundingClientRect();
      this.taken({x: (event.clientX - box.left) / box.width * 2 - 1, y: 1 - (event.clientY - box.top) / box.height * 2});
    });
  }

  taken(place) {
    const found = this.under(place);
    if (found) this.take?.(found);
    return found;
  }

  /// A key of the picture's while something is asked for; true: it was.
  key(event) {
    if (!this.take) return false;
    const way = {arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, 1], arrowdown: [0, -1]}[event.key.toLowerCase()];
    if (event.key === 'Enter' && event.target === this.viewer.canvas) {
      this.showCross();
      this.taken(this.at);
      return true;
    }
    if (way) this.showCross();
    if (!way || !event.shiftKey) return false;
    const {canvas} = this.viewer, clamp = x => Math.min(Math.max(x, -0.98), 0.98);
    this.at = {x: clamp(this.at.x + way[0] * crossStep * 2 * canvas.clientHeight / canvas.clientWidth), y: clamp(this.at.y + way[1] * crossStep * 2)};
    this.showCross();
    return true;
  }

  showCross() {
    this.cross.hidden = false;
    this.cross.style.left = `${50 * (1 + this.at.x)}%`;
    this.cross.style.top = `${50 * (1 - this.at.y)}%`;
  }

  /// {structure, structures, part}: what stands out there, all that is passed to it, and of the pulp the part. Null: nothing.
  under({x, y}) {
    const {viewer} = this, {current} = viewer, ray = new Raycaster(), plane = viewer.inside ? null : viewer.section.plane(), structures = [];
    const {camera} = viewer;
    camera.updateMatrixWorld();
    ray.setFromCamera(new Vector2(x, y), camera);
    const drawn = new Map(current.drawn.filter(({seen}) => seen).map(one => [one.shown, one]));
    const hits = ray.intersectObjects([...drawn.keys()], false).filter(({object, point}) => !plane || drawn.get(object).geometries || plane.x * point.x + plane.y * point.y + plane.z * point.z <= plane.w + 1e-4);
    let last = null;
    for (const hit of hits) {
      const one = drawn.get(hit.object), wall = current.voids.has(one.shown.geometry), pulp = wall || /pulp/i.test(one.structure);
      const names = wall && viewer.inside ? [pulpName(viewer), one.structure] : wall && one.kind === 'cavity' && viewer.looks.get(one.key).as_body ? [pulpName(viewer)] : [one.structure];
      structures.push(...names);
      last = {structure: names[0], point: hit.point, pulp};
      if (!one.clear || viewer.looks.get(one.key).opacity >= seeThrough) break;
    }
    if (!last) return null;
    return {structure: last.structure, structures: [...new Set(structures)], part: last.pulp ? partAt(viewer, last.point) : null};
  }
}

const pulpName = viewer => viewer.models[0].parts.find(part => /pulp/i.test(part.structure))?.structure ?? 'pulp';

/// The named part of the pulp at a place: a canal, a horn, the chamber. Null where nothing is named.
export function partAt(viewer, point) {
  const place = new Vector3().copy(point), ways = [...viewer.tours, ...viewer.horns];
  let best = null, least = Infinity;
  for (const way of ways) {
    const {mm, distance} = way.nearest(place);
    if (distance < least) [best, least] = [{way, mm}, distance];
  }
  if (!best) return null;
  const {way, mm} = best;
  if (viewer.horns.includes(way)) return mm > 0.5 * way.length ? way.name : chamber;
  return way.orifice !== null && mm < way.orifice ? chamber : way.name;
}
