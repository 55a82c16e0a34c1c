// A lesson on paper: a picture and the text of each step, its questions with room for answers, and the right answers on a page of their own. The browser
// prints it, or makes a PDF of it.
import {tell} from './address.js';
import {arrowIn, outlineOf} from './arrows.js';
import {element} from './dom.js';
import {t} from './language.js';
import {rightAnswer} from './marks.js';

export class Handout {
  /// `lesson`: the page's own file, or null; `closed`: called when the picture is free again.
  constructor(viewer, staging, lesson, closed) {
    Object.assign(this, {viewer, staging, lesson, closed});
    this.host = document.getElementById('handout');
    this.size = {width: 960, height: 640};   // of a picture, in pixels
    this.way = viewer.quality.still;
    // Paper has the handout, and not the page round it, however printing was begun.
    addEventListener('beforeprint', () => {
      this.only = this.lesson !== null && this.host.hidden;
      if (this.only) this.open(this.lesson);
    });
    addEventListener('afterprint', () => { if (this.only) this.close(); });
  }

  get isOpen() { return !this.host.hidden; }

  open(file) {
    this.cameFrom = document.activeElement;
    this.fill(file);
    this.host.hidden = false;
    this.covers(true);
    document.body.classList.add('reading');
    this.host.querySelector('h1').focus({preventScroll: true});
    this.host.scrollTop = 0;
  }

  close() {
    this.host.hidden = true;
    this.covers(false);
    document.body.classList.remove('reading');
    tell({});
    this.closed();
    this.cameFrom?.focus?.({preventScroll: true});
  }

  /// What lies under it is neither read nor reached.
  covers(on) { for (const id of ['stage', 'panel']) document.getElementById(id).inert = on; }

  fill(file) {
    const {size} = this;
    const asked = file.notes.filter(note => note.question), number = note => asked.indexOf(note) + 1;
    const pictures = this.pictures(file.notes);
    const steps = file.notes.map((note, index) => element('section', {class: 'sheet'}, element('h2', {}, `${index + 1}. ${note.title || note.question?.ask || ''}`),
      element('img', {src: pictures[index], alt: t('The picture of step {step}', {step: index + 1}), width: size.width, height: size.height}),
      ...[note.text, note.narration].flatMap(text => String(text ?? '').split(/\n+/)).filter(Boolean).map(line => element('p', {}, line)), note.question ? this.question(note.question, number(note)) : null));
    const answers = asked.length > 0 ? element('section', {class: 'answers-sheet'}, element('h2', {}, t('Answers')), element('ol', {}, ...asked.map(({question}) =>
      element('li', {}, `${rightAnswer(question)}. ${question.explain ?? ''}`)))) : null;
    this.host.replaceChildren(...[
      element('div', {class: 'row no-print'}, element('button', {type: 'button', class: 'main', onclick: () => print()}, t('Print, or save as PDF')), element('button', {type: 'button', onclick: () => this.close()}, t('Back to the lesson'))),
      element('h1', {tabindex: -1}, file.title), element('p', {class: 'quiet'}, `${t('Name')}: ____________________   ${t('Date')}: ____________`), ...steps, answers].filter(Boolean));
  }

  question({kind, ask, choices, unit}, number) {
    const room = kind === 'choice' ? element('ul', {class: 'boxes'}, ...choices.map(words => element('li', {}, words)))
      : element('p', {}, kind === 'click' ? t('Mark it in the picture.') : `____________ ${unit ?? ''}`);
    return element('div', {class: 'question'}, element('p', {}, element('strong', {}, `${t('Question {number}.', {number})} `), ask), room);
  }

  /// Each step's picture with its pins and names, on white.
  pictures(notes) {
    const {viewer, staging, size} = this, {picture, renderer, orbit} = viewer, still = orbit.still, ratio = renderer.getPixelRatio();
    const look = getComputedStyle(document.documentElement);
    renderer.setPixelRatio(1);
    renderer.setSize(size.width, size.height, false);
    picture.setBackground('#ffffff', '#ffffff');
    orbit.still = viewer.journey.still = {matches: true};   // nothing is on its way
    const urls = notes.map(note => {
      orbit.resize(size.width / size.height);
      viewer.journey.resize(size.width / size.height);
      staging.show(note);
      if (viewer.inside) viewer.journey.update(0); else orbit.update(0);
      viewer.draw({way: this.way, complete: this.way.layers});
      return this.painted(note);
    });
    orbit.still = viewer.journey.still = still;
    renderer.setPixelRatio(ratio);
    picture.setBackground(look.getPropertyValue('--sky-top').trim(), look.getPropertyValue('--sky-bottom').trim());
    viewer.resize();
    this.closed();
    return urls;
  }

  painted(note) {
    const {viewer, size} = this, canvas = Object.assign(document.createElement('canvas'), size), context = canvas.getContext('2d');
    context.drawImage(viewer.canvas, 0, 0, size.width, size.height);
    context.font = '600 22px system-ui, sans-serif';
    context.textBaseline = 'middle';
    for (const arrow of viewer.pins.arrows.arrows) this.paintArrow(context, arrow);
    for (const {at, words} of viewer.pins.pins) {
      const p = at.clone().project(viewer.camera), x = (p.x + 1) / 2 * size.width, y = (1 - p.y) / 2 * size.height;
      if (p.z > 1 || p.z < -1 || (viewer.inside && !viewer.inSight(at))) continue;
      const text = words.textContent, width = context.measureText(text).width, left = x + 40 + width > size.width ? x - 40 - width : x + 40;
      context.strokeStyle = context.fillStyle = '#111';
      context.lineWidth = 2;
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(left < x ? left + width : left, y - 30);
      context.stroke();
      context.fillStyle = '#f4bf4f';
      context.beginPath();
      context.arc(x, y, 8, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
      context.fillStyle = '#fffc';
      context.fillRect(left - 5, y - 44, width + 10, 28);
      context.fillStyle = '#111';
      context.fillText(text, left, y - 30);
    }
    return canvas.toDataURL('image/jpeg', 0.9);
  }

  paintArrow(context, arrow) {
    const {viewer, size} = this, at = arrowIn(viewer, viewer.camera, arrow, size.width, size.height);
    if (!at) return;
    context.strokeStyle = '#111';
    context.fillStyle = '#f4bf4f';
    context.lineWidth = 2;
    context.beginPath();
    for (const corner of outlineOf(at, {shaft: 3, half: 11, head: 24})) context.lineTo(...corner);
    context.closePath();
    context.fill();
    context.stroke();
    if (!arrow.label) return;
    const {width} = context.measureText(arrow.label), length = Math.max(Math.hypot(at.x1 - at.x2, at.y1 - at.y2), 1e-3), within = (wanted, high) => Math.min(Math.max(wanted, 8), high - 8);
    const left = within(at.x1 + (at.x1 - at.x2) / length * (width / 2 + 8) - width / 2, size.width - width), y = within(at.y1 + (at.y1 - at.y2) / length * 18, size.height - 18);
    context.fillStyle = '#fffc';
    context.fillRect(left - 5, y - 14, width + 10, 28);
    context.fillStyle = '#111';
    context.fillText(arrow.label, left, y);
  }
}
