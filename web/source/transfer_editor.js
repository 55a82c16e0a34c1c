// A transfer function over the histogram of its volume, to be edited: points are dragged, a click beside them makes one, the right button takes one away. As in the viewer
// (engine/ui/transfer_editor.h).
import {element} from './dom.js';
import {t} from './language.js';
import {told} from './slider_row.js';
import {transferred, understood} from './transfer.js';

const highestShown = 60;   // 1/mm: extinctions stand at their logarithms, so that hardly any and that of a wall are told apart
const shareOf = extinction => Math.min(Math.log1p(extinction) / Math.log1p(highestShown), 1);
const extinctionAt = share => Math.expm1(Math.min(Math.max(share, 0), 1) * Math.log1p(highestShown));
const near = 11, mostPoints = 64;   // pixels on the screen

const byte = light => Math.round(255 * Math.min(Math.max(light, 0), 1) ** (1 / 2.2));

export class TransferEditor {
  /// `change(points)` is told each new transfer function.
  constructor(volume, change) {
    Object.assign(this, {volume, change, chosen: 0, dragged: false});
    const {low, high} = volume.told;
    this.canvas = element('canvas', {
      width: 520, height: 168, class: 'histogram', role: 'img', 'aria-label': t('How often grey values occur, the colours that they are shown in, and the points of the transfer function'),
      onpointerdown: event => this.press(event), onpointermove: event => this.drag(event), onpointerup: () => { this.dragged = false; }, onpointercancel: () => { this.dragged = false; },
      oncontextmenu: event => event.preventDefault(),
    });
    this.colour = element('input', {type: 'color', 'aria-label': t('The colour of the point'), oninput: event => this.set({colour: event.target.value})});
    this.which = element('span', {class: 'grow quiet'});
    const button = (words, onclick) => element('button', {type: 'button', onclick}, words);
    this.value = told(t('Value of the point'), {low, high, step: (high - low) / 255, value: low}, value => this.set({value}));
    this.extinction = told(t('Its extinction'), {low: 0, high: 100, step: 1, value: 0}, percent => this.set({extinction: extinctionAt(percent / 100)}), percent => `${Math.round(percent)} %`);
    this.controls = element('div', {}, element('div', {class: 'row'}, this.colour, this.which, button(t('Next point'), () => this.next()), button(t('Remove point'), () => this.remove(this.chosen))), this.value, this.extinction,
      element('p', {class: 'quiet'}, t('Drag points; a click makes one, the right button takes one away.')));
    this.body = element('div', {}, this.canvas, this.controls);
  }

  get points() { return this.volume.look.transfer; }
  get editable() { return this.volume.look.cast === 'shaded' && this.points.length >= 2; }
  x(value) { const {low, high} = this.volume.told; return Math.min(Math.max((value - low) / (high - low), 0), 1); }

  /// Parts of the canvas from the left and from below.
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return {right: (event.clientX - box.left) / box.width, up: 1 - (event.clientY - box.top) / box.height, width: box.width, height: box.height};
  }
  pointAt({right, up, width, height}) {
    let best = near, nearest = -1;
    this.points.forEach(({value, extinction}, index) => {
      const away = Math.hypot((this.x(value) - right) * width, (shareOf(extinction) - up) * height);
      if (away < best) [best, nearest] = [away, index];
    });
    return nearest;
  }
  valueAt(right) { const {low, high} = this.volume.told; return low + (high - low) * Math.min(Math.max(right, 0), 1); }

  press(event) {
    if (!this.editable) return;
    const place = this.placeOf(event), hit = this.pointAt(place);
    if (event.button === 2) return hit >= 0 && this.remove(hit);
    if (event.button !== 0) return;
    this.dragged = true;
    this.canvas.setPointerCapture?.(event.pointerId);
    if (hit >= 0) {
      this.chosen = hit;
      return this.show();
    }
    const value = this.valueAt(place.right), {points} = this;
    if (points.length >= mostPoints || points.some(point => point.value === value)) return;
    const above = points.findIndex(point => point.value > value), at = above < 0 ? points.length : above;
    this.chosen = at;
    this.change([...points.slice(0, at), {value, colour: points[Math.max(at - 1, 0)].colour, extinction: extinctionAt(place.up)}, ...points.slice(at)]);
  }
  drag(event) {
    if (!this.dragged || !this.editable) return;
    const place = this.placeOf(event);
    this.set({value: this.valueAt(place.right), extinction: extinctionAt(place.up)});
  }
  next() { this.chosen = (this.chosen + 1) % this.points.length; this.show(); }
  remove(index) {
    if (this.points.length <= 2) return;
    this.chosen = Math.min(this.chosen, this.points.length - 2);
    this.change(this.points.filter((_, i) => i !== index));
  }
  /// As far as its neighbours let it.
  set(changes) {
    const {points, chosen} = this, {low, high} = this.volume.told, gap = 1e-3 * (high - low), point = {...points[chosen], ...changes};
    const least = chosen > 0 ? points[chosen - 1].value + gap : low, most = chosen + 1 < points.length ? points[chosen + 1].value - gap : high;
    point.value = least <= most ? Math.min(Math.max(point.value, least), most) : points[chosen].value;
    this.change(points.map((each, index) => (index === chosen ? point : each)));
  }

  show() {
    this.draw();
    this.controls.hidden = !this.editable;
    if (!this.editable) return;
    this.chosen = Math.min(this.chosen, this.points.length - 1);
    const {value, colour, extinction} = this.points[this.chosen];
    this.colour.value = colour;
    this.which.textContent = t('Point {number} of {count}', {number: this.chosen + 1, count: this.points.length});
    this.value.show(value);
    this.extinction.show(100 * shareOf(extinction));
  }

  draw() {
    const {volume: {told: {bars, low, high, isos}, look}, canvas} = this, {width, height} = canvas, context = canvas.getContext('2d'), points = understood(look.transfer);
    const style = getComputedStyle(document.documentElement), ink = (name, other) => style.getPropertyValue(name).trim() || other;
    context.clearRect(0, 0, width, height);
    bars.forEach((bar, index) => {
      const left = index * width / bars.length, [r, g, b, extinction] = transferred(points, low + (high - low) * (index + 0.5) / bars.length);
      context.fillStyle = ink('--quiet', '#888');
      context.fillRect(left, height * (1 - 0.94 * bar), width / bars.length - 1, height);
      if (look.cast !== 'shaded') return;
      context.fillStyle = `rgb(${byte(r)} ${byte(g)} ${byte(b)} / 0.7)`;
      context.fillRect(left, height * (1 - shareOf(extinction)), width / bars.length, height);
    });
    context.fillStyle = ink('--accent', '#2ab');
    for (const {value: iso} of isos) context.fillRect(width * (iso - low) / (high - low) - 1.5, 0, 3, height);
    if (!this.editable) return;
    const place = ({value, extinction}) => [width * this.x(value), height * (1 - shareOf(extinction))];
    context.strokeStyle = ink('--text', '#111');
    context.lineWidth = 2;
    context.beginPath();
    this.points.forEach((point, index) => context[index === 0 ? 'moveTo' : 'lineTo'](...place(point)));
    context.stroke();
    this.points.forEach((point, index) => {
      context.beginPath();
      context.arc(...place(point), index === this.chosen ? 9 : 7, 0, 2 * Math.PI);
      context.fillStyle = point.colour;
      context.fill();
      context.strokeStyle = index === this.chosen ? ink('--accent', '#2ab') : ink('--text', '#111');
      context.lineWidth = index === this.chosen ? 4 : 2;
      context.stroke();
    });
  }
}
