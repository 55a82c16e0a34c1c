// Inside, what tells where one is: the millimetre of each ring on the wall, the way ahead, rims of orifices, and names. Drawn over the picture, always
// facing the eye, and only where no wall hides it.
import {Vector3} from 'three';
import {depthStep} from './depth.js';
import {element} from './dom.js';
import {named} from './language.js';

const drawing = 'http://www.w3.org/2000/svg';
const ringsAhead = 7, rimCorners = 40, wayPoints = 24;
const leastPixels = 11, mostPixels = 28;   // of a number
const numberSize = 0.26;                   // of the canal's width there
const farWay = 8;                          // steps of the way ahead that are drawn

/// Of what would lie upon each other only the first.
function apart(told) {
  const kept = [];
  for (const one of told) {
    const covers = other => Math.abs(other.on.x - one.on.x) < 0.5 * (widthOf(one) + widthOf(other)) && Math.abs(other.on.y - one.on.y) < 0.75 * (one.pixels + other.pixels);
    if (!kept.some(covers)) kept.push(one);
  }
  return kept;
}
const widthOf = ({text, pixels}) => (0.6 * text.length + 0.8) * pixels;

export class Cues {
  constructor(viewer) {
    this.viewer = viewer;
    this.on = true;
    this.host = element('div', {id: 'cues', 'aria-hidden': 'true'});
    this.svg = document.createElementNS(drawing, 'svg');
    this.way = this.svg.appendChild(document.createElementNS(drawing, 'path'));
    this.way.setAttribute('class', 'way');
    this.rims = this.svg.appendChild(document.createElementNS(drawing, 'path'));
    this.rims.setAttribute('class', 'rim');
    this.host.append(this.svg);
    document.getElementById('labels').after(this.host);
    this.words = [];
    this.step = depthStep(viewer.description.tours);
    this.prepared = null;
    viewer.addEventListener('drawn', () => this.place());
  }

  /// Once: where each ring's number stands, and each orifice's rim.
  prepare() {
    const {viewer} = this;
    return viewer.tours.map(tour => {
      const rings = [], {orifice, length} = tour;
      if (orifice === null) return {tour, rings, rim: [], name: null};
      for (let k = 1; orifice + k * this.step <= length - 0.1 * this.step; ++k) {
        const mm = orifice + k * this.step, middle = tour.place(mm), down = tour.up(mm).clone().negate(), reach = this.toWall(middle, down);
        rings.push({mm, text: `${k * this.step}`, at: middle.addScaledVector(down, 0.78 * reach), width: 2 * reach});
      }
      return {tour, rings, rim: orifice > 0 ? this.rimOf(tour) : [], name: tour.place(Math.min(orifice + 0.3 * this.step, length))};
    });
  }

  rimOf(tour) {
    const middle = tour.place(tour.orifice), along = tour.direction(tour.orifice), up = tour.up(tour.orifice), side = new Vector3().crossVectors(along, up).normalize(), points = [];
    for (let i = 0; i < rimCorners; ++i) {
      const angle = 2 * Math.PI * i / rimCorners, way = up.clone().multiplyScalar(Math.cos(angle)).addScaledVector(side, Math.sin(angle)).normalize();
      points.push(middle.clone().addScaledVector(way, 0.97 * Math.min(this.toWall(middle, way), 4 * this.viewer.journey.room(middle))));
    }
    return points;
  }

  /// From within along a direction to the wall, mm.
  toWall(from, direction) {
    const {walls, bounds} = this.viewer, little = 1e-3 * bounds.radius, p = from.clone();
    let far = 0;
    for (let i = 0; i < 40 && far < 2 * bounds.radius; ++i) {
      const {distance} = walls.nearest(p.toArray());
      if (distance < little) break;
      far += distance;
      p.addScaledVector(direction, distance);
    }
    return far;
  }

