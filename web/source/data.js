// The model that the page carries: what is said of it, and its surfaces.
import {Box3, Vector3} from 'three';
import {language, t} from './language.js';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

const millimetres = 1000;   // a metre, which is glTF's unit

export function description() {
  return JSON.parse(document.getElementById('description').textContent);
}

/// The tour file that the page carries, as the program checked it; null: none.
export function lessonOf() {
  const held = document.getElementById('tour');
  if (!held) return null;
  const file = JSON.parse(held.textContent);
  if (held.hasAttribute('data-built-in')) return translated(file, t, language.language);
  const first = tag => tag.toLowerCase().split('-')[0], mine = language.language;
  const own = first(file.language ?? 'en') === first(mine) ? null : file.translations?.find(one => first(one.language) === first(mine)), texts = new Map(own?.texts);
  return own ? translated(file, text => texts.get(text) ?? text, own.language) : file;
}

/// A lesson in the reader's language. What its answers are compared with stays.
function translated(file, say, tongue) {
  const words = text => text ? say(text) : text, questionOf = question => question && {...question, ask: words(question.ask), explain: words(question.explain), unit: words(question.unit), ...(question.choices && {choices: question.choices.map(words)})};
  const notes = file.notes.map(note => ({...note, title: words(note.title), text: words(note.text), narration: words(note.narration), marks: note.marks?.map(mark => ({...mark, label: words(mark.label)})), arrows: note.arrows?.map(arrow => ({...arrow, label: words(arrow.label)})), question: questionOf(note.question)}));
  return {...file, title: words(file.title), language: tongue, notes};
}

async function unpacked(element) {
  const text = element.textContent.trim();
  const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  element.remove();   // its text is not needed twice
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/// The values of the page's volume, in bytes: x runs fastest, then y, then z.
export async function volumeValues({element, size}) {
  const values = new Uint8Array(await unpacked(document.getElementById(element)));
  if (values.length !== size[0] * size[1] * size[2]) throw new Error(t('the volume has lost some of its values'));
  for (let i = 1; i < values.length; ++i) values[i] += values[i - 1];   // each was written as its difference from the one before
  return values;
}

/// The parts of one model: {structure, kind, key, geometry}, in the model's own millimetres with z along the tooth. `key` is the look's name.
export async function partsOf(model) {
  const gltf = await new GLTFLoader().parseAsync(await unpacked(document.getElementById(model.element)), '');
  const parts = [];
  gltf.scene.traverse(node => {
    if (!node.isMesh) return;
    const {structure, kind} = node.userData;
    const geometry = node.geometry.scale(millimetres, millimetres, millimetres);
    parts.push({structure, kind, key: kind === 'cavity' ? `${structure} cavity` : structure, geometry});
  });
  return parts;
}

/// The walls of what one can be inside of: cavities; in a model without any, the pulp's own surface, which is then seen turned inside out.
export function voidsOf(parts) {
  const cavities = parts.filter(part => part.kind === 'cavity');
  return cavities.length > 0 ? cavities : parts.filter(part => /pulp/i.test(part.structure));
}

export function boundsOf(parts) {
  const box = new Box3();
  for (const part of parts) {
    part.geometry.computeBoundingBox();
    box.union(part.geometry.boundingBox);
  }
  const centre = box.getCenter(new Vector3());
  let radius = 0;
  const p = new Vector3();
  for (const {geometry} of parts) {
    const positions = geometry.attributes.position;
    for (let i = 0; i < positions.count; ++i) radius = Math.max(radius, p.fromBufferAttribute(positions, i).distanceTo(centre));
  }
  return {box, centre, radius};
}

/// Several geometries as arrays for one TriangleTree.
export function trianglesOf(parts) {
  const positions = [], indices = [];
  for (const {geometry} of parts) {
    const first = positions.length / 3, p = geometry.attributes.position.array, index = geometry.index.array;
    for (let i = 0; i < p.length; ++i) positions.push(p[i]);
    for (let i = 0; i < index.length; ++i) indices.push(first + index[i]);
  }
  return {positions: Float32Array.from(positions), indices: Uint32Array.from(indices)};
}
