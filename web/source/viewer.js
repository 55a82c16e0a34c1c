// The state of the page and what can be done with it. Panel, keys and headset all act through this; none of them draws.
import {BufferAttribute, Group, Scene, Vector3, WebGLRenderer} from 'three';
import {others} from '../../assets/theme.json';
import {TriangleTree} from './bvh.js';
import {Orbit, views} from './camera.js';
import {DataColours} from './data_colours.js';
import {boundsOf, partsOf, trianglesOf, voidsOf, volumeValues} from './data.js';
import {depthStep, wallDepths} from './depth.js';
import {Headset} from './headset.js';
import {Journey, Tour, flightStart} from './journey.js';
import {Labels} from './labels.js';
import {ShownModel} from './model.js';
import {Cues} from './cues.js';
import {Pointing} from './pointing.js';
import {Pins} from './pins.js';
import {Picture, setLightFrame} from './picture.js';
import {Pace, Quality} from './quality.js';
import {Section, sides} from './section.js';
import {Shadow} from './shadow.js';
import {sharedUniforms} from './surface.js';
import {outsideOf, thicknessColours} from './thickness.js';
import {Volume} from './volume.js';

const mostPixels = 2.2e6, sampledPoints = 1500;
const shadeReach = 0.12;   // of the model's radius: about the width of a fissure, as on the desktop
const aroundVolume = 0.15;   // how clear structures become around a volume, as on the desktop
const coarseSteps = 2, restBeforeCasting = 0.15;   // seconds
const facing = 0.35;   // of a section's normal towards the eye, below which the picture turns to show the cut

function pointsOf(parts) {
  const points = [];
  for (const {geometry} of parts) {
    const positions = geometry.attributes.position, step = Math.max(1, Math.floor(positions.count * parts.length / sampledPoints));
    for (let i = 0; i < positions.count; i += step) points.push(new Vector3().fromBufferAttribute(positions, i));
  }
  return points;
}

function drawsInSoftware(gl) {
  const masked = gl.getParameter(gl.RENDERER), told = /^webkit/i.test(masked) ? gl.getExtension('WEBGL_debug_renderer_info') : null;
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(told ? gl.getParameter(told.UNMASKED_RENDERER_WEBGL) : masked);
}

export class Viewer extends EventTarget {
  static async of(description, canvas) {
    const models = [];
    for (const model of description.models) models.push({...model, parts: await partsOf(model)});
    return new Viewer(description, models, canvas, description.volume ? await volumeValues(description.volume) : null);
  }

