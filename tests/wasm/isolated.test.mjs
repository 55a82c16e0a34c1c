// The studio on a server: with the headers that isolate a page its runs have several threads, and without them one; the models are the same.
import assert from 'node:assert/strict';
import {createServer} from 'node:http';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {extname, join, normalize} from 'node:path';
import {after, test} from 'node:test';
import {browser, firefox, needPackages} from '../judges/support.mjs';
import {dist, folder, native, skip} from './support.mjs';

needPackages();
const root = join(dist, 'isolated');
if (!existsSync(join(root, 'studio.html'))) skip('the studio for servers is not built (web/wasm/build)');
const types = {'.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm'};

/// Serves the folder; [url, close].
async function served(headers) {
  const server = createServer((asked, answer) => {
    const file = join(root, normalize(new URL(asked.url, 'http://here').pathname));
    if (!file.startsWith(root) || !existsSync(file)) return answer.writeHead(404).end();
    answer.writeHead(200, {'Content-Type': types[extname(file)] ?? 'text/plain', ...headers}).end(readFileSync(file));
  });
  await new Promise(ready => server.listen(0, '127.0.0.1', ready));
  return [`http://127.0.0.1:${server.address().port}`, () => { server.closeAllConnections(); server.close(); }];
}

const isolating = {'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp'};
const inFirefox = process.env.ODONTOSCOPE_STUDIO_IN === 'firefox', driven = await (inFirefox ? firefox() : browser());
after(() => driven.close());
const molar = native(['sample', 'molar', '-o', 'molar.json'], {}).files['molar.json'];
writeFileSync(join(folder, 'molar.json'), molar);

for (const [how, headers, words] of [['isolated: several threads', isolating, /^([2-9]|1\d)$/], ['not isolated: one thread', {}, /^1$/]])
  test(how, {timeout: 300_000}, async t => {
    const [url, close] = await served(headers), page = await driven.newPage(), watched = [];
    t.after(() => { page.close(); close(); });
    page.setDefaultTimeout(120_000);
    page.on('pageerror', error => watched.push(`error ${error.message}`));
    page.on('request', request => { if (!request.url().startsWith(url) && !/^(blob|data):/.test(request.url())) watched.push(`request ${request.url()}`); });
    const idle = () => page.waitForFunction(() => document.getElementById('working').hidden);
    await page.goto(`${url}/studio.html`);
    assert.equal(await page.evaluate(() => crossOriginIsolated), headers === isolating);
    await page.setInputFiles('#file', join(folder, 'molar.json'));
    await page.waitForFunction(() => document.getElementById('said').dataset.threads && document.getElementById('working').hidden);
    assert.equal(await page.getAttribute('#verdict', 'class'), 'certified');
    assert.match(await page.getAttribute('#said', 'data-threads'), words);
    await page.click('#make');
    await page.waitForSelector('#cancel:not([hidden])');
    await page.$eval('#cancel', button => button.click());   // at once, while it is there
    await page.waitForSelector('#failure:not([hidden])');
    await page.click('.sample[value=incisor]');
    await page.waitForFunction(() => document.getElementById('given').textContent === 'incisor.json');
    await idle();
    assert.equal(await page.getAttribute('#verdict', 'class'), 'certified');
    assert.match(await page.getAttribute('#said', 'data-threads'), words);
    assert.deepEqual(watched, []);
  });
