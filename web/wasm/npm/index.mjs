// The program odontoscope as a library: its subcommands on files in memory, with the options that its --help lists.
import {decoderOf, mayBeCompressed} from './decoder.mjs';
import makeModule from './odontoscope.mjs';

const folder = '/work', pageFile = '/odontoscope/page.html';

/// What the program refused or could not do. `message` names file, place, what is wrong and what to do, as on a terminal.
export class OdontoscopeError extends Error {
  constructor(message, {exitCode, said = [], complained = []}) {
    super(message);
    this.name = 'OdontoscopeError';
    this.exitCode = exitCode;
    this.causeId = /\[([a-z0-9-]+)\]/.exec(message)?.[1] ?? null;
    this.said = said;
    this.complained = complained;
  }
}

const isNode = typeof process !== 'undefined' && Boolean(process.versions?.node) && typeof importScripts === 'undefined';

/// A file that lies beside this one, or where a URL says.
async function beside(name) {
  const url = new URL(name, import.meta.url);
  if (isNode && url.protocol === 'file:') return (await import('node:fs/promises')).readFile(url);
  const answer = await fetch(url);
  if (!answer.ok) throw new OdontoscopeError(`${url}: cannot be read: the server said ${answer.status}. Serve the whole folder of the package.`, {exitCode: 4});
  return answer.arrayBuffer();
}

function checkedName(name) {
  const parts = String(name).split('/');
  if (parts.some(part => part === '' || part === '.' || part === '..') || name.includes('\0'))
    throw new OdontoscopeError(`${JSON.stringify(name)} is no name of a file here. Give one without "..", not beginning with "/".`, {exitCode: 2});
  return parts;
}

const compiled = async given => given instanceof WebAssembly.Module ? given : WebAssembly.compile(given);

const bytesOf = content => typeof content === 'string' ? new TextEncoder().encode(content) : content instanceof ArrayBuffer ? new Uint8Array(content) : content;

function putFiles(FS, files) {
  for (const [name, content] of Object.entries(files)) {
    const parts = checkedName(name);
    let at = folder;
    for (const part of parts.slice(0, -1)) {
      at += `/${part}`;
      if (!FS.analyzePath(at).exists) FS.mkdir(at);
    }
    FS.writeFile(`${at}/${parts.at(-1)}`, bytesOf(content));
  }
}

/// One command in an instance, and what it made: taken out of the folder.
function ran(instance, line, given) {
  instance.said = [];
  instance.complained = [];
  let exitCode;
  try {
    exitCode = instance.callMain([...line].map(String));
  } catch (error) {   // the machine's own end: its stack or memory is exhausted, or a bug
    exitCode = 70;
    instance.keptModel = null;
    instance.complained.push(error instanceof RangeError
      ? 'odontoscope: this input goes deeper than a browser lets a program go. The program on a machine of its own can do it.'
      : `odontoscope: the engine stopped: ${error.message ?? error}. If memory is short, make the input smaller: fewer slices, --simplify, --crop.`);
  }
  const files = exitCode <= 1 ? madeFiles(instance.FS, given) : {};
  for (const name of Object.keys(files)) instance.FS.unlink(`${folder}/${name}`);
  return {exitCode, said: instance.said, complained: instance.complained, files};
}

/// What lies in the folder that was not put there, or not as it lies there now.
function madeFiles(FS, given, at = folder, found = {}) {
  for (const name of FS.readdir(at)) {
    if (name === '.' || name === '..') continue;
    const path = `${at}/${name}`, known = path.slice(folder.length + 1);
    if (FS.isDir(FS.stat(path).mode)) madeFiles(FS, given, path, found);
    else if (!(known in given)) found[known] = FS.readFile(path).slice();
  }
  return found;
}

/// `input` and other plain names become words of a command line: gridSize: 3 is --grid-size 3, true a bare option, an array the option several times.
export function words(command, {input, output, ...options} = {}) {
  const line = [command];
  for (const one of [input ?? []].flat()) line.push(String(one));
  for (const one of [output ?? []].flat()) line.push('-o', String(one));
  for (const [key, value] of Object.entries(options)) {
    const option = `--${key.replace(/[A-Z]/g, letter => `-${letter.toLowerCase()}`)}`;
    for (const one of Array.isArray(value) && value.length > 0 && typeof value[0] !== 'number' ? value : [value]) {
      if (one === true) line.push(option);
      else if (one !== false && one !== null && one !== undefined) line.push(option, Array.isArray(one) ? one.join(',') : String(one));
    }
  }
  return line;
}

/// Threads share memory, which only a page that is isolated from others may do, and whoever waits for them waits in a worker or in Node.js.
async function threadsHere() {
  if (typeof SharedArrayBuffer === 'undefined' || typeof document !== 'undefined') return 1;
  if (isNode) return (await import('node:os')).cpus().length;
  return globalThis.crossOriginIsolated ? navigator.hardwareConcurrency ?? 1 : 1;
}

const mostThreads = 16;   // beyond, a tooth has too few slabs

const oneThread = async wasm => ({make: makeModule, module: await compiled(await (wasm ?? beside('odontoscope.wasm'))), threads: 1, settings: {}});

