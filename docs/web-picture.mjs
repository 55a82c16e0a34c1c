// A picture of a page that `odontoscope web` wrote, as Chromium shows it. Called by make-pictures.
//   node web-picture.mjs PAGE.html PICTURE.png WIDTHxHEIGHT MODULES [#ADDRESS [SCRIPT]]
// MODULES: see shown-page.mjs. SCRIPT: run with `viewer` before the picture is taken.
import {browser, shownPage} from './shown-page.mjs';

const [file, picture, size, modules, address = '', script = ''] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number), chromium = await browser(modules);
const page = await shownPage(chromium, file, {width, height, address, script});
await page.screenshot({path: picture});
await chromium.close();
