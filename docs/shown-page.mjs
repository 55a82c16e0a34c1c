// A page that `odontoscope web` wrote, opened in Chromium to be pictured. For web-picture.mjs and web-sheet.mjs.
// MODULES: node_modules with playwright-core, such as the judges' own.
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

export function browser(modules) {
  const {chromium} = createRequire(join(resolve(modules), 'x.js'))('playwright-core');
  return chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--no-first-run']});
}

/// Opened, `script` run with `viewer`, and drawn to the end. Asked again and again instead of told by an event, which may
/// have come before anybody listened.
export async function shownPage(browser, file, {width, height, address = '', script = ''}) {
  const page = await browser.newPage({viewport: {width, height}, colorScheme: 'dark', reducedMotion: 'reduce'});
  page.setDefaultTimeout(300_000);   // software draws
  page.on('pageerror', error => { throw error; });
  await page.goto(pathToFileURL(resolve(file)).href + address);
  await page.waitForFunction(() => Promise.race([odontoscope, new Promise(done => setTimeout(done, 500))]));
  await page.evaluate(async () => { globalThis.viewer = await odontoscope; });
  const finished = () => viewer.frames > 0 && viewer.picture.finished(viewer.wayOf(viewer.quality.still));
  const still = () => page.waitForFunction(finished, null, {polling: 200});
  await still();
  await page.evaluate(script);
  // What the script changed is drawn by then.
  await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  await still();
  return page;
}
