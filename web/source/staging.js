// Puts the picture as a step of a lesson wants it: looks, section, and where the eye is. A note's scene is what scene_json.h tells; what it does not
// speak of is as the page was at first, and a note without a scene leaves the looks as they are.
import {Vector3} from 'three';
import {views} from './camera.js';

const number = value => typeof value === 'number' && Number.isFinite(value);
const colour = value => typeof value === 'string' && /^#[0-9a-f]{6}$/i.test(value);
const triple = value => Array.isArray(value) && value.length === 3 && value.every(number);

export class Staging {
  constructor(viewer) {
    this.viewer = viewer;
    this.usual = new Map([...viewer.looks].map(([key, look]) => [key, {...look}]));
    this.usualShade = viewer.shade;
    this.usualVolume = viewer.volume ? structuredClone(viewer.volume.look) : null;
  }

  /// `note`: of a tour file; `view` in place of a camera: the name of a view.
  show(note) {
    const {viewer} = this;
    viewer.led = true;   // the focus stays where it is
    try {
      if (viewer.inside) viewer.leave();
      viewer.labels.mark = null;
      if (note.scene) this.dress(note.scene);
      viewer.pins.show(note.marks ?? [], note.question ? '?' : '', note.arrows ?? []);
      this.lookFrom(note);
    } finally {
      viewer.led = false;
    }
  }

  /// As at first.
  reset() { this.dress({}); this.viewer.pins.show([]); }

  dress(scene) {
    const {viewer} = this;
    for (const [key, look] of this.usual) Object.assign(viewer.looks.get(key), look);
    for (const said of Array.isArray(scene.structures) ? scene.structures : []) {
      const look = viewer.looks.get(said?.name);
      if (!look) continue;
      if (number(said.opacity)) look.opacity = Math.min(Math.max(said.opacity, 0), 1);
      if (typeof said.visible === 'boolean') look.visible = said.visible;
      if (typeof said.as_body === 'boolean') look.as_body = said.as_body;
      if (colour(said.colour)) look.colour = said.colour;
    }
    const {section} = scene, normal = section && triple(section.normal) ? new Vector3(...section.normal) : new Vector3(0, 1, 0);
    viewer.section.put(section && normal.length() > 0 ? {point: triple(section.point) ? section.point : [0, 0, 0], normal: normal.normalize()} : null);
    viewer.faces = ['cull', 'show', 'tint'].includes(scene.back_faces) ? scene.back_faces : 'cull';
    viewer.shade = typeof scene.ambient_occlusion?.on === 'boolean' ? scene.ambient_occlusion.on : this.usualShade;
    this.dressVolume(scene.volume);
    viewer.dress();
  }

  /// A film that a page without grey values is asked for is that of its model.
  dressVolume(said) {
    const {viewer} = this, film = said?.cast === 'radiograph' && said.shows !== 'surfaces';
    if (viewer.shadow) viewer.shadow.on = film;
    if (!viewer.volume) return;
    Object.assign(viewer.volume.look, structuredClone(this.usualVolume), said ?? {});
    if (!(viewer.volume.look.transfer.length > 0)) viewer.volume.look.transfer = this.usualVolume.transfer;
  }

  lookFrom({camera, view, inside, tour}) {
    const {viewer} = this, index = tour ? viewer.tours.findIndex(({name}) => name.toLowerCase() === tour.toLowerCase()) : -1;
    if (index >= 0) {
      const {tours, journey} = viewer, end = camera ? tours[index].nearest(new Vector3(...camera.position)).mm : tours[index].length;
      viewer.startTour(index);
      journey.stopAt = end;
      if (journey.still.matches) {
        viewer.play(false);
        viewer.seek(end);
      }
    } else if (view) viewer.look(views.some(({name}) => name === view) ? view : 'three-quarter');
    else if (inside) viewer.startFlight({place: new Vector3(...camera.position), direction: new Vector3(...camera.target).sub(new Vector3(...camera.position)).normalize(), up: new Vector3(...camera.up)});
    else viewer.orbit.goTo({pose: camera, towards: new Vector3(...camera.position).sub(new Vector3(...camera.target)).toArray(), up: camera.up});
  }
}
