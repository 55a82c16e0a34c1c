// Where one looks from: the named views of a tooth, all of it in the picture, and the way from one view to the next.
import {MathUtils, OrthographicCamera, PerspectiveCamera, Vector3} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {t} from './language.js';

const fieldOfView = 24, margin = 1.08, moveSeconds = 0.5, nearby = 1.6;   // nearby: how far from a place to look at, in radii of the model

/// Directions towards the eye, and what is up; buccal is +y, mesial +x, occlusal +z.
export const views = [
  {name: 'three-quarter', words: t('Three quarters'), key: '0', towards: [-0.45, 0.8, 0.4], up: [0, 0, 1]},
  {name: 'buccal', words: t('Buccal'), key: '1', towards: [0, 1, 0], up: [0, 0, 1]},
  {name: 'lingual', words: t('Lingual'), key: '2', towards: [0, -1, 0], up: [0, 0, 1]},
  {name: 'mesial', words: t('Mesial'), key: '3', towards: [1, 0, 0], up: [0, 0, 1]},
  {name: 'distal', words: t('Distal'), key: '4', towards: [-1, 0, 0], up: [0, 0, 1]},
  {name: 'occlusal', words: t('Occlusal'), key: '5', towards: [0, -0.02, 1], up: [0, 0, 1]},
  {name: 'apical', words: t('Apical'), key: '6', towards: [0, 0.02, -1], up: [0, 0, 1]},
];

