// Questions made from what the page carries: structures, canals, horns. No answer is guessed: what the model does not know is not asked.
import {Vector3} from 'three';
import {views} from './camera.js';
import {named, number, plainNumber, t} from './language.js';

const mostQuestions = 8;
const clearLooks = {enamel: 0.15, dentine: 0.22, other: 0.25};
const withinShare = 0.12, leastWithin = 1;   // mm: how near a guessed length must come
const placesTried = 400;

/// Names that say which canal it is, not "canal 2".
const spoken = ways => ways.filter(({name}) => !/^(canal|horn|branch) \d+$/i.test(name));

/// `dice`: see chance.js. Notes as a lesson has them, each with a question.
export function questionsOn(viewer, dice) {
  const made = [...structuresPinned(viewer, dice), ...structuresClicked(viewer, dice), ...canalsPinned(viewer, dice), ...canalsClicked(viewer, dice), ...counted(viewer), ...lengths(viewer, dice), ...depths(viewer, dice)];
  return dice.shuffled(made).slice(0, mostQuestions);
}

const solids = viewer => [...new Set(viewer.models[0].parts.filter(part => part.kind !== 'cavity').map(part => part.structure))];

/// Outer tissues clear enough for the pulp and its canals to be seen.
function clearScene(viewer) {
  const structures = [...viewer.looks.values()].filter(look => !/pulp/i.test(look.structure) && !look.as_body)
    .map(({structure}) => ({name: structure, visible: true, opacity: clearLooks[structure.split(' ')[0]] ?? clearLooks.other}));
  return {structures};
}
/// Nothing is seen through.
const solidScene = viewer => ({structures: [...viewer.looks.values()].map(({structure}) => ({name: structure, visible: true, opacity: 1}))});

function noteOf(dice, ask, {scene, marks = [], view, question}) {
  return {title: ask, text: '', view: view ?? dice.one(['three-quarter', 'buccal', 'lingual']), scene, marks, question: {ask, ...question}};
}

/// A place on the structure that is seen, and where nothing lies before it, from a named view; null: there is none.
function placeSeen(viewer, structure, view, dice) {
  const parts = viewer.models[0].parts.filter(part => part.kind !== 'cavity' && part.structure === structure), p = new Vector3(), n = new Vector3();
  const others = viewer.models[0].parts.filter(part => part.kind !== 'cavity' && part.structure !== structure);
  const towards = new Vector3(...views.find(v => v.name === view).towards).normalize();
  for (let i = 0; i < placesTried; ++i) {
    const {attributes: {position, normal}} = dice.one(parts).geometry, v = dice.below(position.count);
    p.fromBufferAttribute(position, v);
    n.fromBufferAttribute(normal, v);
    if (n.dot(towards) < 0.6) continue;
    // Not where another structure lies close by, which the pin could be taken for.
    const near = 0.06 * viewer.bounds.radius;
    if (!others.some(({geometry}) => anyWithin(geometry, p, near))) return p.toArray();
  }
  return null;
}

function anyWithin(geometry, p, near) {
  const at = geometry.attributes.position.array;
  for (let i = 0; i < at.length; i += 3) if (Math.abs(at[i] - p.x) < near && Math.abs(at[i + 1] - p.y) < near && Math.abs(at[i + 2] - p.z) < near) return true;
  return false;
}

function structuresPinned(viewer, dice) {
  const all = solids(viewer);
  if (all.length < 2 || all.length > 8) return [];
  return dice.shuffled(all).slice(0, 2).flatMap(structure => {
    const view = dice.one(['buccal', 'lingual', 'mesial', 'distal']), at = placeSeen(viewer, structure, view, dice);
    if (!at) return [];
    const inner = /pulp/i.test(structure), choices = dice.shuffled(all);
    return [noteOf(dice, t('Which structure does the pin stand on?'), {view, scene: inner ? clearScene(viewer) : solidScene(viewer), marks: [{at, label: ''}],
      question: {kind: 'choice', choices: choices.map(named), answer: choices.indexOf(structure), explain: t('The pin stands on the {structure}.', {structure: named(structure)})}})];
  });
}

