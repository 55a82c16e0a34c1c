// What is on the picture while one is inside: the tour's slider, the way out, the thumb's ring, and a map that says where one is.
import {Vector3} from 'three';
import {element, slider} from './dom.js';
import {capital, named, number, t} from './language.js';

const along = 0.35;   // a cosine: less, and one looks at the wall

/// In flight: the canal one is in, how deep, and which way one looks. Nothing is said where the page knows no canals.
function whereInWords(viewer) {
  const {camera} = viewer.journey, near = viewer.tours.map(tour => ({tour, ...tour.nearest(camera.position)})).sort((a, b) => a.distance - b.distance)[0];
  if (!near) return [];
  const {tour, mm} = near, look = camera.getWorldDirection(new Vector3());
  if (tour.orifice !== null && mm < tour.orifice) {
    const down = new Vector3();   // to where the canals lead, all together
    for (const one of viewer.tours) down.add(one.place(one.length).sub(one.place(0)));
    const turn = look.dot(down.normalize());
    return [t('in the chamber'), turn > along ? t('looking to the roots') : turn < -along ? t('looking to the crown') : t('looking to the side')];
  }
  const turn = look.dot(tour.direction(mm)), deep = tour.orifice === null ? named(tour.name)
    : `${named(tour.name)}: ${t('{depth} mm below the orifice', {depth: number(mm - tour.orifice, 1)})}`;
  return [deep, turn > along ? t('looking to the tip') : turn < -along ? t('looking to the crown') : t('looking at the wall')];
}

export class InsideBar {
  constructor(viewer) {
    this.viewer = viewer;
    this.bar = document.getElementById('bar');
    this.map = document.getElementById('map');
    this.play = element('button', {type: 'button', class: 'main', onclick: () => this.togglePlay()});
    this.scrub = slider(t('Way along the canal, mm'), {low: 0, high: 1, step: 'any', value: 0}, mm => { viewer.play(false); viewer.seek(mm); });
    this.told = element('output', {});
    const fly = element('button', {type: 'button', title: t('From here'), onclick: () => viewer.startFlight()}, t('Fly'));
    this.fly = fly;
    this.bar.append(this.told, this.play, this.scrub, fly, element('button', {type: 'button', onclick: () => viewer.leave()}, t('Leave')));
    this.mode = null;
    viewer.addEventListener('enter', () => { this.cameFrom = document.activeElement; this.drawMap(); });
    viewer.addEventListener('change', () => this.show());
    viewer.addEventListener('travel', () => this.show());
    this.thumb();
    this.dragToLook();
  }

  togglePlay() {
    const {journey} = this.viewer;
    if (!journey.playing && journey.mm >= journey.tour.length) this.viewer.seek(0);
    this.viewer.play(!journey.playing);
  }

  show() {
    const {viewer} = this, {journey} = viewer, touch = matchMedia('(pointer: coarse)').matches, tour = journey.mode === 'tour';
    this.bar.hidden = this.map.hidden = !viewer.inside || viewer.headset.present;
    document.getElementById('pad').hidden = journey.mode !== 'fly' || !touch;
    document.getElementById('scale').hidden = viewer.inside;
    const told = tour ? '' : journey.mode === 'fly' ? touch ? t('The ring moves, dragging turns') : t('W A S D to fly, drag to turn, Esc to leave') : '';
    // One flies where DT's walls are, whatever is shown: DB's have holes.
    const whose = viewer.inside && viewer.chosen !== 0 ? `. ${t('Shown is {shown}; the walls that hold are those of {held}', {shown: viewer.model.name, held: viewer.models[0].name})}` : '';
    document.getElementById('notice').textContent = (told + whose).replace(/^\. /, '');
    this.moveFocus();
    if (!viewer.inside || viewer.headset.present) return;
    this.play.hidden = this.scrub.hidden = this.fly.hidden = !tour;
    this.play.textContent = journey.playing ? t('Pause') : t('Play');
    const width = t('{width} mm wide', {width: number(2 * journey.room(), 2)});
    if (tour) {
      this.scrub.max = journey.tour.length;
      this.scrub.value = journey.mm;
      this.told.textContent = capital(`${named(journey.tour.name)}: ${journey.tour.placeInWords(journey.mm)}, ${width}`);
      this.scrub.setAttribute('aria-valuetext', this.told.textContent);
    } else this.told.textContent = capital([...whereInWords(viewer), width].join(', '));
    this.markMap();
  }

