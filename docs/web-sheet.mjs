// One sheet of a CT's page on a desk's screen and on a phone's: as a volume, cut open, from within the chamber, and as a
// film. Called by make-pictures.
//   node web-sheet.mjs CT.html PICTURE.png MODULES      CT.html: with --show both; MODULES: see shown-page.mjs
import {browser, shownPage} from './shown-page.mjs';

const [file, picture, modules] = process.argv.slice(2);
const desk = {width: 900, height: 620}, phone = {width: 390, height: 760}, tall = 496;   // of a picture on the sheet

const to = id => `document.getElementById('${id}').scrollIntoView()`;
const scenes = [
  ['The CT as a volume', `viewer.setVolume({shows: 'volume'}); ${to('volume-controls')}`],
  ['Cut open, with the pulp\u2019s surface', `viewer.cut({on: true, at: 0.5}); viewer.look('buccal'); ${to('volume-controls')}`],
  ['From within the chamber', `
    viewer.setVolume({shows: 'volume', transfer: viewer.volume.told.transfers.dentine});
    viewer.startTour(0);
    viewer.play(false);
    viewer.seek(1);
    ${to('volume-controls')}`],
  ['The radiograph, on a film of size 2, tube swung by 20\u00b0', `
    const {air, dentine, dentine_attenuation: attenuation} = viewer.volume.told;
    viewer.setVolume({shows: 'volume', cast: 'radiograph', window: [air, dentine], attenuation});
    viewer.setFilmLook({film_mm: [31, 41], latitude: 2.6});
    const tube = document.querySelector('input[aria-label="Tube swung by"]');
    tube.value = 20;
    tube.dispatchEvent(new Event('input'));
    ${to('film-size')}`],
];

const chromium = await browser(modules);
async function shot(size, script) {
  const page = await shownPage(chromium, file, {...size, script: `(() => {${script}})()`});
  const png = (await page.screenshot()).toString('base64');
  await page.close();
  return `<img src="data:image/png;base64,${png}" height="${tall}">`;
}
const cells = [];
for (const [words, script] of scenes)
  cells.push(`<figure><figcaption>${words}</figcaption>${await shot(desk, script)}${await shot(phone, script)}</figure>`);
const style = `
  body { margin: 0; padding: 12px; background: #fff; font: 20px sans-serif; color: #16181c; width: max-content }
  body { display: grid; grid-template-columns: auto auto; gap: 16px }
  figure { margin: 0 } figcaption { margin: 0 0 6px } img { margin-right: 8px; vertical-align: top; border-radius: 6px }`;
const sheet = await chromium.newPage({viewport: {width: 2040, height: 1100}});
await sheet.setContent(`<style>${style}</style>${cells.join('')}`);
await sheet.locator('body').screenshot({path: picture});
await chromium.close();
