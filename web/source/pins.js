// Pins that a lesson sets: a dot at a place, with a label or a question mark. Seen from outside through everything, inside only where no wall hides them.
import {Vector3} from 'three';
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
    this.boxes = [];   // of the labels in the picture, for others to keep clear of
  }

  /// `bare`: what a pin without a label says.
  show(marks, bare = '') {
    this.host.replaceChildren(this.lines);
    this.lines.replaceChildren();
    this.pins = marks.slice(0, most).map(({at, label}) => {
      const line = document.createElementNS(drawing, 'line'), dot = document.createElementNS(drawing, 'circle'), words = element('span', {}, label || bare);
      dot.setAttribute('r', 6);
      this.lines.append(line, dot);
      if (label || bare) this.host.append(words);
      return {at: new Vector3(...at), line, dot, words};
    });
    this.host.setAttribute('role', 'note');
    this.host.setAttribute('aria-label', this.pins.map(pin => pin.words.textContent).filter(Boolean).join(', '));
    this.host.hidden = this.pins.length === 0;
    this.viewer.touch();
  }

  place(camera) {
    const {viewer} = this, width = viewer.canvas.clientWidth, height = viewer.canvas.clientHeight, taken = [];
    camera.updateMatrixWorld();
    this.boxes = [];
    const middle = this.pins.reduce((sum, {at}) => sum + at.clone().project(camera).x, 0) / Math.max(1, this.pins.length);
    for (const {at, line, dot, words} of this.pins) {
      const p = at.clone().project(camera), x = (p.x + 1) / 2 * width, y = (1 - p.y) / 2 * height;
      const hidden = p.z > 1 || p.z < -1 || x < 0 || x > width || y < 0 || y > height || (viewer.inside && !viewer.inSight(at));
      for (const piece of [line, dot, words]) piece.style.display = hidden ? 'none' : '';
      if (hidden) continue;
      dot.setAttribute('cx', x);
      dot.setAttribute('cy', y);
      // Outwards from the pins' middle: a label is not to cover another pin.
      const room = words.offsetWidth, outwards = this.pins.length > 1 && p.x < middle - 1e-6 ? x - 30 - room >= 4 : x + 30 + room > width;
      const left = outwards ? Math.max(4, x - 30 - room) : x + 30;
      let top = Math.min(Math.max(y - 26, 20), height - 20);
      for (const other of taken) if (Math.abs(other.left - left) < 140 && Math.abs(other.top - top) < 30) top = other.top + 32;
      taken.push({left, top});
      this.boxes.push({left, right: left + room, top});
      words.style.left = `${left}px`;
      words.style.top = `${top}px`;
      for (const [key, value] of [['x1', x], ['y1', y], ['x2', left < x ? left + room : left], ['y2', top]]) line.setAttribute(key, value);
    }
  }
}
