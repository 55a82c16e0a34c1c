// A picture of a page that `odontoscope web` wrote, as Chromium shows it. Called by make-pictures.
//   node web-picture.mjs PAGE.html PICTURE.png WIDTHxHEIGHT MODULES      MODULES: node_modules with playwright-core, such as the judges' own
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [page_, picture, size, modules] = process.argv.slice(2), [width, height] = size.split('x').map(Number);
const {chromium} = createRequire(join(resolve(modules), 'x.js'))('playwright-core');
const browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--no-first-run']});
const page = await browser.newPage({viewport: {width, height}, colorScheme: 'dark'});
await page.goto(pathToFileURL(resolve(page_)).href);
await page.evaluate(async () => {
  const viewer = await odontoscope;
  await new Promise(done => viewer.addEventListener('drawn', done, {once: true}));
});
await page.screenshot({path: picture});
await browser.close();
