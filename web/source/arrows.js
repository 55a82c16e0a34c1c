// Arrows that a lesson draws in the picture: from a place to another, both in the model's space, with a label where they begin. Seen like pins: from outside
// through everything, inside only where no wall hides the head.
import {Vector3} from 'three';
import {element} from './dom.js';

const most = 50;
const drawing = 'http://www.w3.org/2000/svg';

/// Where an arrow lies in a picture of that size, in pixels: {x1, y1, x2, y2}; null: its head is not to be seen there. One that begins behind the eye begins at
/// the picture's near plane.
export function arrowIn(viewer, camera, {from, to}, width, height) {
  const head = to.clone().project(camera), x2 = (head.x + 1) / 2 * width, y2 = (1 - head.y) / 2 * height;
  if (head.z > 1 || head.z < -1 || x2 < 0 || x2 > width || y2 < 0 || y2 > height || (viewer.inside && !viewer.inSight(to))) return null;
  const away = point => -point.clone().applyMatrix4(camera.matrixWorldInverse).z, start = away(from), end = away(to);
  const tail = (start < camera.near ? to.clone().lerp(from, 0.98 * (end - camera.near) / (end - start)) : from.clone()).project(camera);
  return {x1: (tail.x + 1) / 2 * width, y1: (1 - tail.y) / 2 * height, x2, y2};
}

/// Its outline, of seven corners. A head is drawn whole however short the arrow comes out.
export function outlineOf({x1, y1, x2, y2}, {shaft = 2, half = 8, head = 17} = {}) {
  const length = Math.max(Math.hypot(x2 - x1, y2 - y1), 1e-3), ax = (x2 - x1) / length, ay = (y2 - y1) / length, neck = Math.min(head, length + head / 2);
  const at = (back, aside) => [x2 - back * ax - aside * ay, y2 - back * ay + aside * ax];
  return [at(length, shaft), at(Math.min(neck, length), shaft), at(neck, half), [x2, y2], at(neck, -half), at(Math.min(neck, length), -shaft), at(length, -shaft)];
}

export class Arrows {
  /// `host` holds the labels, `lines` is the drawing below them.
  constructor(viewer, host, lines) {
    Object.assign(this, {viewer, host, lines, arrows: []});
  }

  show(arrows) {
    this.arrows = arrows.slice(0, most).map(({from, to, label}) => {
      const shape = document.createElementNS(drawing, 'path'), words = element('span', {class: 'arrow'}, label ?? '');
      this.lines.append(shape);
      if (label) this.host.append(words);
      return {from: new Vector3(...from), to: new Vector3(...to), label: label ?? '', shape, words};
    });
  }

  /// Boxes of the labels in the picture, for others to keep clear of.
  place(camera, width, height) {
    const boxes = [];
    for (const {shape, words, label, ...ends} of this.arrows) {
      const at = arrowIn(this.viewer, camera, ends, width, height);
      for (const piece of [shape, words]) piece.style.display = at ? '' : 'none';
      if (!at) continue;
      shape.setAttribute('d', `M${outlineOf(at).map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join('L')}Z`);
      if (label) boxes.push(this.putLabel(words, at, boxes, width, height));
    }
    return boxes;
  }

  /// Beyond the tail as seen from the head; below labels that are there already.
  putLabel(words, {x1, y1, x2, y2}, boxes, width, height) {
    const length = Math.max(Math.hypot(x1 - x2, y1 - y2), 1e-3), room = words.offsetWidth, high = words.offsetHeight;
    const left = Math.min(Math.max(x1 + (x1 - x2) / length * (room / 2 + 2) - room / 2, 4), Math.max(width - room - 4, 4));
    let top = Math.min(Math.max(y1 + (y1 - y2) / length * (high / 2 + 2), high / 2 + 4), height - high / 2 - 4);
    for (const box of [...boxes].sort((a, b) => a.top - b.top)) if (box.left < left + room + 4 && box.right > left - 4 && Math.abs(box.top - top) < high + 2) top = box.top + high + 4;
    words.style.left = `${left}px`;
    words.style.top = `${top}px`;
    return {left, right: left + room, top};
  }
}
