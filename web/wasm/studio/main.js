// The page begins here: files in, the engine's words and models out.
import {element} from '../../source/dom.js';
import {Cancelled, Engine} from './engine.js';
import {explained} from './errors.js';
import {chosen, contentsOf, dropped, mainOf} from './files.js';

const at = id => document.getElementById(id);
const engine = new Engine();
const form = at('options'), iframe = at('viewer');
/// What is to be made a model of: {files, input, title}; null: nothing yet.
let given = null;

const surfaces = ['.glb', '.gltf', '.stl', '.3mf', '.ply', '.obj', '.wrl', '.x3d', '.vtp'], solids = ['.vtu', '.msh', '.inp'];

/// As a shell would part it, quotes and all but variables.
function parted(text) {
  return [...text.matchAll(/"([^"]*)"|'([^']*)'|(\S+)/g)].map(([, double, single, bare]) => double ?? single ?? bare);
}

/// Options that the model and every file of it are made with.
function chosenOptions() {
  const words = [], values = new FormData(form);
  for (const name of ['iso', 'label', 'min-area', 'triangles']) {
    const value = String(values.get(name) ?? '').trim();
    if (value) words.push(`--${name}`, value);
  }
  return [...words, ...parted(String(values.get('more') ?? ''))];
}

function say(failure) {
  at('failure').hidden = !failure;
  const told = failure ? explained(failure) : null;
  at('failure').replaceChildren(...(told ? [element('span', {lang: told.language}, `${told.sentences.join(' ')}\n`)] : []), failure ?? '');
}

function showWork(on) {
  at('working').hidden = !on;
  at('cancel').hidden = !on;
  at('make').disabled = on || !given;
  for (const button of document.querySelectorAll('.sample, #saves button')) button.disabled = on;
  if (on) {
    at('bar').removeAttribute('value');
    at('stage').textContent = 'The engine starts';
  }
}

const plain = lines => lines.map(line => line.replace(/^odontoscope: /, '')).filter(line => !/^See odontoscope /.test(line)).join('\n');

/// One run with progress shown, or null: it was cancelled or refused, and that is told.
async function work(words, files, save = null) {
  say(null);
  showWork(true);
  const listener = (stage, fraction) => {
    at('bar').value = fraction;
    at('stage').textContent = `${stage}: ${Math.round(100 * fraction)} %`;
  };
  try {
    const result = await (save ? engine.save(save, listener) : engine.run(words, files, listener));
    if (result.exitCode <= 1) return result;
    say(plain(result.complained) || `The engine ended with ${result.exitCode}.`);
  } catch (error) {
    say(error instanceof Cancelled ? 'Cancelled. Nothing was made.' : error.message);
  } finally {
    showWork(false);
  }
  return null;
}

function take(files, input) {
  given = {files, input, title: input.split('/').pop().replace(/\.[^.]*$/, '')};
  at('given').hidden = false;
  const count = Object.keys(files).length;
  at('given').textContent = count === 1 ? input : `${input} (${count} files)`;
  at('make').disabled = false;
  say(null);
}

async function takeFiles(pairs) {
  if (pairs.length === 0) return;
  try {
    const files = await contentsOf(pairs);
    take(files, mainOf(Object.keys(files)));
  } catch (error) {
    say(`These files cannot be read: ${error.message}. Are they still where they were?`);
    return;
  }
  const volume = /\.(nrrd|nhdr|nii|nii\.gz|mha|mhd|dcm)$/i.test(given.input) || Object.keys(given.files).length > 1;
  if (!volume || form.elements.iso.value || form.elements.label.value) await make();
  else say('If this is a volume, say below at which grey value its surface lies, or which label is the tooth. Then: Make the model.');
}

let shown = null;
function showPage(html) {
  if (shown) URL.revokeObjectURL(shown);
  shown = URL.createObjectURL(new Blob([html], {type: 'text/html'}));
  iframe.src = shown;
  iframe.hidden = false;
  at('empty').hidden = true;
}

const descriptionIn = html => JSON.parse(/<script type="application\/json" id="description">(.*?)<\/script>/s.exec(html)[1]);

