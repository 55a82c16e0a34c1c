// Inside the tooth: tours along canals, and flying with walls that hold.
import {MathUtils, PerspectiveCamera, Quaternion, Vector3} from 'three';
import {number, t} from './language.js';
import {glide} from './walls.js';
import {Way} from './way.js';

const fieldOfView = 72;          // degrees, from top to bottom of the picture
const leastAcross = 56;          // and at least from side to side, on a phone held upright
const turnSpeed = 1.6;           // radians a second
const bodyOfGap = 0.5;           // the body is at most this part of the room at its start

/// Lengths that suit a tooth, for a model of whatever size and unit: a scan's may be counted in voxels.
export function lengthsFor(radius) {
  const one = radius / 11.5;     // a molar's, mm
  return {body: 0.12 * one, lookAhead: 0.9 * one, sight: 2.5 * one, farthestNear: one, slowest: 0.4 * one, fastest: 7 * one, step: 0.25 * one, metre: 0.8 / one};
}

/// A canal's way with its name, for what thinks in vectors. `mm` is along the canal's line, from the chamber on.
export class Tour {
  constructor(tour) {
    this.name = tour.name;
    this.canalLength = tour.length_mm;   // from the orifice; the way begins in the chamber
    this.orifice = tour.orifice_mm;      // along the way; null: there is none
    this.way = new Way(tour);
    this.length = this.way.length;
  }

  placeInWords(mm) {
    if (this.orifice === null) return t('{here} of {whole} mm', {here: number(mm, 1), whole: number(this.length, 1)});
    return mm < this.orifice ? t('in the chamber')
      : t('{here} of {whole} mm below the orifice', {here: number(mm - this.orifice, 1), whole: number(this.canalLength, 1)});
  }

  place(mm) { return new Vector3(...this.way.atLength(mm).place); }
  direction(mm) { return new Vector3(...this.way.atLength(mm).direction); }
  up(mm) { return new Vector3(...this.way.atLength(mm).up); }
  nearest(place) { return this.way.nearest(place.toArray()); }
}

/// The eye within the void. Its place keeps its distance from the walls, whatever moves it.
export class Journey {
  constructor(tree, tours, bounds) {
    this.tree = tree;
    this.tours = tours;
    this.bounds = bounds;
    this.lengths = lengthsFor(bounds.radius);
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    this.mode = null;        // 'tour' or 'fly'
    this.playing = false;
    this.mm = this.seconds = 0;   // of the tour
    this.body = this.lengths.body;
    this.speed = {forward: 0, side: 0, rise: 0, turn: 0, tilt: 0};
    this.still = matchMedia('(prefers-reduced-motion: reduce)');
  }

  resize(aspect) {
    const {radToDeg, degToRad} = MathUtils;
    this.camera.aspect = aspect;
    this.camera.fov = Math.max(fieldOfView, 2 * radToDeg(Math.atan(Math.tan(degToRad(leastAcross) / 2) / aspect)));
  }

  startTour(tour) {
    this.mode = 'tour';
    this.tour = tour;
    this.stopAt = null;
    this.seek(0);
  }

  seek(mm) { this.goTo(this.tour.way.timeAt(mm)); }

  /// As the tour stands there so many seconds after its start.
  goTo(seconds) {
    this.seconds = MathUtils.clamp(seconds, 0, this.tour.way.seconds);
    const {mm, place, direction, up} = this.tour.way.atTime(this.seconds);
    this.mm = mm;
    this.camera.position.set(...place);
    this.camera.up.set(...up);
    this.camera.lookAt(this.camera.position.clone().add(new Vector3(...direction)));
  }

  /// From where one is, if that is within the void; else from `start`.
  startFlight(start) {
    if (this.mode !== 'tour' || start.set) {
      this.camera.position.copy(start.place);
      this.camera.up.copy(start.up);
      this.camera.lookAt(start.place.clone().add(start.direction));
    }
    this.mode = 'fly';
    this.playing = false;
    this.body = Math.min(this.lengths.body, bodyOfGap * this.room());
  }

  leave() {
    this.mode = null;
    this.playing = false;
  }

  /// Distance to the nearest wall, mm.
  room(place = this.camera.position) { return this.tree.nearest(place.toArray()).distance; }

