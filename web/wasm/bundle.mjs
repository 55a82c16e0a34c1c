// Puts the studio's page and the npm package together.
//   node bundle.mjs WORK ENGINE DIST VERSION THREADS
// WORK holds node_modules and page.html (as web/build_page.cmake leaves them), ENGINE odontoscope.mjs, odontoscope.wasm and decoder.wasm; THREADS the engine for
// several threads, odontoscope.js, .worker.js and .wasm; DIST takes studio.html, isolated/ (the same for servers that isolate pages) and npm/.
import {createHash} from 'node:crypto';
import {cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

import {themeStyle} from '../theme.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const [work, engine, dist, version, threads] = process.argv.slice(2);
const {build, transform} = createRequire(join(work, 'package.json'))('esbuild');
const mostBytes = 4_000_000;   // of the studio's page

const shell = readFileSync(join(work, 'page.html'), 'utf8');
const packed = bytes => gzipSync(bytes, {level: 9}).toString('base64');
const hash = text => `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;

/// Beside what is a script for workers and for Node.js the same as a module, for whoever begins in a page.
function putThreads(to) {
  mkdirSync(to, {recursive: true});
  for (const file of ['odontoscope.js', 'odontoscope.worker.js', 'odontoscope.wasm']) cpSync(join(threads, file), join(to, file));
  writeFileSync(join(to, 'odontoscope.mjs'), `${readFileSync(join(threads, 'odontoscope.js'), 'utf8')}\nexport default makeOdontoscope;\n`);
  writeFileSync(join(to, 'package.json'), '{"type": "commonjs"}\n');
}

function makePackage() {
  const to = join(dist, 'npm');
  rmSync(to, {recursive: true, force: true});
  mkdirSync(to, {recursive: true});
  for (const file of ['index.mjs', 'decoder.mjs', 'index.d.ts', 'README.md']) cpSync(join(here, 'npm', file), join(to, file));
  for (const file of ['odontoscope.mjs', 'odontoscope.wasm', 'decoder.wasm']) cpSync(join(engine, file), join(to, file));
  cpSync(join(here, '../../LICENSE'), join(to, 'LICENSE'));
  putThreads(join(to, 'threads'));
  writeFileSync(join(to, 'page.html'), shell);
  const description = JSON.parse(readFileSync(join(here, 'npm/package.json'), 'utf8'));
  writeFileSync(join(to, 'package.json'), `${JSON.stringify({...description, version}, null, 2)}\n`);
}

/// By a language's tag and by cause: the rule, and what to do.
function wordsForErrors() {
  const folder = join(here, '../../assets/languages'), files = readdirSync(folder).filter(name => name.endsWith('.json')).sort().map(name => JSON.parse(readFileSync(join(folder, name), 'utf8')));
  return Object.fromEntries(files.map(({language, errors = []}) => [language, Object.fromEntries(errors.map(([cause, ...sentences]) => [cause, sentences]))]));
}

async function bundled(entry) {
  const made = await build({
    stdin: {contents: `import ${JSON.stringify(`./studio/${entry}`)};`, resolveDir: here},
    bundle: true, minify: true, write: false, format: 'iife', target: 'es2022', charset: 'ascii', legalComments: 'none', logLevel: 'error',
    external: ['node:*'], define: {'import.meta.url': '"about:blank"'},
    plugins: [{name: 'engine', setup: one => one.onResolve({filter: /\/odontoscope\.mjs$/}, () => ({path: join(engine, 'odontoscope.mjs')}))}, {name: 'errors', setup: one => {
      one.onResolve({filter: /^odontoscope:errors$/}, ({path}) => ({path, namespace: 'errors'}));
      one.onLoad({filter: /.*/, namespace: 'errors'}, () => ({contents: `export const errors = ${JSON.stringify(wordsForErrors())};`, loader: 'js'}));
    }}],
  });
  const text = made.outputFiles[0].text.trim();
  if (/<\/script|<!--/.test(text)) throw new Error(`${entry} would end its element`);
  return text;
}

async function makeStudio() {
  const script = await bundled('main.js'), worker = await bundled('worker.js');
  const style = (await transform(themeStyle + readFileSync(join(here, 'studio/style.css'), 'utf8'), {loader: 'css', minify: true})).code.trim();
  // The frame that shows a model inherits this policy beside its own: so its script and style are named here, too.
  const [, shellPolicy] = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(shell);
  const ofShell = name => new RegExp(`${name} ('sha256-[^']+')`).exec(shellPolicy)[1];
  const policyWith = (itself, connect) => [
    "default-src 'none'", `script-src ${hash(script)} ${ofShell('script-src')} 'wasm-unsafe-eval'${itself}`, `style-src ${hash(style)} ${ofShell('style-src')}`, `worker-src blob:${itself}`,
    ...connect, 'frame-src blob:', 'img-src data: blob:', "base-uri 'none'", "form-action 'none'",
  ].join('; ');
  const notices = '<!--\nThis page was written by Odontoscope (GPL-3.0-or-later). Its engine contains GMP (LGPL-3.0-or-later), TetGen (AGPL-3.0-or-later), CGAL (GPL-3.0-or-later and LGPL-3.0-or-later), meshoptimizer, pugixml, fmt,\n' +
    'nlohmann json, CLI11 and tinygltf (MIT, CLI11 BSD-3-Clause), libzip, GDCM, CharLS (BSD-3-Clause), OpenJPEG (BSD-2-Clause), zlib (zlib), Boost (BSL-1.0), and software of the Independent JPEG Group; the viewer in it three.js (MIT), whose licence is in each page.\n-->';
  const module = name => packed(readFileSync(join(engine, name)));
  const places = {style, notices, worker, script, wasm: module('odontoscope.wasm'), decoder: module('decoder.wasm'), shell: packed(shell)};
  const pageOf = more => readFileSync(join(here, 'studio/page.html'), 'utf8').replace(/\{\{(\w+)\}\}/g, (_, name) => ({...places, ...more})[name]);
  const page = pageOf({policy: policyWith('', []), threads: ''});
  if (Buffer.byteLength(page) > mostBytes) throw new Error(`the studio's page has ${Buffer.byteLength(page)} bytes, more than ${mostBytes}`);
  writeFileSync(join(dist, 'studio.html'), page);
  // It may fetch the engine's other files from where it came from, and from nowhere else.
  mkdirSync(join(dist, 'isolated'), {recursive: true});
  writeFileSync(join(dist, 'isolated/studio.html'), pageOf({policy: policyWith(" 'self'", ["connect-src 'self'"]), threads: ' data-threads="threads/"'}));
  putThreads(join(dist, 'isolated/threads'));
  console.log(`${join(dist, 'studio.html')}: ${Buffer.byteLength(page)} bytes; odontoscope.wasm: ${readFileSync(join(engine, 'odontoscope.wasm')).length}`);
}

mkdirSync(dist, {recursive: true});
makePackage();
await makeStudio();
