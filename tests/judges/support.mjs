// What the judges have in common: the program, models made by it, packages, and the browser.
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const program = process.env.ODONTOSCOPE_PROGRAM;
export const modules = join(process.env.ODONTOSCOPE_JUDGES ?? '.', 'node_modules');

/// Ends the script; ctest then reports it as skipped.
export function skip(reason) {
  console.log(`SKIPPED: ${reason}`);
  process.exit(0);
}

export function needPackages() {
  if (!existsSync(join(modules, '../installed'))) skip('the packages of tests/judges/package-lock.json are not installed (no Node.js, npm or registry)');
}

export const packageNamed = name => createRequire(join(modules, '../package.json'))(name);
/// A file of web/source with the packages that it uses, as the page has them; or a skip.
export async function bundled(name) {
  const web = process.env.ODONTOSCOPE_WEB ?? '.', outfile = join(folder, `${name}.mjs`);
  if (!existsSync(join(web, 'node_modules/esbuild'))) skip('this odontoscope was built without its web page');
  await createRequire(join(web, 'package.json'))('esbuild').build({
    entryPoints: [fileURLToPath(new URL(`../../web/source/${name}`, import.meta.url))], bundle: true, format: 'esm', outfile,
    nodePaths: [join(web, 'node_modules')], logLevel: 'error',
  });
  return import(pathToFileURL(outfile).href);
}
export const importFile = path => import(pathToFileURL(join(modules, path)).href);

/// A folder that goes when the script ends.
export const folder = mkdtempSync(join(tmpdir(), 'odontoscope-judges-'));
process.on('exit', () => rmSync(folder, {recursive: true, force: true}));

export function odontoscope(...words) {
  return execFileSync(program, ['--quiet', ...words], {cwd: folder, stdio: ['ignore', 'pipe', 'pipe']}).toString();
}
export const made = name => join(folder, name);

/// A GLB file's two chunks.
export function glbParts(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  return {json, binary: bytes.subarray(28 + length)};
}

export function glbOf({json, binary}) {
  let text = new TextEncoder().encode(JSON.stringify(json));
  const padded = new Uint8Array(Math.ceil(text.length / 4) * 4).fill(0x20);
  padded.set(text);
  const bytes = new Uint8Array(28 + padded.length + binary.length), view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, padded.length, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true));
  bytes.set(padded, 20);
  view.setUint32(20 + padded.length, binary.length, true);
  view.setUint32(24 + padded.length, 0x004e4942, true);
  bytes.set(binary, 28 + padded.length);
  return bytes;
}

export const bytesOf = name => new Uint8Array(readFileSync(made(name)));

/// Chromium without a display, or a skip.
export async function browser() {
  const path = process.env.ODONTOSCOPE_CHROMIUM;
  if (!path || !existsSync(path)) skip('Chromium was not found (Debian: chromium)');
  return packageNamed('playwright-core').chromium.launch({
    executablePath: path,
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
}

/// Firefox on a display in memory, which this script must run in: without one it has no WebGL. Or a skip.
export async function firefox() {
  const path = process.env.ODONTOSCOPE_FIREFOX;
  if (!path || !existsSync(path)) skip('Firefox was not found (Debian: firefox-esr)');
  if (!process.env.DISPLAY) skip('xvfb-run was not found (Debian: xvfb, xauth)');
  return packageNamed('playwright-core').firefox.launch({executablePath: path, channel: 'moz-firefox', headless: false});   // the channel: spoken to by WebDriver BiDi
}

/// `odontoscope web` with these words, or a skip where it was built without its page.
export function pageOrSkip(...words) {
  try {
    odontoscope('web', ...words);
  } catch (error) {
    if (String(error.stderr).includes('built without its web page')) skip('this odontoscope was built without its web page');
    throw error;
  }
}

/// A stack of two square pillars, one over and beside the other: whether they are one is open, so its certificate is amber.
export function writeBrokenPillar(name) {
  const square = left => ({points: [[left, 0], [left + 1, 0], [left + 1, 1], [left, 1]]});
  const slices = Array.from({length: 10}, (_, k) => ({z: k, contours: [square(k < 5 ? 0 : 1.5)]}));
  writeFileSync(made(name), JSON.stringify({format: 'odontoscope.contours', version: 1, unit: 'mm', slices}));
}

/// The page, opened from disk, with the model there. `watched` fills with what went wrong and what was asked of the network.
export async function openedIn(driven, file, {size = {width: 760, height: 500}, before = null, context = {}} = {}) {
  const within = await driven.newContext({viewport: size, deviceScaleFactor: 1, colorScheme: 'dark', ...context}), page = await within.newPage(), watched = [];
  const itself = pathToFileURL(file).href;
  page.setDefaultTimeout(60_000);
  page.on('pageerror', error => watched.push(`error ${error.message}`));
  // The driver's words about speed are about software drawing, not about the page.
  page.on('console', message => { if (!message.text().includes('GPU stall due to ReadPixels')) watched.push(`console ${message.type()}: ${message.text()}`); });
  page.on('request', request => { if (request.url() !== itself && !request.url().startsWith('blob:') && !request.url().startsWith('data:')) watched.push(`request ${request.url()}`); });
  if (before) await page.addInitScript(before);
  await page.goto(itself);
  // Software draws: as while things move, and nothing is made finer meanwhile.
  await page.evaluate(async () => { globalThis.viewer = await odontoscope; viewer.picture.mostSamples = 0; });
  return {page, watched, close: () => within.close()};
}
