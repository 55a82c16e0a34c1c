// Bundles source/ into one page without a model, page.html.
//   node build.mjs WORK      WORK holds node_modules and takes the page
import {createHash} from 'node:crypto';
import {readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {themeStyle} from './theme.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const work = process.argv[2];
const {build, transform} = createRequire(join(work, 'package.json'))('esbuild');

const mostBytes = 1_500_000;   // the page is to travel by mail

async function bundledScript() {
  const made = await build({
    entryPoints: [join(here, 'source/main.js')],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2022',
    charset: 'ascii',
    legalComments: 'none',
    loader: {'.glsl': 'text', '.frag': 'text'},
    nodePaths: [join(work, 'node_modules')],
    logLevel: 'warning',
  });
  return made.outputFiles[0].text.trim();
}

const hash = text => `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;

/// A licence's words must travel with the code they are about.
function notices() {
  const words = name => `${name}:\n\n${readFileSync(join(work, `node_modules/${name}/LICENSE`), 'utf8').trim().replaceAll('--', '- -')}`;
  return `<!--\nThis page was written by Odontoscope (GPL-3.0-or-later). It contains three.js and three-mesh-bvh.\n\n${['three', 'three-mesh-bvh'].map(words).join('\n\n')}\n-->`;
}

/// All of assets/languages in one line, which no parser of HTML takes for anything but text. Errors are told by who reads files, which this page does not.
function languages() {
  const folder = join(here, '../assets/languages'), files = readdirSync(folder).filter(name => name.endsWith('.json')).sort();
  const all = files.map(name => ({...JSON.parse(readFileSync(join(folder, name), 'utf8')), errors: undefined}));
  return JSON.stringify(all).replace(/[<>&]/g, sign => `\\u${sign.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

const script = await bundledScript();
if (script.includes('</script') || script.includes('<!--')) throw new Error('the script would end its element');
const style = (await transform(themeStyle + readFileSync(join(here, 'source/style.css'), 'utf8'), {loader: 'css', minify: true})).code.trim();
// No script but this one, no style sheet but this one, and no way to the network.
const policy = [
  "default-src 'none'", `script-src ${hash(script)}`, `style-src ${hash(style)}`, 'img-src data: blob:', "base-uri 'none'", "form-action 'none'",
].join('; ');

const places = {notices: notices(), policy, style, script, languages: languages()};
const page = readFileSync(join(here, 'source/page.html'), 'utf8').replace(/\{\{(\w+)\}\}/g, (_, name) => places[name]);
if (Buffer.byteLength(page) > mostBytes) throw new Error(`the page has ${Buffer.byteLength(page)} bytes, more than ${mostBytes}`);

writeFileSync(join(work, 'page.html'), page);