  place() {
    const {viewer} = this, {journey} = viewer, shown = this.on && viewer.inside && viewer.tours.length > 0 && !viewer.headset.present;
    this.host.hidden = !shown;
    if (!shown) return;
    this.prepared ??= this.prepare();
    const {camera, canvas} = viewer, width = canvas.clientWidth, height = canvas.clientHeight;
    const focal = 0.5 * height / Math.tan(camera.fov * Math.PI / 360), forward = camera.getWorldDirection(new Vector3());
    const seen = p => {
      const deep = p.clone().sub(camera.position).dot(forward);
      if (deep <= camera.near) return null;
      const q = p.clone().project(camera);
      return {x: (q.x + 1) / 2 * width, y: (1 - q.y) / 2 * height, deep};
    };
    const inPicture = at => at && at.x > 8 && at.y > 8 && at.x < width - 8 && at.y < height - 8;
    const told = [];
    for (const {tour, rings, name} of this.prepared) {
      const here = journey.mode === 'tour' && tour === journey.tour;
      if (journey.mode === 'tour' && !here && journey.mm > (journey.tour.orifice ?? 0) + 1) continue;
      for (const {at, text, width: wide} of rings) {
        const on = seen(at);
        if (!inPicture(on) || viewer.wallThickness) continue;   // the lines are no depths then
        const pixels = numberSize * wide * focal / on.deep;
        if (pixels >= leastPixels && viewer.inSight(at)) told.push({on, text: `${text}`, pixels: Math.min(pixels, mostPixels), kind: 'number', deep: on.deep});
      }
      const on = name && seen(name);
      if (inPicture(on) && viewer.inSight(name) && !(here && journey.mm > tour.orifice - 0.2)) told.push({on, text: named(tour.name), pixels: 15, kind: 'name', deep: on.deep});
    }
    for (const {name, tip} of this.hornTips()) {
      const on = seen(tip);
      if (inPicture(on) && viewer.inSight(tip)) told.push({on, text: named(name), pixels: 15, kind: 'name', deep: on.deep});
    }
    this.write(apart(told.sort((a, b) => a.deep - b.deep)).slice(0, ringsAhead + 8));
    this.rims.setAttribute('d', this.prepared.map(({rim}) => this.loop(rim, seen)).join(''));
    this.way.setAttribute('d', journey.mode === 'tour' ? this.ahead(journey, seen) : '');
  }

  hornTips() { return this.viewer.horns.map(horn => ({name: horn.name, tip: horn.place(0.85 * horn.length)})); }

  write(told) {
    while (this.words.length < told.length) this.words.push(this.host.appendChild(element('span')));
    this.words.forEach((span, i) => {
      const one = told[i];
      span.style.display = one ? '' : 'none';
      if (!one) return;
      span.textContent = one.text;
      span.className = one.kind;
      const half = 0.5 * widthOf(one) + 6, x = Math.min(Math.max(one.on.x, half), this.viewer.canvas.clientWidth - half);   // a name at the edge stays whole
      Object.assign(span.style, {left: `${x}px`, top: `${one.on.y}px`, fontSize: `${one.pixels}px`});
    });
  }

  /// The parts of a rim that no wall hides.
  loop(points, seen) {
    let path = '', open = false;
    [...points, ...points.slice(0, 1)].forEach(p => {
      const at = seen(p), {clientWidth, clientHeight} = this.viewer.canvas;   // what is nowhere near the picture costs nothing
      const near = at && Math.abs(at.x - 0.5 * clientWidth) < clientWidth && Math.abs(at.y - 0.5 * clientHeight) < clientHeight;
      const on = near && this.viewer.inSight(p) ? at : null;
      if (on) path += `${open ? 'L' : 'M'}${on.x.toFixed(1)} ${on.y.toFixed(1)}`;
      open = Boolean(on);
    });
    return path;
  }

  /// From just before one's feet on, as far as it is seen.
  ahead({tour, mm, lengths}, seen) {
    let path = '', low = null;
    for (let i = 1; i <= wayPoints; ++i) {
      const at = mm + lengths.lookAhead * (0.35 + i / wayPoints * farWay * 0.5);
      if (at > tour.length) break;
      const p = tour.place(at);
      if (i % 2 === 1 && !this.viewer.inSight(p)) break;
      low ??= 0.55 * this.viewer.journey.room(tour.place(mm));
      const on = seen(p.addScaledVector(tour.up(at), -Math.min(low, 0.55 * this.viewer.journey.room(p))));
      if (on) path += `${path ? 'L' : 'M'}${on.x.toFixed(1)} ${on.y.toFixed(1)}`;
    }
    return path;
  }
}