  constructor(description, models, canvas, values = null) {
    super();
    this.description = description;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: false, preserveDrawingBuffer: false});   // `Picture` sees to edges itself
    this.renderer.sortObjects = true;
    this.shared = sharedUniforms();
    this.picture = new Picture(this.renderer, this.shared);
    const software = drawsInSoftware(this.renderer.getContext());
    this.quality = new Quality({saving: navigator.connection?.saveData || navigator.deviceMemory <= 2, software});
    this.pace = new Pace({software});
    if (software) this.picture.mostCast = 1;
    this.shade = true;   // in hollows
    this.scene = new Scene();
    this.world = new Group();   // the model's millimetres; only a headset moves and scales it
    this.scene.add(this.world);
    this.looks = new Map(description.looks.map(look => [look.structure, {...look, visible: true}]));
    this.models = models;
    for (const part of models.flatMap(model => model.parts)) this.needLook(part.key);
    this.bounds = boundsOf(models[0].parts);
    this.shown = models.map(model => {
      for (const part of model.parts) part.geometry.computeBoundingBox();
      const shown = new ShownModel(model.parts, this.looks, this.shared, this.bounds);
      this.world.add(shown.group);
      return shown;
    });
    this.volume = values && this.picture.layers ? new Volume(this.renderer, description.volume, values, this.bounds) : null;
    this.shadow = values ? null : Shadow.of(this.renderer, {models, looks: this.looks, certificate: description.models[0].certificate}, this.bounds);
    this.data = this.volume ? DataColours.of(this, description.volume, values) : null;
    this.chosen = 0;
    this.beam = 'cone';   // of films, or 'parallel'
    this.faces = 'cull';
    this.wallDepth = true;   // canals' walls tell how deep one is,
    this.wallThickness = false;   // or how far it is to the outside
    this.section = new Section(this.bounds);
    this.orbit = new Orbit(canvas, this.bounds, pointsOf(models[0].parts), () => this.touch());
    this.labels = new Labels(models[0].parts, this.looks);
    this.labels.changed = () => this.touch();
    this.pins = new Pins(this);
    this.orbit.filmSize = () => (this.film ? this.filmLook.film_mm : [0, 0]);
    this.led = false;   // a lesson is moving the picture
    this.prepareInside();
    this.wallColours = new Map();   // by geometry: what has been measured
    this.headset = new Headset(this);
    this.pointing = new Pointing(this);
    this.cues = new Cues(this);
    this.frames = this.rested = 0;
    this.dress();
    this.resize();
    this.orbit.goTo(views[0], true);
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  needLook(key) {
    if (!this.looks.has(key)) this.looks.set(key, {structure: key, colour: others[0], opacity: 1, visible: true, as_body: false, depth: 1});
  }

  prepareInside() {
    const parts = this.models[0].parts, cavities = voidsOf(parts);
    const {positions, indices} = trianglesOf(cavities.length > 0 ? cavities : parts);
    this.walls = new TriangleTree(positions, indices);
    this.tours = this.description.tours.filter(tour => tour.keys).map(tour => new Tour(tour));
    this.horns = (this.description.horns ?? []).filter(horn => horn.points_mm.length > 1).map(horn => new Tour({...horn, orifice_mm: null}));
    this.journey = new Journey(this.walls, this.tours, this.bounds);
    this.cavities = cavities;
    this.hasInside = cavities.length > 0;
  }

  /// Within: does no wall lie between the eye and a place? Places on a wall, or nearly, are seen.
  inSight(place) {
    const from = this.camera.position, way = place.clone().sub(from), far = way.length(), little = 2e-3 * this.bounds.radius, slack = 15 * little;
    way.normalize();
    const p = from.clone();
    for (let gone = 0, i = 0; i < 80; ++i) {
      const {distance} = this.walls.nearest(p.toArray());
      gone += Math.max(distance, little);
      if (gone >= far - slack) return true;
      if (distance < little) return false;
      p.copy(from).addScaledVector(way, gone);
    }
    return false;
  }

  get inside() { return this.journey.mode !== null; }
  get camera() {
    if (this.headset.present) return this.headset.camera;
    if (this.inside) return this.journey.camera;
    return this.film && this.beam === 'parallel' ? this.orbit.parallel : this.orbit.camera;
  }
  get model() { return this.models[this.chosen]; }

  /// The picture must be drawn anew.
  touch() { this.dirty = true; }

  /// After a look, the faces, the section or the mode changed.
  dress() {
    const section = this.section.plane();
    if (section && !this.inside) this.shared.section.value.copy(section);
    else this.shared.section.value.set(0, 0, 0, 1);
    this.shown.forEach((shown, index) => {
      shown.group.visible = index === this.chosen;
      shown.dress({faces: this.faces, section, inside: this.inside, wallDepth: this.wallDepth || this.wallThickness, data: this.data?.uniform});
    });
    this.orbit.controls.enabled = !this.inside;
    this.touch();
    this.dispatchEvent(new Event('change'));
  }

  show(index) { this.chosen = index; this.dress(); }
  setWallDepth(wallDepth) { this.colourWalls(wallDepth, false); }
  setWallThickness(wallThickness) { this.colourWalls(!wallThickness && this.wallDepth, wallThickness); }
  /// One of both or neither.
  colourWalls(depth, thickness) {
    Object.assign(this, {wallDepth: depth, wallThickness: thickness});
    if (this.inside) this.markWalls();
    this.dress();
  }
  /// Is there an outside to measure to?
  get hasThickness() { return this.cavities.some(part => outsideOf(part, this.models[0].parts).length > 0); }
  setShade(shade) { this.shade = shade; this.dress(); }
  setFaces(faces) { this.faces = faces; this.dress(); }
  setLook(key, change) { Object.assign(this.looks.get(key), change); this.dress(); }
  cut(change) {
    if (change.side) this.section.choose(sides.find(side => side.name === change.side));
    if (change.reversed !== undefined && change.reversed !== this.section.reversed) this.section.reversed = change.reversed;
    if (change.at !== undefined) this.section.at = change.at;
    if (change.on !== undefined) this.section.on = change.on;
    this.dress();
    if (change.on || change.side || change.reversed !== undefined) this.faceTheCut();
  }
  /// Of the page's volume: {shows, cast, transfer, window, ...} as a scene file has it under "volume".
  setVolume(change) {
    const {look} = this.volume, begins = change.shows === 'both' && look.shows !== 'both';
    Object.assign(look, change);
    if (begins) for (const structure of this.looks.values()) if (!structure.as_body) structure.opacity = Math.min(structure.opacity, aroundVolume);
    this.dress();
  }
  setFilm(on) { this.shadow.on = on; this.dress(); }
  /// What shows an X-ray film, of the CT or of the model; null: nothing does.
  get film() { return this.caster?.isFilm ? this.caster : null; }
  /// {latitude, inverted, film_mm} of the film that is shown, or would be.
  get filmLook() { return this.volume?.look ?? this.shadow; }
  setFilmLook(change) {
    Object.assign(this.filmLook, change);
    if (change.film_mm && this.film && !this.inside) this.orbit.fit();   // its edge is to be seen
    this.dress();
  }
  setBeam(beam) { this.beam = beam; this.dress(); }
  /// Looks from where the tube of an X-ray machine stands, swung from buccal by degrees; positive: to the right of whoever looks.
  swingTube(degrees) {
    if (this.inside) this.leave();
    const angle = degrees * Math.PI / 180;
    this.orbit.goTo({towards: [-Math.sin(angle), Math.cos(angle), 0], up: [0, 0, 1]}, true);
  }
  /// A cut that is turned away is not seen: look at it from a little aside.
  faceTheCut() {
    const plane = this.section.plane();
    if (!plane || this.inside || this.headset.present) return;
    const normal = new Vector3(plane.x, plane.y, plane.z), towards = this.orbit.camera.position.clone().sub(this.orbit.controls.target).normalize();
    if (towards.dot(normal) > facing) return;
    const aside = Math.abs(normal.z) > 0.9 ? new Vector3(0, 0.6, 0) : new Vector3(-normal.y, normal.x, 0).multiplyScalar(0.35).add(new Vector3(0, 0, 0.25));
    this.orbit.goTo({towards: normal.add(aside).toArray(), up: [0, 0, 1]});
  }
  look(name) {
    if (this.inside) this.leave();
    this.orbit.goTo(views.find(view => view.name === name));
  }
  /// Flies to a place, in the model's millimetres, and marks it.
  lookAt(place) {
    if (this.inside) this.leave();
    this.orbit.lookAt(new Vector3(...place));
    this.labels.mark = new Vector3(...place);
    this.touch();
  }
  nextFaces() {
    const all = ['cull', 'show', 'tint'];
    this.setFaces(all[(all.indexOf(this.faces) + 1) % all.length]);
  }

  startTour(index) {
    this.enter();
    this.journey.startTour(this.tours[index]);
    this.journey.playing = true;
    this.dress();
  }
  /// `from`: {place, direction, up}; else from where one is within, or where one sees most.
  startFlight(from = null) {
    this.enter();
    this.journey.startFlight(from ? {...from, set: true} : flightStart(this.walls, this.tours, this.cavities, this.bounds));
    this.dress();
  }
  enter() {
    this.markWalls();
    if (!this.inside && !this.headset.present) this.dispatchEvent(new Event('enter'));
  }
  /// What the colours tell, measured when it is first to be seen.
  markWalls() {
    const what = this.wallThickness ? 'thickness' : 'depth';
    if (this.marked === what) return;
    this.marked = what;
    this.models.forEach(({parts}, index) => {
      for (const geometry of this.shown[index].voids) {
        const positions = geometry.getAttribute('position').array, known = this.wallColours.get(geometry) ?? {}, part = parts.find(one => one.geometry === geometry);
        const outside = what === 'thickness' && part ? outsideOf(part, parts) : [];
        known[what] ??= what === 'depth' ? wallDepths(positions, this.description.tours) : outside.length > 0 ? thicknessColours(positions, outside, depthStep(this.description.tours)) : new Float32Array(positions.length / 3).fill(-1);
        this.wallColours.set(geometry, known);
        geometry.setAttribute('wall_depth', new BufferAttribute(known[what], 1));
      }
    });
  }
  /// Of a geometry that has other corners now.
  forgetWalls(geometry) {
    geometry.deleteAttribute('wall_depth');
    this.wallColours.delete(geometry);
    this.marked = null;
    if (this.inside) this.markWalls();
  }
  leave() {
    this.journey.leave();
    this.dress();
  }
  play(on) { this.journey.playing = on; this.touch(); this.dispatchEvent(new Event('change')); }
  seek(mm) { this.journey.seek(mm); this.touch(); this.dispatchEvent(new Event('travel')); }

  resize() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height || this.renderer.xr.isPresenting) return;
    const ratio = Math.min(devicePixelRatio || 1, Math.sqrt(mostPixels / (width * height)));
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.orbit.resize(width / height);
    this.journey.resize(width / height);
    if (this.orbit.view) this.orbit.goTo(this.orbit.view, true);
    this.touch();
  }

  /// Moves what moves; draws if anything did.
  frame(seconds) {
    if (this.headset.present) {
      this.headset.update(seconds);
      this.touch();
    } else if (!this.inside) this.orbit.update(seconds);
    else if (this.journey.update(seconds)) {
      this.touch();
      this.dispatchEvent(new Event('travel'));
    }
    if (this.dirty) {
      this.tellDrawn(false);
      if (this.movedLast && this.caster) this.pace.note(seconds);
      else if (this.movedLast && this.quality.note(seconds)) this.dispatchEvent(new Event('change'));
      this.dirty = false;
      this.rested = 0;
      this.movedLast = true;
      this.draw({way: this.quality.moving, moving: true});
      return;
    }
    this.movedLast = false;
    this.rested += seconds;
    if (this.headset.present || !(this.caster ? this.rested > restBeforeCasting : this.quality.mayRefine(this.rested))) return;
    const way = this.wayOf(this.quality.still);
    if (this.picture.finished(way)) return this.tellDrawn(true);
    this.picture.refine(this.scene, this.camera, this.current, way);
  }

  /// For whoever takes a picture of the page: nothing is left to be made finer.
  tellDrawn(done) {
    if (done !== ('drawn' in document.documentElement.dataset)) document.documentElement.toggleAttribute('data-drawn', done);
  }

  /// What casts rays, if anything does.
  get caster() { return this.volume?.showsVolume ? this.volume : this.shadow?.on ? this.shadow : null; }
  wayOf({layers, shade}, moving = false) {
    const {caster} = this;
    if (this.volume) this.volume.coarseness = moving ? coarseSteps : 1;
    return {layers, shade: shade && this.shade, reach: shadeReach * this.bounds.radius, bounds: this.bounds, caster, scale: caster && moving ? this.pace.scale : 1};
  }
  get current() { return this.shown[this.chosen]; }

  /// Draws what is to be seen now. `complete`: every layer, however many; else as many as there lately were.
  draw({way = this.quality.still, moving = false, complete = false} = {}) {
    setLightFrame(this.shared, this.headset.present ? this.renderer.xr.getCamera() : null);
    const sight = this.inside ? this.journey.lengths.sight * this.world.scale.x : 0;
    this.shared.lamp.value.set(0.1 * sight, 0.16 * sight, 0, sight);   // in the hand beside the eye, as on the desktop
    this.picture.draw(this.scene, this.camera, this.current, {...this.wayOf(way, moving), complete});
    this.frames += 1;
    this.dispatchEvent(new Event('drawn'));
    if (this.headset.present) return;
    const plane = this.section.plane();
    this.pins.place(this.camera);
    this.labels.place(this.camera, {avoid: this.pins.boxes, hidden: this.inside || this.caster?.showsSurfaces === false, plane, width: this.canvas.clientWidth, height: this.canvas.clientHeight});
  }
}