/// The engine whose script, worker and module lie in a folder: {make, module, threads, settings}.
async function manyThreads(folder, threads) {
  const url = name => new URL(name, folder), module = await compiled(await beside(url('odontoscope.wasm')));
  if (isNode) {
    const {createRequire} = await import('node:module'), {fileURLToPath} = await import('node:url');
    return {make: createRequire(import.meta.url)(fileURLToPath(url('odontoscope.js'))), module, threads, settings: {}};
  }
  const {default: make} = await import(url('odontoscope.mjs').href);
  return {make, module, threads, settings: {mainScriptUrlOrBlob: url('odontoscope.js').href, locateFile: name => url(name).href}};
}

/// Ends the threads that an instance has made besides the first. Nothing of theirs is given back to the instance's memory: some may be about to begin.
async function endThreads(instance) {
  const {PThread} = instance;
  if (!PThread) return;
  instance.threads = 1;
  instance._odontoscope_be_alone();
  const workers = new Set([...PThread.unusedWorkers, ...PThread.runningWorkers, ...Object.values(PThread.pthreads).map(thread => thread?.worker)]);
  await Promise.all([...workers].filter(Boolean).map(worker => {
    worker.onmessage = worker.onerror = () => {};
    return worker.terminate();
  }));
}

/// The compiled engine. Each call is a run of its own: nothing is kept from one to the next but what `save` of a page's result holds, and an error in one is none in another.
export class Engine {
  #engine;
  #page;
  #decoder;
  constructor(engine, page, decoder) {
    this.#engine = engine;
    this.#page = page;
    this.#decoder = decoder;
  }

  /// How many threads each run has.
  get threads() { return this.#engine.threads; }

  /// One run of the program with these words. Never throws for what the program says: `exitCode` tells.
  async run(line, {files = {}, onProgress} = {}) {
    const instance = await this.#instance(onProgress);
    let result;
    try {
      result = await this.#runIn(instance, line, files);
    } finally {
      await endThreads(instance);   // which would keep Node.js from its end
    }
    // A page's model lives on with the instance, for as long as somebody holds the result.
    result.save = instance.keptModel ? async ({onProgress: listener, ...options}) => {
      instance.onProgress = listener;
      return ran(instance, words('save', options), files);
    } : null;
    return result;
  }

  async #runIn(instance, line, files) {
    const {FS} = instance;
    FS.mkdir(folder);
    FS.mkdir('/odontoscope');
    putFiles(FS, files);
    if (Object.values(files).some(content => mayBeCompressed(bytesOf(content)))) instance.decoder = await decoderOf(await this.#decoder());
    if (line[0] === 'web') FS.writeFile(pageFile, bytesOf(await this.#page()));
    FS.chdir(folder);
    const threads = this.threads > 1 && !line.includes('--threads') ? ['--threads', this.threads] : [];
    return ran(instance, [...threads, ...line], files);
  }

  async #instance(onProgress) {
    const {make, module, threads, settings} = this.#engine;
    const instance = await make({
      ...settings,
      threads,
      noInitialRun: true,
      quit: (status, end) => { throw end; },   // else Node.js itself ends with the program's exit code
      thisProgram: 'odontoscope',
      print: text => instance.said.push(text),
      printErr: text => instance.complained.push(text),
      onProgress,
      instantiateWasm: (imports, receive) => {
        WebAssembly.instantiate(module, imports).then(made => receive(made, module));
        return {};
      },
    });
    return instance;
  }

  /// The same with an object of options; throws OdontoscopeError unless it went well. `wanting` is true where the program ended with 1.
  async command(name, {files, onProgress, ...options} = {}) {
    const result = await this.run(words(name, options), {files, onProgress});
    if (result.exitCode <= 1) return {...result, wanting: result.exitCode === 1};
    const message = result.complained.join('\n').replace(/^odontoscope: /gm, '') || `odontoscope ended with ${result.exitCode}`;
    throw new OdontoscopeError(message, result);
  }

  sample(kind, options) { return this.command('sample', {input: kind, ...options}); }
  contours(options) { return this.command('contours', options); }
  reconstruct(options) { return this.command('reconstruct', options); }
  check(options) { return this.command('check', options); }
  canal(options) { return this.command('canal', options); }
  anatomy(options) { return this.command('anatomy', options); }
  compare(options) { return this.command('compare', options); }
  web(options) { return this.command('web', options); }
}

/// Compiles the engine. Without arguments it reads odontoscope.wasm from beside this file, or what is in threads/ where there can be several, and what not every
/// run needs once it is: page.html for a page, decoder.wasm for DICOM.
export async function load({wasm, page, decoder, threads, threaded} = {}) {
  const many = Math.min(threads ?? (wasm && !threaded ? 1 : await threadsHere()), mostThreads);
  let held = page, decoding = null, engine = null;
  if (many > 1) {
    engine = await manyThreads(new URL(threaded ?? 'threads/', import.meta.url), many).catch(error => {
      if (threads !== undefined) throw error;
      return null;   // nobody insists
    });
  }
  return new Engine(engine ?? await oneThread(wasm), async () => held ??= await beside('page.html'),
    () => decoding ??= (async () => compiled(await (decoder ?? beside('decoder.wasm'))))());
}

let shared = null;
const engine = () => shared ??= load();
export const run = async (line, options) => (await engine()).run(line, options);
export const sample = async (kind, options) => (await engine()).sample(kind, options);
export const contours = async options => (await engine()).contours(options);
export const reconstruct = async options => (await engine()).reconstruct(options);
export const check = async options => (await engine()).check(options);
export const canal = async options => (await engine()).canal(options);
export const anatomy = async options => (await engine()).anatomy(options);
export const compare = async options => (await engine()).compare(options);
export const web = async options => (await engine()).web(options);
