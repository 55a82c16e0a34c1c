// What the page shows, in words: of its address (#view=buccal&section=mesial,1.5&hide=enamel), and for the page around it. docs/web.md lists them.
//
//   view     one of the views' names
//   section  buccal, mesial or occlusal, with - before it for the other side, and behind a comma where, in mm from the middle; "off"
//   hide     structures, with commas between; "" for none
//   faces    cull, show or tint
//   method   a model's name: DT, DB
//   bare     "on", or without a value: the picture alone, without controls
// A word that makes no sense is left out.
import {asked, tell} from './address.js';
import {listenFor, report} from './events.js';
import {views} from './camera.js';
import {sides} from './section.js';

const words = ['view', 'section', 'hide', 'faces', 'method', 'bare'];
const rest = 300;   // ms: a slider tells where it ends, not all its way

function sectionIn(text) {
  if (text === 'off') return {on: false};
  const [, minus, name, , at] = /^(-?)(\w+)(,(-?\d+(\.\d+)?))?$/.exec(text) ?? [];
  if (!sides.some(side => side.name === name)) return null;
  return {on: true, side: name, reversed: minus === '-', at: at === undefined ? 0 : Number(at)};
}

export class Showing {
  constructor(viewer) {
    this.viewer = viewer;
    this.timer = 0;
    this.apply(this.wanted());
    this.told = JSON.stringify(this.state());
    viewer.addEventListener('change', () => this.later());
    addEventListener('hashchange', () => this.apply(this.wanted()));
    listenFor('show', data => { if (data.state && typeof data.state === 'object') this.apply(data.state); });
  }

  wanted() {
    const said = asked().words;
    return Object.fromEntries(words.filter(word => said.has(word)).map(word => [word, said.get(word)]));
  }

  apply({view, section, hide, faces, method, bare}) {
    const {viewer} = this;
    const model = viewer.models.findIndex(one => one.name === method);
    if (model >= 0) viewer.show(model);
    if (typeof hide === 'string') {
      const hidden = hide.split(',');
      for (const key of viewer.looks.keys()) viewer.setLook(key, {visible: !hidden.includes(key)});
    }
    if (['cull', 'show', 'tint'].includes(faces)) viewer.setFaces(faces);
    const cut = typeof section === 'string' ? sectionIn(section) : null;
    if (cut) viewer.cut(cut);
    if (views.some(one => one.name === view)) viewer.look(view);
    if (bare !== undefined) document.body.classList.toggle('bare', bare !== 'off');
  }

  /// Without the view: who turns the model is at none that has a name.
  state() {
    const {viewer} = this, {section} = viewer;
    const hidden = [...viewer.looks].filter(([, look]) => !look.visible).map(([key]) => key);
    return {
      section: !section.on ? 'off' : section.free ? 'free' : `${section.reversed ? '-' : ''}${section.side.name},${Number(section.at.toFixed(2))}`,
      hide: hidden.join(','),
      faces: viewer.faces,
      method: viewer.model.name,
    };
  }

  later() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.say(), rest);
  }

  /// What changed goes into the address, so that a link shows it, and to the page around.
  say() {
    const state = this.state(), text = JSON.stringify(state);
    if (text === this.told || this.viewer.led || this.viewer.inside) return;
    this.told = text;
    tell({section: state.section === 'off' || state.section === 'free' ? null : state.section, hide: state.hide || null, faces: state.faces === 'cull' ? null : state.faces,
      method: this.viewer.models.length > 1 && this.viewer.chosen > 0 ? state.method : null}, ['view', 'section', 'hide', 'faces', 'method']);
    report('state', {state});
  }
}