  /// True if the picture changes.
  update(seconds) {
    if (this.mode === 'tour') return this.updateTour(seconds);
    if (this.mode === 'fly') return this.updateFlight(seconds);
    return false;
  }

  updateTour(seconds) {
    this.setNear();
    if (!this.playing) return false;
    this.pause = (this.pause ?? 0) + seconds;
    const stepwise = this.still.matches;
    if (stepwise && this.pause < 1.5) return false;   // still pictures in place of motion
    const {way} = this.tour, stop = this.stopAt !== null && this.mm < this.stopAt ? this.stopAt : this.tour.length;
    const next = stepwise ? way.timeAt(this.mm + this.tour.length / 12) : this.seconds + seconds;
    this.goTo(Math.min(stop < this.tour.length ? way.timeAt(stop) : way.seconds, next));
    this.pause = 0;
    if (this.mm >= stop - 1e-9) this.playing = false;
    return true;
  }

  updateFlight(seconds) {
    this.setNear();
    const {forward, side, rise, turn, tilt} = this.speed;
    if (!forward && !side && !rise && !turn && !tilt) return false;
    this.turnBy(turn * turnSpeed * seconds, tilt * turnSpeed * seconds);
    // Fast where there is room, slow in narrow canals.
    const pace = MathUtils.clamp(2.5 * this.room(), this.lengths.slowest, this.lengths.fastest) * seconds;
    const step = new Vector3(side, rise, -forward).multiplyScalar(pace).applyQuaternion(this.camera.quaternion);
    this.moveBy(step);
    return true;
  }

  moveBy(step) { this.camera.position.fromArray(glide(this.tree, this.camera.position.toArray(), step.toArray(), this.body)); }

  turnBy(turn, tilt) {
    const q = this.camera.quaternion;
    q.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -turn)).multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), tilt)).normalize();
  }

  /// So near that the corners of the picture never lie behind a wall.
  setNear() {
    const t = Math.tan(MathUtils.degToRad(this.camera.fov) / 2), corner = Math.hypot(1, t, t * this.camera.aspect);
    this.camera.near = 0.9 * Math.max(Math.min(this.room(), this.lengths.farthestNear), 1e-3 * this.lengths.farthestNear) / corner;
    this.camera.far = 6 * this.bounds.radius;
    this.camera.updateProjectionMatrix();
  }
}

/// Where to begin a flight: half way along a tour's first bit, or the roomiest place between opposite walls of the cavity; without a cavity in
/// front of the tooth.
export function flightStart(tree, tours, cavities, bounds) {
  if (tours.length > 0) {
    const tour = tours[0];
    return {place: tour.place(0), direction: tour.direction(0), up: tour.up(0)};
  }
  const place = cavities.length > 0 ? roomiest(tree, cavities, 1e-6 * bounds.radius) : null;
  if (place) return {place, direction: new Vector3(0, 0, -1), up: new Vector3(0, 1, 0)};
  const front = bounds.centre.clone().addScaledVector(new Vector3(0, 1, 0), 2.2 * bounds.radius);
  return {place: front, direction: new Vector3(0, -1, 0), up: new Vector3(0, 0, 1)};
}

/// A cavity's walls face into the void: from a place on one along its normal to the wall opposite, half way, for some places.
function roomiest(tree, cavities, little) {
  let best = null, most = 0;
  for (const {geometry, kind} of cavities) {
    const positions = geometry.attributes.position, normals = geometry.attributes.normal, step = Math.max(1, Math.floor(positions.count / 150));
    for (let i = 0; i < positions.count; i += step) {
      const wall = new Vector3().fromBufferAttribute(positions, i), normal = new Vector3().fromBufferAttribute(normals, i).multiplyScalar(kind === 'cavity' ? 1 : -1);
      // Away from the wall as long as the room grows, by less than what there is, so that no wall is crossed.
      let place = wall.clone().addScaledVector(normal, little), room = tree.nearest(place.toArray()).distance;
      for (let k = 0; k < 80; ++k) {
        const next = place.clone().addScaledVector(normal, 0.7 * room), there = tree.nearest(next.toArray()).distance;
        if (there <= room) break;
        [place, room] = [next, there];
      }
      if (room > most && Math.abs(tree.winding(place.toArray())) > 0.5) [best, most] = [place, room];   // a normal at a sharp crease may lead out
    }
  }
  return best;
}
