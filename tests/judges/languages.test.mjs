// The page in other languages: who chooses, that everything is said in it, that nothing is cut off, and that answers stay right.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {after, test} from 'node:test';
import {browser, made, needPackages, odontoscope, openedIn, pageOrSkip, writeBrokenPillar} from './support.mjs';

needPackages();
const chromium = await browser();
after(() => chromium.close());

odontoscope('sample', 'molar', '--slice-spacing', '0.35', '--point-spacing', '0.5', '-o', 'molar.json');
pageOrSkip('molar.json', '--triangles', '6000', '--db', '--grid', '16', '-o', 'both.html');
odontoscope('web', 'molar.json', '--triangles', '6000', '--lesson', 'Find your way', '--language', 'de', '-o', 'quiz.html');
writeFileSync(made('xx.json'), JSON.stringify({format: 'odontoscope.language', version: 1, language: 'x-test', name: 'Probe', decimal: '.', group: ',', texts: [['Structures', 'S\u0442r</script>'], ['enamel', 'en\u00e1mel']]}));
odontoscope('web', 'molar.json', '--triangles', '6000', '--language', 'xx.json', '-o', 'xx.html');

const desk = {width: 1136, height: 700}, phone = {width: 390, height: 760};
async function opened(name, {hash = '', size = desk, context = {}, before = null} = {}) {
  const one = await openedIn(chromium, made(name), {size, context: {reducedMotion: 'reduce', ...context}, before: before ?? (hash ? `if (!location.hash) location.hash = ${JSON.stringify(hash)}` : null)});
  await one.page.evaluate(() => { viewer.renderer.setAnimationLoop(null); viewer.shade = false; });   // software draws: only when told to
  return one;
}
const spoken = page => page.evaluate(() => [document.documentElement.lang, document.querySelector('#controls h2').textContent, document.querySelector('#labels span').textContent]);

test('the page speaks English, and what its browser, its maker or its address asks for', async () => {
  for (const [name, options, lang, label] of [
    ['both.html', {}, 'en', 'dentine'], ['both.html', {context: {locale: 'de-AT'}}, 'de', 'Dentin'], ['both.html', {context: {locale: 'fr-FR'}}, 'en', 'dentine'],
    ['both.html', {hash: '#language=de'}, 'de', 'Dentin'], ['both.html', {hash: '#language=en', context: {locale: 'de-DE'}}, 'en', 'dentine'],
    ['quiz.html', {}, 'de', 'Dentin'], ['quiz.html', {hash: '#language=en'}, 'en', 'dentine'],
  ]) {
    const {page, watched, close} = await opened(name, options);
    assert.deepEqual((await spoken(page)).filter((_, i) => i !== 1), [lang, label], `${name} ${JSON.stringify(options)}`);
    assert.deepEqual(watched, []);
    await close();
  }
});

test('a language is chosen on the page, which then says it everywhere and remembers it', async () => {
  const {page, close} = await opened('both.html');
  await Promise.all([page.waitForEvent('load'), page.selectOption('#choose-language', 'de')]);
  await page.evaluate(async () => { globalThis.viewer = await odontoscope; });
  assert.deepEqual((await spoken(page))[0], 'de');
  assert.match(await page.evaluate(() => location.hash), /language=de/);
  await Promise.all([page.waitForEvent('load'), page.selectOption('#choose-language', 'en')]);
  await page.evaluate(async () => { globalThis.viewer = await odontoscope; });
  assert.deepEqual((await spoken(page))[0], 'en');
  await close();
});

test('in German nothing is said in English, not even the report', async () => {
  const {page, close} = await opened('both.html', {hash: '#language=de'});
  const said = await page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    viewer.show(1);
    const db = document.getElementById('controls').innerText;
    viewer.show(0);
    viewer.startTour(0);
    viewer.seek(viewer.tours[0].length / 2);
    viewer.draw({way: {layers: false, shade: false}});
    const labels = [...document.querySelectorAll('[aria-label], [title]')].flatMap(e => [e.getAttribute('aria-label'), e.title]).filter(Boolean);
    return [db, document.getElementById('controls').innerText, document.getElementById('bar').innerText, document.getElementById('help').textContent, document.getElementById('stage').innerText, ...labels].join('\n').replace(/^English$/m, '');
  });
  const english = said.match(/^.*\b(the|of|and|surface|triangles?|every|with|to|from|slices|canal|below|wide|enamel|dentine|pulp|key|cut|is|are)\b.*$/gmi);
  assert.equal(english, null, english?.join('\n'));
  assert.match(said, /13,\d mm/);
  assert.match(said, /Mesio(bukkal|lingual)er Kanal: \d,\d von 1[23],\d mm unter dem Kanaleingang, \d,\d\d mm weit/);
  await close();
});

test('in German a place to look at, and what decides it, are told in German', async () => {
  writeBrokenPillar('pillar.json');
  odontoscope('web', 'pillar.json', '-o', 'pillar.html');
  const {page, close} = await opened('pillar.html', {hash: '#language=de'});
  const told = await page.evaluate(() => [document.querySelector('.verdict').innerText, ...[...document.querySelectorAll('.places li')].map(e => e.textContent)].join('\n'));
  assert.doesNotMatch(told, /\b(the|of|and|slices?|near|if|may|piece|where|contours)\b/);
  assert.match(told, /Gelb: zertifiziert, aber bitte prüfen: 1 Stelle/);
  assert.match(told, /--link|--unlink/);
  await close();
});

