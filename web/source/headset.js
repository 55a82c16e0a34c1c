// With a headset: the tooth enlarged, at arm's length; taken with one hand, made larger or smaller with both; flown through with the sticks.
import {
  CanvasTexture, Matrix4, Mesh, MeshBasicMaterial, PerspectiveCamera, PlaneGeometry, Quaternion, SphereGeometry, SRGBColorSpace, Vector3,
} from 'three';
import {t} from './language.js';
import {glide} from './walls.js';

const shownHeight = 0.4, armsLength = 0.65, below = 0.1;   // metres: of the tooth, to it, under the eyes
const least = 0.04, most = 20;                             // metres of the tooth's height
const roomsPerSecond = 0.9, growPerSecond = 2;
const dead = 0.15;                                         // of a stick's way

const standing = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2);   // z along the tooth becomes y

/// Calls back with whether a headset can be entered, now and whenever that changes.
export async function watchForHeadset(found) {
  if (!navigator.xr) return found(false);
  const ask = async () => found(await navigator.xr.isSessionSupported('immersive-vr').catch(() => false));
  navigator.xr.addEventListener?.('devicechange', ask);
  return ask();
}

/// three.js smooths the headset's edges if it finds that the canvas's are, which here they need not be.
function smoothEdgesOf(gl) {
  const attributes = gl.getContextAttributes();
  gl.getContextAttributes = () => ({...attributes, antialias: true});
}

export class Headset {
  constructor(viewer) {
    this.viewer = viewer;
    this.camera = new PerspectiveCamera(70, 1, 0.02, 60);
    this.hands = [0, 1].map(index => this.handOf(index));
    this.pressed = new Set();
  }

  handOf(index) {
    const grip = this.viewer.renderer.xr.getController(index), hand = {grip, holds: false, before: new Matrix4()};
    for (const name of ['select', 'squeeze']) {
      grip.addEventListener(`${name}start`, () => { hand.holds = true; hand.before.copy(grip.matrixWorld); });
      grip.addEventListener(`${name}end`, () => { hand.holds = false; });
    }
    grip.addEventListener('connected', event => { hand.source = event.data; });
    grip.addEventListener('disconnected', () => { hand.source = null; hand.holds = false; });
    grip.add(new Mesh(new SphereGeometry(0.012, 16, 12), new MeshBasicMaterial({color: 0x4cb4c0})));
    if (index === 0) grip.add(hint());
    return hand;
  }

  get present() { return this.viewer.renderer.xr.isPresenting; }

  async enter() {
    const {viewer} = this, {xr} = viewer.renderer;
    const session = await navigator.xr.requestSession('immersive-vr', {optionalFeatures: ['local-floor']});
    if (viewer.inside) viewer.leave();
    xr.enabled = true;
    xr.setReferenceSpaceType('local');
    smoothEdgesOf(viewer.renderer.getContext());
    await xr.setSession(session);
    viewer.scene.add(...this.hands.map(hand => hand.grip));
    this.placed = false;
    session.addEventListener('end', () => this.left());
    viewer.dispatchEvent(new Event('change'));
  }

  left() {
    const {viewer} = this;
    viewer.scene.remove(...this.hands.map(hand => hand.grip));
    viewer.renderer.xr.enabled = false;
    viewer.world.position.set(0, 0, 0);
    viewer.world.quaternion.identity();
    viewer.world.scale.setScalar(1);
    viewer.leave();
    viewer.resize();
  }

  /// In front of the eyes, upright, wherever they look.
  place() {
    const {world, bounds} = this.viewer, {position, forward} = this.head(), scale = shownHeight / (2 * bounds.radius);
    forward.y = 0;
    if (forward.lengthSq() < 1e-6) forward.set(0, 0, -1);
    forward.normalize();
    world.scale.setScalar(scale);
    // The buccal side, +y of the tooth, towards the eyes.
    world.quaternion.setFromAxisAngle(new Vector3(0, 1, 0), Math.atan2(forward.x, forward.z)).multiply(standing);
    const middle = position.clone().addScaledVector(forward, armsLength);
    middle.y -= below;
    this.put(bounds.centre, middle);
  }

  /// Moves the world so that the tooth's point `of` comes to lie at `place`.
  put(of, place) {
    const {world} = this.viewer;
    world.position.set(0, 0, 0);
    world.updateMatrixWorld(true);
    world.position.copy(place).sub(of.clone().applyMatrix4(world.matrixWorld));
    world.updateMatrixWorld(true);
  }

  head() {
    const seen = this.viewer.renderer.xr.getCamera(), position = new Vector3().setFromMatrixPosition(seen.matrixWorld);
    const turned = new Quaternion().setFromRotationMatrix(seen.matrixWorld);
    return {position, turned, forward: new Vector3(0, 0, -1).applyQuaternion(turned)};
  }

  update(seconds) {
    const {xr} = this.viewer.renderer;
    xr.updateCamera(this.camera);
    if (!this.placed && xr.getCamera().cameras.length > 0) {
      this.place();
      this.placed = true;
    }
    this.buttons();
    const stick = this.sticks();
    if (this.viewer.journey.mode === 'fly') this.fly(seconds, stick);
    else this.grab(seconds, stick);
  }