async function make() {
  if (!given) return;
  const options = chosenOptions(), source = given;
  const made = await work(['web', source.input, '-o', 'odontoscope-page.html', '--title', source.title, ...(form.elements.db.checked ? ['--db'] : []), ...options], source.files);
  if (!made) return;
  const page = made.files['odontoscope-page.html'], html = new TextDecoder().decode(page), {models} = descriptionIn(html);
  const {verdict, headline} = models[0].certificate;
  at('result').hidden = false;
  at('verdict').textContent = headline;
  at('verdict').className = verdict;
  at('said').textContent = [...made.said.filter(line => !line.startsWith('Wrote ')), plain(made.complained)].filter(Boolean).join('\n');
  at('said').dataset.threads = engine.threads;
  showSaves(source, options, page, models[0].name === 'Mesh', made.canSave);
  showPage(html);
}

function save(name, bytes) {
  const url = URL.createObjectURL(new Blob([bytes]));
  element('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

function showSaves({files, input, title}, options, page, isMesh, isSaved) {
  const name = title.replace(/[^\w.-]+/g, '_').replace(/^[-.]+/, '') || 'model';
  const button = (words, run) => element('button', {type: 'button', onclick: run}, words);
  // A cancelled run takes the worker with it, and the model: then it is made again.
  const written = (words, again) => engine.holds && isSaved ? work(null, null, words) : work(['reconstruct', input, ...again, ...options], files);
  const made = (ending, kind = '', more = () => ({})) => button(ending, async () => {
    const file = `${name}-made${ending}`, extra = more();
    const result = await written({output: file, ...extra}, ['-o', file, ...Object.entries(extra).flatMap(([option, value]) => [`--${option}`, value])]);
    if (!result) return;
    save(`${name}${kind}${ending}`, result.files[file]);
    if (kind) at('said').textContent = result.said.join('\n');
  });
  const group = (words, buttons) => [element('h3', {}, words), element('p', {class: 'row'}, ...buttons)];
  const report = button('report', async () => {
    const result = await written({report: 'report-made.json'}, ['-o', 'unused.ply', '--report', 'report-made.json']);
    if (result) save(`${name}-report.json`, result.files['report-made.json']);
  });
  const comparison = button('both methods', async () => {
    const result = await work(['compare', input, '--html', 'comparison-made.html', ...options.filter((word, i) => word !== '--triangles' && options[i - 1] !== '--triangles')], files);
    if (!result) return;
    at('said').textContent = result.said.filter(line => !line.startsWith('Wrote ')).join('\n');
    save(`${name}-comparison.html`, result.files['comparison-made.html']);
  });
  const size = element('input', {inputMode: 'decimal', placeholder: 'quality', id: 'elements', autocomplete: 'off'});
  const elements = () => ({elements: size.value.trim() || 'quality'});
  at('saves').replaceChildren(
    ...(isMesh ? [] : group('Surfaces', surfaces.map(ending => made(ending)))),
    ...(isMesh ? [] : group('Tetrahedra', solids.map(ending => made(ending)))),
    ...(isMesh ? [] : group('Elements for simulation', [element('label', {}, 'Edges, mm ', size), ...solids.map(ending => made(ending, '-elements', elements))])),
    ...(isMesh ? [] : group('Certificate, counts, links', [report])),
    ...(isMesh ? [] : group('DT and DB compared', [comparison])),
    ...group('This view, for any browser', [button('page', () => save(`${name}.html`, page))]));
}

at('file').addEventListener('change', event => takeFiles(chosen(event.target.files)));
at('drop').addEventListener('click', () => at('file').click());
at('drop').addEventListener('keydown', event => { if (event.key === 'Enter' || event.key === ' ') at('file').click(); });
for (const kind of ['dragover', 'dragleave', 'drop'])
  document.addEventListener(kind, event => {
    event.preventDefault();
    at('drop').classList.toggle('over', kind === 'dragover');
    if (kind === 'drop') dropped(event.dataTransfer).then(takeFiles, error => say(error.message));
  });
for (const button of document.querySelectorAll('.sample'))
  button.addEventListener('click', async () => {
    const name = `${button.value}.json`, made = await work(['sample', button.value, '-o', name], {});
    if (!made) return;
    take(made.files, name);
    await make();
  });
form.addEventListener('submit', event => {
  event.preventDefault();
  make();
});
at('cancel').addEventListener('click', () => engine.cancel());