export class Orbit {
  /// `changed` is called whenever the picture must be drawn anew.
  constructor(canvas, bounds, sample, changed) {
    this.bounds = bounds;
    this.sample = sample;   // points that must be in the picture,
    this.filmSize = () => [0, 0];   // and width and height of a film that hangs at the middle, mm
    this.changed = changed;
    this.still = matchMedia('(prefers-reduced-motion: reduce)');
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.1, 1000);
    this.camera.up.set(0, 0, 1);
    this.parallelCamera = new OrthographicCamera();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.minDistance = 0.15 * bounds.radius;
    this.farthest = this.controls.maxDistance = 30 * bounds.radius;
    this.controls.addEventListener('change', changed);
    this.controls.addEventListener('start', () => { this.move = this.view = null; });
    this.move = null;
  }

  resize(aspect) {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /// Looks along the camera's line of sight by rays that all run one way: what lies at the middle of the model keeps its size.
  get parallel() {
    const {camera, parallelCamera: own, bounds: {centre}} = this;
    const depth = centre.clone().sub(camera.position).dot(camera.getWorldDirection(new Vector3()));
    own.top = Math.max(depth, camera.near) * Math.tan(MathUtils.degToRad(camera.fov) / 2);
    own.right = own.top * camera.aspect;
    Object.assign(own, {bottom: -own.top, left: -own.right, near: camera.near, far: camera.far});
    own.position.copy(camera.position);
    own.quaternion.copy(camera.quaternion);
    own.updateProjectionMatrix();
    own.updateMatrixWorld();
    return own;
  }

  /// Far enough for every sampled point to be seen from this side.
  distanceFrom(towards, up) {
    const right = new Vector3().crossVectors(up, towards).normalize(), top = new Vector3().crossVectors(towards, right);
    const tanY = Math.tan(MathUtils.degToRad(fieldOfView) / 2) / margin, tanX = tanY * this.camera.aspect;
    const [width, height] = this.filmSize();
    let distance = Math.max(0.5 * width / tanX, 0.5 * height / tanY);
    for (const p of this.sample) {
      const v = p.clone().sub(this.bounds.centre), deep = v.dot(towards);
      distance = Math.max(distance, deep + Math.abs(v.dot(right)) / tanX, deep + Math.abs(v.dot(top)) / tanY);
    }
    return distance;
  }

  /// From afar enough to see what a camera of a file sees from top to bottom, and at least as much from side to side.
  distanceOf({position, target, field_of_view_deg: angle = fieldOfView, height_mm: height, parallel}) {
    const far = new Vector3(...position).distanceTo(new Vector3(...target));
    const seen = parallel ? height ?? 25 : 2 * far * Math.tan(MathUtils.degToRad(angle) / 2);
    return 0.5 * seen / Math.tan(MathUtils.degToRad(fieldOfView) / 2) * Math.max(1, 1 / this.camera.aspect);
  }

  /// `view`: {towards, up}, all of the model in the picture, and with a `pose` what that camera of a file sees.
  goTo(view, atOnce = false) {
    const towards = new Vector3(...view.towards).normalize(), up = new Vector3(...view.up), {pose} = view, goal = pose ? new Vector3(...pose.target) : this.bounds.centre;
    if (Math.abs(towards.z) > 0.9995) towards.addScaledVector(up, -0.02).normalize();   // what is up in the picture is told by a little tilt
    const distance = pose ? this.distanceOf(pose) : this.distanceFrom(towards, up);
    this.controls.maxDistance = Math.max(this.farthest, distance);   // a film may be much larger than what it shows
    const position = goal.clone().addScaledVector(towards, distance);
    this.view = view;
    if (atOnce || this.still.matches) {
      this.move = null;
      this.camera.position.copy(position);
      this.controls.target.copy(goal);
      this.controls.update();
      this.changed();
      return;
    }
    const from = this.camera.position.clone().sub(this.controls.target), to = position.clone().sub(goal);
    this.move = {from, to, target: this.controls.target.clone(), goal: goal.clone(), part: 0};
    this.changed();
  }

  /// What lies round a place, from where one looks.
  lookAt(place) {
    const from = this.camera.position.clone().sub(this.controls.target), to = from.clone().normalize().multiplyScalar(Math.max(this.controls.minDistance, nearby * this.bounds.radius));
    this.view = null;
    if (this.still.matches) {
      this.controls.target.copy(place);
      this.camera.position.copy(place).add(to);
      this.controls.update();
    } else {
      this.move = {from, to, target: this.controls.target.clone(), goal: place.clone(), part: 0};
    }
    this.changed();
  }

  /// All of it, from where one looks.
  fit() { this.goTo({towards: this.camera.position.clone().sub(this.controls.target).toArray(), up: [0, 0, 1]}); }

  /// Nearer or farther, round the side or over the top, by keys.
  nudge({turn = 0, tilt = 0, nearer = 1}) {
    this.move = this.view = null;   // the person's own choice is kept when the window changes
    const offset = this.camera.position.clone().sub(this.controls.target);
    const distance = MathUtils.clamp(offset.length() * nearer, this.controls.minDistance, this.controls.maxDistance);
    const round = Math.atan2(offset.y, offset.x) + turn, over = MathUtils.clamp(Math.asin(offset.z / offset.length()) + tilt, -1.55, 1.55);
    offset.set(Math.cos(over) * Math.cos(round), Math.cos(over) * Math.sin(round), Math.sin(over)).multiplyScalar(distance);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.changed();
  }

  update(seconds) {
    if (this.move) {
      const move = this.move;
      move.part = Math.min(1, move.part + seconds / moveSeconds);
      const s = move.part * move.part * (3 - 2 * move.part);
      const length = MathUtils.lerp(move.from.length(), move.to.length(), s);
      const direction = slerp(move.from.clone().normalize(), move.to.clone().normalize(), s);
      this.controls.target.lerpVectors(move.target, move.goal ?? this.bounds.centre, s);
      this.camera.position.copy(this.controls.target).addScaledVector(direction, length);
      this.controls.update();
      if (move.part >= 1) this.move = null;
      this.changed();
    }
    const distance = this.camera.position.distanceTo(this.bounds.centre);
    this.camera.near = Math.max(distance - 1.5 * this.bounds.radius, 0.01 * this.bounds.radius);
    this.camera.far = distance + 1.5 * this.bounds.radius;
    this.camera.updateProjectionMatrix();
  }
}

function slerp(a, b, s) {
  const angle = a.angleTo(b);
  if (angle < 1e-4) return b;
  if (angle > Math.PI - 1e-3) a = a.clone().add(new Vector3(0.01, 0.02, 0)).normalize();
  return a.clone().multiplyScalar(Math.sin((1 - s) * angle)).addScaledVector(b, Math.sin(s * angle)).normalize();
}
