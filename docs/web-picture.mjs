// A picture of a page that `odontoscope web` wrote, as Chromium shows it. Called by make-pictures.
//   node web-picture.mjs PAGE.html PICTURE.png WIDTHxHEIGHT MODULES [#ADDRESS [SCRIPT]]
// MODULES: node_modules with playwright-core, such as the judges' own. SCRIPT: run with `viewer` before the picture is taken.
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [page_, picture, size, modules, address = '', script = ''] = process.argv.slice(2), [width, height] = size.split('x').map(Number);
const {chromium} = createRequire(join(resolve(modules), 'x.js'))('playwright-core');
const browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--no-first-run']});
const page = await browser.newPage({viewport: {width, height}, colorScheme: 'dark', reducedMotion: 'reduce'});
page.setDefaultTimeout(300_000);   // software draws
page.on('pageerror', error => { throw error; });
await page.goto(pathToFileURL(resolve(page_)).href + address);
await page.waitForFunction(() => Promise.race([odontoscope, new Promise(done => setTimeout(done, 500))]));
await page.evaluate(async () => { globalThis.viewer = await odontoscope; });
// Asked again and again instead of told by an event, which may have come before anybody listened.
const still = () => page.waitForFunction(() => viewer.frames > 0 && viewer.picture.finished(viewer.wayOf(viewer.quality.still)), null, {polling: 200});
const nextFrames = () => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
await still();
await page.evaluate(script);
await nextFrames();   // what the script changed is drawn by then
await still();
await page.screenshot({path: picture});
await browser.close();
