// Lengths on the film between two places of it that are clicked. A third click begins anew.
import {Vector2, Vector3} from 'three';
import {element} from './dom.js';
import {number, t} from './language.js';

const dragPixels = 6;   // a pointer that moves farther between down and up drags

/// Where the ray through a place of the picture (from the middle, in halves of it) meets a film through `centre`, square to where the camera looks.
export function placeOnFilm({x, y}, camera, centre) {
  const ahead = camera.getWorldDirection(new Vector3()), near = new Vector3(x, y, -1).unproject(camera);
  const way = new Vector3(x, y, 1).unproject(camera).sub(near);
  return near.clone().addScaledVector(way, centre.clone().sub(near).dot(ahead) / way.dot(ahead));
}

export class FilmRuler {
  constructor(viewer) {
    this.viewer = viewer;
    this.places = [];
    this.on = element('input', {type: 'checkbox', id: 'film-ruler', onchange: () => this.clear()});
    this.body = element('label', {class: 'switch'}, this.on, t('Measure on the film: click two places'));
    this.ahead = new Vector3();   // where the camera looked
    const {canvas} = viewer;
    let down = null;
    viewer.addEventListener('drawn', () => { if (this.places.length > 0 && this.hasTurned()) this.clear(); });
    canvas.addEventListener('pointerdown', event => { down = event.isPrimary && event.button === 0 ? new Vector2(event.clientX, event.clientY) : null; });
    canvas.addEventListener('pointerup', event => {
      if (!down || !this.on.checked || !viewer.film || down.distanceTo(new Vector2(event.clientX, event.clientY)) > dragPixels) return;
      const box = canvas.getBoundingClientRect();
      this.take({x: (event.clientX - box.left) / box.width * 2 - 1, y: 1 - (event.clientY - box.top) / box.height * 2});
    });
  }

  /// The length between the last two places, mm; null: there are none.
  get length() { return this.places.length === 2 ? this.places[0].distanceTo(this.places[1]) : null; }

  take(place) {
    const {viewer} = this;
    if (this.places.length === 2) this.places = [];
    viewer.camera.getWorldDirection(this.ahead);
    this.places.push(placeOnFilm(place, viewer.camera, viewer.bounds.centre));
    const words = this.length === null ? '' : t('{length} mm on the film', {length: number(this.length, 1)});
    viewer.pins.show(this.places.map((at, index) => ({at: at.toArray(), label: index === 1 ? words : ''})));
  }

  /// A film that hangs otherwise has other places.
  hasTurned() { return this.viewer.camera.getWorldDirection(new Vector3()).distanceTo(this.ahead) > 1e-6; }

  clear() {
    if (this.places.length > 0) this.viewer.pins.show([]);
    this.places = [];
  }
}