  /// To what drives the tour or the flight, and afterwards back to where it was.
  moveFocus() {
    const {journey, canvas} = this.viewer;
    if (journey.mode === this.mode) return;
    this.mode = journey.mode;
    this.play.hidden = this.mode !== 'tour';
    if (this.viewer.led) return;
    ({tour: this.play, fly: canvas}[this.mode] ?? this.cameFrom)?.focus({preventScroll: true});
  }

  /// The tooth as it is seen from outside, once; then only a dot moves on it.
  drawMap() {
    const {viewer} = this, {camera} = viewer.orbit, view = {towards: [-0.25, 1, 0.12], up: [0, 0, 1]};
    const kept = {position: camera.position.clone(), target: viewer.orbit.controls.target.clone(), aspect: camera.aspect, view: viewer.orbit.view, labels: viewer.labels.on};
    viewer.labels.on = false;
    viewer.orbit.resize(viewer.canvas.width / viewer.canvas.height);
    viewer.orbit.goTo(view, true);
    viewer.orbit.update(0);
    viewer.draw({way: viewer.quality.moving});   // it is small
    camera.updateMatrixWorld();
    this.seen = camera.clone();
    const {width, height} = this.map, scale = height / viewer.canvas.height;
    this.picture = document.createElement('canvas');
    Object.assign(this.picture, {width, height});
    const context = this.picture.getContext('2d');
    context.drawImage(viewer.canvas, 0, 0, 2, viewer.canvas.height, 0, 0, width, height);   // the background, where the picture is too narrow
    context.drawImage(viewer.canvas, (width - viewer.canvas.width * scale) / 2, 0, viewer.canvas.width * scale, height);
    this.toMap = p => [width / 2 + 0.5 * p.x * viewer.canvas.width * scale, (0.5 - 0.5 * p.y) * height];
    camera.position.copy(kept.position);
    viewer.orbit.controls.target.copy(kept.target);
    viewer.orbit.view = kept.view;
    viewer.orbit.resize(kept.aspect);
    viewer.orbit.controls.update();
    viewer.labels.on = kept.labels;
  }

  markMap() {
    const context = this.map.getContext('2d');
    context.drawImage(this.picture, 0, 0);
    const [x, y] = this.toMap(this.viewer.camera.position.clone().project(this.seen));
    const [ax, ay] = this.toMap(this.viewer.camera.getWorldDirection(new Vector3()).multiplyScalar(0.12 * this.viewer.bounds.radius).add(this.viewer.camera.position).project(this.seen));
    context.lineWidth = 4;
    context.strokeStyle = context.fillStyle = '#ffd23f';
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(ax, ay);
    context.stroke();
    context.beginPath();
    context.arc(x, y, 8, 0, 2 * Math.PI);
    context.fill();
    context.lineWidth = 2;
    context.strokeStyle = '#1b1e22';
    context.stroke();
  }

  thumb() {
    const pad = document.getElementById('pad'), knob = document.getElementById('knob'), {speed} = this.viewer.journey;
    const put = (x, y) => {
      const far = Math.max(1, Math.hypot(x, y));
      [speed.side, speed.forward] = [x / far, -y / far];
      knob.style.transform = `translate(${2.2 * x / far}rem,${2.2 * y / far}rem)`;
    };
    pad.addEventListener('pointerdown', event => pad.setPointerCapture(event.pointerId));
    pad.addEventListener('pointermove', event => {
      if (!pad.hasPointerCapture(event.pointerId)) return;
      const box = pad.getBoundingClientRect();
      put((event.clientX - box.left) / box.width * 2 - 1, (event.clientY - box.top) / box.height * 2 - 1);
    });
    for (const end of ['pointerup', 'pointercancel']) pad.addEventListener(end, () => put(0, 0));
  }

  dragToLook() {
    const {canvas, journey} = this.viewer, radiansPerPixel = 0.005;
    let last = null;
    canvas.addEventListener('pointerdown', event => { last = journey.mode === 'fly' ? event : null; });
    canvas.addEventListener('pointermove', event => {
      if (!last || journey.mode !== 'fly' || event.pointerId !== last.pointerId) return;
      journey.turnBy(radiansPerPixel * (last.clientX - event.clientX), radiansPerPixel * (event.clientY - last.clientY));
      last = event;
      this.viewer.touch();
      this.show();
    });
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { last = null; });
  }
}
