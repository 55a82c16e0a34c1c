// Can everybody use the page? Axe's rules, and what they do not see: focus that follows the picture, targets for fingers, less motion.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {browser, made, modules, needPackages, odontoscope, openedIn, pageOrSkip, writeBrokenPillar} from './support.mjs';

needPackages();
const chromium = await browser();
after(() => chromium.close());
pageOrSkip('--triangles', '1500', '--db', '--grid', '12', '--cases', 'classic-unoriented', '-o', 'access.html');
const axe = readFileSync(join(modules, 'axe-core/axe.min.js'), 'utf8');
const rules = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

const desk = {width: 1024, height: 768}, phone = {width: 390, height: 844}, onPhone = {hasTouch: true, isMobile: true};
const one = await openedIn(chromium, made('access.html'), {size: desk});
const states = [
  ['at the start', () => {}],
  ['with everything unfolded and cut', () => { for (const details of document.querySelectorAll('details')) details.open = true; document.getElementById('panel').classList.remove('folded'); viewer.cut({on: true}); }],
  ['with DB', () => viewer.show(1)],
  ['in the help', () => document.querySelector('#help').showModal()],
  ['on tour', () => { document.querySelector('#help').close(); viewer.startTour(0); viewer.play(false); }],
  ['in flight', () => viewer.startFlight()],
];

/// What axe has against the page as it is, in words.
async function complaints(page) {
  return page.evaluate(async tags => {
    const {violations} = await axe.run(document, {runOnly: tags, resultTypes: ['violations']});
    return violations.map(v => `${v.id}: ${v.help}: ${v.nodes.map(node => node.target.join(' ') + ' ' + (node.any[0]?.message ?? '')).join(' | ')}`);
  }, rules);
}

async function look(opened, name) {
  await opened.page.evaluate(axe);
  for (const [what, act] of states) {
    await opened.page.evaluate(act);
    assert.deepEqual(await complaints(opened.page), [], `${name}, ${what}`);
  }
}

test('axe finds nothing on a desk, dark', () => look(one, 'dark'));

test('axe finds nothing on a phone, light', async () => {
  const two = await openedIn(chromium, made('access.html'), {size: phone, context: {...onPhone, colorScheme: 'light'}});
  await look(two, 'light');
  await two.close();
});

test('axe finds nothing on an amber certificate, dark and light', async () => {
  writeBrokenPillar('pillar.json');
  odontoscope('web', 'pillar.json', '-o', 'pillar.html');
  for (const colorScheme of ['dark', 'light']) {
    const two = await openedIn(chromium, made('pillar.html'), {size: desk, context: {colorScheme}});
    await two.page.evaluate(axe);
    assert.ok(await two.page.locator('.places button').isVisible());
    assert.deepEqual(await complaints(two.page), [], colorScheme);
    await two.close();
  }
});

test('this would be noticed: grey on grey, a button without a name, a small target', async () => {
  const {page} = one;
  for (const [rule, harm] of [
    ['color-contrast', () => { document.querySelector('h1').style.color = '#444'; }],
    ['button-name', () => { [...document.querySelectorAll('#controls button:not([title])')].at(-1).textContent = ''; }],
    ['target-size', () => { document.querySelector('.choices').scrollIntoView(); for (const b of document.querySelectorAll('.choices button')) Object.assign(b.style, {minHeight: '9px', height: '9px', padding: 0, fontSize: '6px', flex: '0 0 9px'}); }],
  ]) {
    await page.evaluate(() => { viewer.leave(); });
    await page.evaluate(harm);
    assert.ok((await complaints(page)).some(words => words.startsWith(rule)), rule);
  }
  await one.close();
});

test('the keyboard goes through the page in the order of the eye, and is where it is needed', async () => {
  const {page, close} = await openedIn(chromium, made('access.html'), {size: desk});
  const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.textContent || document.activeElement.getAttribute('aria-label'));
  const order = [];
  for (let i = 0; i < 5; ++i) { await page.keyboard.press('Tab'); order.push(await focused()); }
  assert.deepEqual(order.slice(0, 2), ['To the controls', 'canvas']);
  const tall = await page.evaluate(() => {   // the panel from top to bottom
    const tops = [...document.querySelectorAll('#panel button, #panel input, #panel summary')].filter(e => e.offsetParent).map(e => [e.getBoundingClientRect().top, e.getBoundingClientRect().left]);
    return tops.every(([top], i) => i === 0 || top > tops[i - 1][0] - 30);
  });
  assert.ok(tall);
  // Entering a tour the focus goes to what drives it, leaving it, back to where it was.
  await page.getByRole('button', {name: /distal canal/}).focus();
  await page.keyboard.press('Enter');
  assert.match(await focused(), /Pause|Play/);
  await page.keyboard.press('Escape');
  assert.match(await focused(), /distal canal/);
  // Help gives the focus back too.
  await page.focus('#canvas');
  await page.keyboard.press('?');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'canvas');
  await close();
});

test('fingers find their targets, 24 px and more', async () => {
  const {page, close} = await openedIn(chromium, made('access.html'), {size: phone, context: onPhone});
  const small = await page.evaluate(() => {
    document.getElementById('fold').click();
    for (const details of document.querySelectorAll('details')) details.open = true;
    viewer.cut({on: true});
    const found = [];
    for (const mode of ['outside', 'tour', 'fly']) {
      if (mode === 'tour') { viewer.startTour(0); viewer.play(false); }
      if (mode === 'fly') viewer.startFlight();
      for (const e of document.querySelectorAll('button, input, summary')) {
        const box = (e.type === 'checkbox' ? e.closest('label') : e).getBoundingClientRect();
        if (e.offsetParent && (box.width < 24 || box.height < 24)) found.push(`${mode}: ${e.outerHTML.slice(0, 60)} ${box.width} x ${box.height}`);
      }
    }
    return found;
  });
  assert.deepEqual(small, []);
  await close();
});

test('with less motion a tour goes by still pictures', async () => {
  const {page, close} = await openedIn(chromium, made('access.html'), {size: desk, context: {reducedMotion: 'reduce'}});
  const places = await page.evaluate(() => {
    viewer.startTour(0);
    const {journey} = viewer, seen = new Set();
    for (let i = 0; i < 100; ++i) { journey.update(0.05); seen.add(journey.mm); }   // five seconds
    return [...seen];
  });
  assert.ok(places.length >= 3 && places.length <= 5, places.join(' '));
  await close();
});