function structuresClicked(viewer, dice) {
  const all = solids(viewer);
  if (all.length < 2) return [];
  const structure = dice.one(all);
  return [noteOf(dice, t('Click the {name}.', {name: named(structure)}), {scene: clearScene(viewer), question: {kind: 'click', structure, explain: ''}})];
}

/// On a canal's way, well below its orifice.
const placeOn = (tour, share) => tour.place(tour.orifice + share * (tour.length - tour.orifice)).toArray();
const withOrifice = viewer => viewer.tours.filter(tour => tour.orifice !== null);

function canalsPinned(viewer, dice) {
  const canals = spoken(withOrifice(viewer));
  if (canals.length < 2 || canals.length !== withOrifice(viewer).length) return [];
  return dice.shuffled(canals).slice(0, 2).map(tour => {
    const choices = dice.shuffled(canals.map(({name}) => name));
    return noteOf(dice, t('Which canal is this?'), {scene: clearScene(viewer), marks: [{at: placeOn(tour, 0.5 + 0.35 * dice.next()), label: ''}],
      question: {kind: 'choice', choices: choices.map(named), answer: choices.indexOf(tour.name), explain: t('It is the {canal}.', {canal: named(tour.name)})}});
  });
}

function canalsClicked(viewer, dice) {
  const canals = spoken(withOrifice(viewer)), pulp = solids(viewer).find(name => /pulp/i.test(name));
  if (canals.length < 2 || !pulp) return [];
  const tour = dice.one(canals);
  return [noteOf(dice, t('Click the {name}.', {name: named(tour.name)}), {scene: clearScene(viewer), question: {kind: 'click', structure: pulp, part: tour.name, explain: ''}})];
}

function counted(viewer) {
  const {length} = viewer.tours;
  if (length === 0) return [];
  const names = spoken(viewer.tours), told = names.length === length && length > 1 ? `: ${names.map(({name}) => named(name)).join(', ')}` : '';
  const ask = t('How many canals does this pulp have?'), count = length === 1 ? t('One canal') : t('{count} canals', {count: length});
  return [{title: ask, text: t('Turn the tooth and follow each canal to its end.'), view: 'three-quarter', scene: clearScene(viewer), marks: [],
    question: {kind: 'number', ask, answer: length, within: 0, unit: '', explain: `${count}${told}.`}}];
}

function lengths(viewer, dice) {
  const canals = withOrifice(viewer).filter(({canalLength}) => canalLength > 0);
  if (canals.length === 0) return [];
  const tour = dice.one(canals), answer = Number(tour.canalLength.toFixed(1)), within = Number(Math.max(leastWithin, withinShare * answer).toFixed(1));
  const ask = t('How long is the canal between both pins, in mm? The bar in the picture helps.');
  return [noteOf(dice, ask, {view: 'buccal', scene: clearScene(viewer), marks: [{at: placeOn(tour, 0), label: t('orifice')}, {at: placeOn(tour, 1), label: t('end')}],
    question: {kind: 'number', answer, within, unit: 'mm', explain: t('Along its middle, from the orifice to the end: {length} mm ({canal}).', {length: number(answer, 1), canal: named(tour.name)})}})];
}

function depths(viewer, dice) {
  const canals = withOrifice(viewer).filter(({canalLength}) => canalLength > 3);
  if (canals.length === 0) return [];
  const tour = dice.one(canals), mm = Number((1.5 + dice.next() * (tour.canalLength - 3)).toFixed(1));
  const ask = t('How far below the orifice does the pin stand, in mm?');
  return [noteOf(dice, ask, {view: 'buccal', scene: clearScene(viewer), marks: [{at: placeOn(tour, 0), label: t('orifice')}, {at: tour.place(tour.orifice + mm).toArray(), label: ''}],
    question: {kind: 'number', answer: mm, within: 1.5, unit: 'mm', explain: t('Along the middle of the {canal} it is {length} mm.', {canal: named(tour.name), length: plainNumber(mm)})}})];
}