  /// Left (or only) stick: move; the other: turn and grow.
  sticks() {
    const axes = hand => {
      const a = this.hands.find(h => h.source?.handedness === hand)?.source.gamepad?.axes ?? [];
      return [a[2] ?? a[0] ?? 0, a[3] ?? a[1] ?? 0].map(x => Math.abs(x) < dead ? 0 : x);
    };
    const [side, back] = axes('left'), [turn, shrink] = axes('right');
    return {side, back, turn, shrink};
  }

  buttons() {
    const down = (index, act) => {
      const on = this.hands.some(hand => hand.source?.gamepad?.buttons[index]?.pressed);
      if (on && !this.pressed.has(index)) act();
      if (on) this.pressed.add(index);
      else this.pressed.delete(index);
    };
    const {viewer} = this;
    down(4, () => viewer.journey.mode === 'fly' ? this.comeOut() : this.goIn());
    down(5, () => viewer.cut({on: !viewer.section.on}));
    down(3, () => viewer.nextFaces());
  }

  goIn() {
    const {viewer} = this;
    viewer.startFlight();
    viewer.world.scale.setScalar(viewer.journey.lengths.metre);   // a canal is as wide as a door
    this.put(viewer.journey.camera.position, this.head().position);
  }

  comeOut() {
    this.viewer.leave();
    this.place();
  }

  /// The head's own way and the stick's, both held by the walls: where the head would go through one, the world moves along with it.
  fly(seconds, {side, back, turn}) {
    const {world, journey, walls} = this.viewer, {position, turned} = this.head(), scale = world.scale.x;
    if (turn) {
      const about = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -1.5 * turn * seconds);
      world.quaternion.premultiply(about);
      this.put(journey.camera.position, position);
    }
    const wanted = world.worldToLocal(position.clone()), pace = roomsPerSecond * Math.max(2 * journey.room(), journey.lengths.slowest) * seconds * scale;
    const stick = new Vector3(side, 0, back).multiplyScalar(pace).applyQuaternion(turned);
    wanted.add(world.worldToLocal(position.clone().add(stick))).sub(world.worldToLocal(position.clone()));
    const from = journey.camera.position, step = wanted.sub(from);
    from.fromArray(glide(walls, from.toArray(), step.toArray(), journey.body));
    this.put(from, position);
  }

  grab(seconds, {side, back, turn, shrink}) {
    const {world} = this.viewer, holding = this.hands.filter(hand => hand.holds);
    if (holding.length === 2) this.stretch(holding);
    else if (holding.length === 1) {
      const [{grip, before}] = holding;
      const moved = grip.matrixWorld.clone().multiply(before.clone().invert()).multiply(world.matrixWorld);
      moved.decompose(world.position, world.quaternion, world.scale);
    }
    for (const hand of this.hands) hand.before.copy(hand.grip.matrixWorld);
    world.updateMatrixWorld(true);
    const {turned} = this.head(), centre = this.viewer.bounds.centre, middle = centre.clone().applyMatrix4(world.matrixWorld);
    if (side || back) middle.add(new Vector3(side, 0, back).multiplyScalar(0.6 * seconds).applyQuaternion(turned));
    if (turn) world.quaternion.premultiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 1.5 * turn * seconds));
    if (shrink) this.grow(Math.pow(growPerSecond, -shrink * seconds));
    if (side || back || turn || shrink) this.put(centre, middle);
  }

  grow(factor) {
    const {world} = this.viewer;
    const height = 2 * this.viewer.bounds.radius;
    world.scale.setScalar(Math.min(most / height, Math.max(least / height, world.scale.x * factor)));
  }

  /// What lies between both hands stays between them: it moves, turns and grows with them.
  stretch([one, other]) {
    const {world} = this.viewer, at = (hand, matrix) => new Vector3().setFromMatrixPosition(matrix === 'now' ? hand.grip.matrixWorld : hand.before);
    const a0 = at(one, 'before'), b0 = at(other, 'before'), a1 = at(one, 'now'), b1 = at(other, 'now');
    const span0 = b0.clone().sub(a0), span1 = b1.clone().sub(a1);
    if (span0.length() < 1e-3 || span1.length() < 1e-3) return;
    const middle0 = world.worldToLocal(a0.add(b0).multiplyScalar(0.5)), middle1 = a1.add(b1).multiplyScalar(0.5);
    this.grow(span1.length() / span0.length());
    world.quaternion.premultiply(new Quaternion().setFromUnitVectors(span0.normalize(), span1.normalize()));
    this.put(middle0, middle1);
  }
}

/// A card on the first hand.
function hint() {
  const canvas = document.createElement('canvas'), context = canvas.getContext('2d');
  Object.assign(canvas, {width: 512, height: 300});
  context.fillStyle = '#1b1e22';
  context.fillRect(0, 0, 512, 300);
  context.fillStyle = '#e9edf0';
  context.font = '30px system-ui, sans-serif';
  [t('Trigger or grip: take the tooth'), t('Both hands: larger, smaller'), t('A or X: fly inside, come out'), t('B or Y: cut open'), t('Left stick: move'), t('Right stick: turn, grow')]
    .forEach((line, i) => context.fillText(line, 24, 52 + 44 * i));
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  const card = new Mesh(new PlaneGeometry(0.16, 0.094), new MeshBasicMaterial({map: texture}));
  card.position.set(0, 0.06, -0.04);
  card.rotation.x = -0.6;
  return card;
}
