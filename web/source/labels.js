// Names beside the tooth, each with a line to a place on its structure.
import {Vector3} from 'three';
import {element} from './dom.js';
import {named} from './language.js';
import {toldOf} from './told.js';

const most = 160;                                   // places of a structure among which one is chosen
const nearCut = 0.04;                               // of the model's height: what lies so near a cut is seen
const levels = [0.72, 0.3, 0.62, 0.5, 0.2, 0.85];   // how high each structure's label stands, in its own height
const drawing = 'http://www.w3.org/2000/svg';

export class Labels {
  constructor(parts, looks) {
    this.host = document.getElementById('labels');
    this.lines = document.createElementNS(drawing, 'svg');
    this.ring = document.createElementNS(drawing, 'circle');   // round a place that one was led to
    this.ring.setAttribute('r', 16);
    this.ring.setAttribute('class', 'ring');
    this.lines.append(this.ring);
    this.mark = null;
    this.host.append(this.lines);
    this.on = true;
    this.muted = false;   // while a question is open
    this.height = Math.max(...parts.map(part => part.geometry.boundingBox.max.z)) - Math.min(...parts.map(part => part.geometry.boundingBox.min.z));
    this.looks = looks;
    this.named = parts.filter(part => part.kind !== 'cavity' || looks.get(part.key).as_body).map((part, index) => this.labelOf(part, index));
  }

  labelOf(part, index) {
    const positions = part.geometry.attributes.position, box = part.geometry.boundingBox;
    const height = box.min.z + levels[index % levels.length] * (box.max.z - box.min.z), near = 0.12 * (box.max.z - box.min.z);
    const places = [], everywhere = [], p = new Vector3(), step = Math.max(1, Math.floor(positions.count / (24 * most)));
    for (let i = 0; i < positions.count; i += step) {
      everywhere.push(p.fromBufferAttribute(positions, i).clone());
      if (Math.abs(p.z - height) < near && places.length < most) places.push(p.clone());
    }
    if (places.length === 0) places.push(box.getCenter(new Vector3()));
    const words = element('span', {}, part.key.endsWith(' cavity') && this.looks.get(part.key).as_body ? named(`${part.structure} cavity`) : named(part.structure));
    const told = toldOf(part.key);   // for the mouse; the panel has the same for everybody
    if (told) {
      words.classList.add('asked');
      words.addEventListener('click', () => this.tell(this.told?.parentNode === words ? null : words, told));
    }
    const line = document.createElementNS(drawing, 'line'), dot = document.createElementNS(drawing, 'circle');
    dot.setAttribute('r', 3);
    this.lines.append(line, dot);
    this.host.append(words);
    return {part, places, everywhere, words, line, dot, right: index % 2 === 0};
  }

  /// At one label what its structure is; null: at none.
  tell(words, sentences) {
    this.told?.remove();
    this.told = words ? element('small', {}, sentences) : null;
    words?.append(this.told);
    this.changed?.();
  }

  place(camera, {hidden, plane, width, height, avoid = []}) {
    const placed = [], marked = this.mark && !hidden ? this.mark.clone().project(camera) : null;
    this.ring.style.display = marked && marked.z <= 1 ? '' : 'none';
    if (marked) {
      this.ring.setAttribute('cx', (marked.x + 1) / 2 * width);
      this.ring.setAttribute('cy', (1 - marked.y) / 2 * height);
    }
    for (const label of this.named) {
      const look = this.looks.get(label.part.key), shown = this.on && !this.muted && !hidden && look.visible && look.opacity > 0;
      const at = shown ? this.outermost(this.placesOf(label, plane), label.right, camera, width, height) : null;
      for (const piece of [label.words, label.line, label.dot]) piece.style.display = at ? '' : 'none';
      if (at) placed.push({label, at});
    }
    const taken = {true: [], false: []};
    for (const {label, at} of placed.sort((a, b) => a.at.y - b.at.y)) this.put(label, at, taken[label.right], width, height, avoid);   // lines do not cross
  }

  /// Where a cut shows the structure there; of others what is left and not hidden behind something opaque.
  placesOf(label, plane) {
    const {part} = label;
    if (plane) {
      const off = p => plane.x * p.x + plane.y * p.y + plane.z * p.z - plane.w, reach = nearCut * this.height;
      const near = label.everywhere.filter(p => off(p) < 0 && off(p) > -reach);
      return near.length > 0 ? near : label.places.filter(p => off(p) < 0);
    }
    const covered = this.named.some(other => {
      const look = this.looks.get(other.part.key);
      return other !== label && look.visible && look.opacity > 0.95 && look.depth < this.looks.get(part.key).depth && other.part.geometry.boundingBox.containsBox(part.geometry.boundingBox);
    });
    return covered ? [] : label.places;
  }

  outermost(places, right, camera, width, height) {
    let best = null;
    const p = new Vector3();
    for (const place of places) {
      p.copy(place).project(camera);
      if (p.z > 1) continue;
      const at = {x: (0.5 + 0.5 * p.x) * width, y: (0.5 - 0.5 * p.y) * height};
      if (!best || (right ? at.x > best.x : at.x < best.x)) best = at;
    }
    return best && best.x > 0 && best.x < width && best.y > 0 && best.y < height ? best : null;
  }

  put(label, at, taken, width, height, avoid) {
    const size = label.words.getBoundingClientRect(), edge = 12;
    const gap = Math.min(90, 0.09 * width);
    const x = label.right ? Math.min(at.x + gap, width - size.width - edge) : Math.max(at.x - gap - size.width, edge);
    let y = Math.min(Math.max(at.y - 24, 24), height - 24);
    for (const other of taken) if (Math.abs(other - y) < 28) y = other + 30;
    for (const box of [...avoid].sort((a, b) => a.top - b.top)) if (box.left < x + size.width + 4 && box.right > x - 4 && Math.abs(box.top - y) < 30) y = box.top + 32;
    taken.push(y);
    label.words.style.left = `${x}px`;
    label.words.style.top = `${y}px`;
    for (const [key, value] of [['x1', at.x], ['y1', at.y], ['x2', label.right ? x : x + size.width], ['y2', y]]) label.line.setAttribute(key, value.toFixed(1));
    label.dot.setAttribute('cx', at.x.toFixed(1));
    label.dot.setAttribute('cy', at.y.toFixed(1));
  }
}
