// Names beside the tooth, each with a line to a place on its structure.
import {Vector3} from 'three';
import {element} from './dom.js';

const most = 160;                                   // places of a structure among which one is chosen
const levels = [0.72, 0.3, 0.62, 0.5, 0.2, 0.85];   // how high each structure's label stands, in its own height
const drawing = 'http://www.w3.org/2000/svg';

export class Labels {
  constructor(parts, looks) {
    this.host = document.getElementById('labels');
    this.lines = document.createElementNS(drawing, 'svg');
    this.host.append(this.lines);
    this.on = true;
    this.looks = looks;
    this.named = parts.filter(part => part.kind !== 'cavity' || looks.get(part.key).as_body).map((part, index) => this.labelOf(part, index));
  }

  labelOf(part, index) {
    const positions = part.geometry.attributes.position, box = part.geometry.boundingBox;
    const height = box.min.z + levels[index % levels.length] * (box.max.z - box.min.z), near = 0.12 * (box.max.z - box.min.z);
    const places = [], p = new Vector3(), step = Math.max(1, Math.floor(positions.count / (8 * most)));
    for (let i = 0; i < positions.count && places.length < most; i += step)
      if (Math.abs(p.fromBufferAttribute(positions, i).z - height) < near) places.push(p.clone());
    if (places.length === 0) places.push(box.getCenter(new Vector3()));
    const words = element('span', {}, part.key.endsWith(' cavity') && this.looks.get(part.key).as_body ? `${part.structure}: cavity` : part.structure);
    const line = document.createElementNS(drawing, 'line'), dot = document.createElementNS(drawing, 'circle');
    dot.setAttribute('r', 3);
    this.lines.append(line, dot);
    this.host.append(words);
    return {part, places, words, line, dot, right: index % 2 === 0};
  }

  /// `cut`: is this place cut away?
  place(camera, {hidden, cut, width, height}) {
    const taken = {true: [], false: []};
    for (const label of this.named) {
      const look = this.looks.get(label.part.key), shown = this.on && !hidden && look.visible && look.opacity > 0;
      const at = shown ? this.outermost(label, camera, cut, width, height) : null;
      for (const piece of [label.words, label.line, label.dot]) piece.style.display = at ? '' : 'none';
      if (at) this.put(label, at, taken[label.right], width, height);
    }
  }

  outermost(label, camera, cut, width, height) {
    let best = null;
    const p = new Vector3();
    for (const place of label.places) {
      if (cut(place)) continue;
      p.copy(place).project(camera);
      if (p.z > 1) continue;
      const at = {x: (0.5 + 0.5 * p.x) * width, y: (0.5 - 0.5 * p.y) * height};
      if (!best || (label.right ? at.x > best.x : at.x < best.x)) best = at;
    }
    return best && best.x > 0 && best.x < width && best.y > 0 && best.y < height ? best : null;
  }

  put(label, at, taken, width, height) {
    const size = label.words.getBoundingClientRect(), edge = 12;
    const gap = Math.min(90, 0.09 * width);
    const x = label.right ? Math.min(at.x + gap, width - size.width - edge) : Math.max(at.x - gap - size.width, edge);
    let y = Math.min(Math.max(at.y - 24, 24), height - 24);
    for (const other of taken) if (Math.abs(other - y) < 28) y = other + 30;
    taken.push(y);
    label.words.style.left = `${x}px`;
    label.words.style.top = `${y}px`;
    for (const [key, value] of [['x1', at.x], ['y1', at.y], ['x2', label.right ? x : x + size.width], ['y2', y]]) label.line.setAttribute(key, value.toFixed(1));
    label.dot.setAttribute('cx', at.x.toFixed(1));
    label.dot.setAttribute('cy', at.y.toFixed(1));
  }
}