/// Elements whose words do not fit into them, or lie beyond the window.
const cutOff = () => [...document.querySelectorAll('#panel *, #bar *, #notice, #labels span, #pins span, #cues span, dialog *')]
  .filter(e => e.childElementCount === 0 && e.textContent.trim() && e.offsetWidth && !e.closest('.unseen') && !['OPTION', 'SELECT'].includes(e.tagName))
  .filter(e => (getComputedStyle(e).display !== 'inline' && e.scrollWidth > e.clientWidth + 1) || e.getBoundingClientRect().right > innerWidth + 1 || e.getBoundingClientRect().left < -1)
  .map(e => `${e.tagName} ${e.textContent.slice(0, 60)}`);

for (const [name, size] of [['desk', desk], ['phone', phone]])
  test(`no words are cut off in German: ${name}`, async () => {
    for (const file of ['both.html', 'quiz.html']) {
      const {page, close} = await opened(file, {hash: '#language=de', size});
      const look = async () => assert.deepEqual(await page.evaluate(cutOff), [], file);
      await page.evaluate(() => { if (document.getElementById('panel').classList.contains('folded')) document.getElementById('fold').click(); for (const details of document.querySelectorAll('details')) details.open = true; viewer.cut({on: true}); viewer.draw({way: {layers: false, shade: false}}); });
      await look();
      if (file === 'quiz.html') for (let step = 0; step < 11; ++step) {
        await page.evaluate(to => viewer.teaching.lesson.go(to), step);
        await look();
      }
      for (const mode of ['startTour', 'startFlight']) {
        await page.evaluate(called => { viewer[called](...called === 'startTour' ? [0] : []); viewer.draw({way: {layers: false, shade: false}}); }, mode);
        await look();
      }
      await page.evaluate(() => { viewer.leave(); document.getElementById('help').showModal(); });
      await look();
      await close();
    }
  });

test('this would be noticed: words that do not fit', async () => {
  const {page, close} = await opened('both.html', {hash: '#language=de'});
  await page.evaluate(() => { const button = document.querySelector('.choices button'); Object.assign(button.style, {width: '20px', flex: 'none', overflow: 'hidden', whiteSpace: 'nowrap'}); button.textContent = 'Schmelz-Zement-Grenze'; });
  assert.equal((await page.evaluate(cutOff)).length, 1);
  await close();
});

test('answers are right in German, with a decimal comma, and marks have the names that data have', async () => {
  const {page, close} = await opened('quiz.html');
  const rows = await page.evaluate(async () => {
    const {lesson} = viewer.teaching, given = {click: q => ({structure: q.structure, structures: [q.structure], part: q.part ?? null}), choice: q => q.answer};
    for (let i = 0; i < lesson.count; ++i) {
      lesson.go(i);
      const {question} = lesson.note;
      if (question.kind !== 'number') { lesson.answer(given[question.kind](question)); continue; }
      document.querySelector('.question input').value = question.unit === 'mm' ? '12,2' : String(question.answer);
      document.querySelector('.question form').requestSubmit();
    }
    lesson.go(lesson.count);
    return {score: lesson.score, given: lesson.rows.map(row => row.given), text: document.getElementById('lesson').innerText};
  });
  assert.deepEqual(rows.score, {right: 10, of: 10});
  assert.ok(rows.given.includes('enamel') && rows.given.includes('mesiobuccal canal'), rows.given.join());
  assert.match(rows.text, /10 von 10 richtig/);
  assert.match(rows.text, /Ihre Antwort: mesiobukkaler Kanal\./);
  assert.match(rows.text, /12,2 mm/);
  await close();
});

test('a label tells in two sentences what its structure is, and the tooth has its numbers', async () => {
  for (const [hash, first, tooth] of [['', /^The hard cap of the crown.*\. .*\.$/, 'Lower left first molar: FDI 36, Universal 19'], ['#language=de', /^Die harte Kappe der Krone.*\. .*\.$/, 'Unterer linker erster Molar: FDI 36, Universal 19']]) {
    const {page, close} = await opened('both.html', {hash});
    assert.equal(await page.textContent('#tooth'), tooth);
    const draw = () => page.evaluate(() => viewer.draw({way: {layers: false, shade: false}}));
    await draw();
    const label = page.locator('#labels span', {hasText: hash ? 'Schmelz' : 'enamel'}).first();
    assert.equal(await label.locator('small').count(), 0);
    await label.click({position: {x: 5, y: 5}});
    await draw();
    assert.match(await label.locator('small').innerText(), first);
    const box = await label.boundingBox();
    assert.ok(box.x > 300 && box.x + box.width <= 1136 && box.y >= 0, JSON.stringify(box));
    await page.focus('#canvas');
    await page.keyboard.press('Escape');
    assert.equal(await label.locator('small').count(), 0);
    // For whoever has no mouse the same stands in the panel.
    const told = await page.evaluate(() => [...document.querySelectorAll('.what')].map(e => e.textContent));
    assert.equal(told.length, 4);
    assert.ok(told.every(words => words.length > 100), told.join());
    await close();
  }
});

test('a language of its own comes with a page, and its words stay text', async () => {
  const {page, close, watched} = await opened('xx.html');
  assert.deepEqual(await page.evaluate(() => [document.documentElement.lang, [...document.querySelectorAll('h2')].some(h => h.textContent === 'S\u0442r</script>'), [...document.querySelectorAll('#labels span')].map(e => e.textContent).includes('en\u00e1mel')]), ['x-test', true, true]);
  assert.equal(await page.locator('#choose-language option').count(), 3);
  assert.deepEqual(watched, []);
  await close();
});
