// Pins that a lesson sets: a dot at a place, with a label or a question mark. Seen from outside through everything, inside only where no wall hides them.
import {Vector3} from 'three';
import {Arrows} from './arrows.js';
import {element} from './dom.js';

const most = 50;
const drawing = 'http://www.w3.org/2000/svg';

export class Pins {
  constructor(viewer) {
    this.viewer = viewer;
    this.host = element('div', {id: 'pins'});
    this.lines = document.createElementNS(drawing, 'svg');
    this.host.append(this.lines);
    document.getElementById('labels').after(this.host);
    this.pins = [];
    this.arrows = new Arrows(viewer, this.host, this.lines);
    this.boxes = [];   // of the labels in the picture, for others to keep clear of
  }

  /// `bare`: what a pin without a label says. `arrows`: see arrows.js.
  show(marks, bare = '', arrows = []) {
    this.host.replaceChildren(this.lines);
    this.lines.replaceChildren();
    this.pins = marks.slice(0, most).map(({at, label}) => {
      const line = document.createElementNS(drawing, 'line'), dot = document.createElementNS(drawing, 'circle'), words = element('span', {}, label || bare);
      dot.setAttribute('r', 6);
      this.lines.append(line, dot);
      if (label || bare) this.host.append(words);
      return {at: new Vector3(...at), line, dot, words};
    });
    this.arrows.show(arrows);
    this.host.setAttribute('role', 'note');
    this.host.setAttribute('aria-label', [...this.pins, ...this.arrows.arrows].map(({words}) => words.textContent).filter(Boolean).join(', '));
    this.host.hidden = this.pins.length + this.arrows.arrows.length === 0;
    this.viewer.touch();
  }

  place(camera) {
    const {viewer} = this, width = viewer.canvas.clientWidth, height = viewer.canvas.clientHeight, seen = [];
    camera.updateMatrixWorld();
    this.boxes = this.arrows.place(camera, width, height);
    for (const pin of this.pins) {
      const p = pin.at.clone().project(camera), x = (p.x + 1) / 2 * width, y = (1 - p.y) / 2 * height;
      const hidden = p.z > 1 || p.z < -1 || x < 0 || x > width || y < 0 || y > height || (viewer.inside && !viewer.inSight(pin.at));
      for (const piece of [pin.line, pin.dot, pin.words]) piece.style.display = hidden ? 'none' : '';
      if (!hidden) seen.push({...pin, x, y});
    }
    const middle = seen.reduce((sum, {x}) => sum + x, 0) / Math.max(1, seen.length);
    for (const {x, y, line, dot, words} of seen.sort((a, b) => a.y - b.y)) {
      dot.setAttribute('cx', x);
      dot.setAttribute('cy', y);
      const room = words.offsetWidth, outwards = seen.length > 1 && x < middle - 1e-6 ? -1 : 1;
      const {left, top} = this.freePlace({x, y, room, outwards, width, height}, seen);
      this.boxes.push({left, right: left + room, top});
      words.style.left = `${left}px`;
      words.style.top = `${top}px`;
      for (const [key, value] of [['x1', x], ['y1', y], ['x2', Math.min(Math.max(x, left), left + room)], ['y2', top]]) line.setAttribute(key, value);
    }
  }

  /// Beside the pin, outwards first, where the label covers neither a pin nor a label.
  freePlace({x, y, room, outwards, width, height}, seen) {
    const places = [26, 60, 94].flatMap(far => [outwards, -outwards].flatMap(side => [-far, far].map(down =>
      ({left: Math.min(Math.max(side > 0 ? x + 30 : x - 30 - room, 4), width - room - 4), top: Math.min(Math.max(y + down, 20), height - 20)}))));
    const free = ({left, top}) => seen.every(pin => pin.x < left - 8 || pin.x > left + room + 8 || Math.abs(pin.y - top) > 22) &&
      this.boxes.every(box => box.right < left - 4 || box.left > left + room + 4 || Math.abs(box.top - top) > 29);
    return places.find(free) ?? places[0];
  }
}
