// Lessons and quizzes on the page: by mouse, by keyboard, by address, by a page around it, and on paper.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {browser, made, modules, needPackages, odontoscope, openedIn, pageOrSkip} from './support.mjs';

needPackages();
const chromium = await browser();
after(() => chromium.close());

const hostile = `<img src=x onerror="globalThis.bitten=1">`;
const outside = {position: [0, 58, 10], target: [0, 0, 9.6], up: [0, 0, 1]}, clear = {format: 'odontoscope.scene', version: 1, structures: [{name: 'enamel', opacity: 0.2}, {name: 'dentine', opacity: 0.2}]};
const notes = [
  {title: 'The tooth', text: `Two roots. ${hostile}`, inside: false, camera: {position: [-25, 48, 30], target: [0, 0, 9.6], up: [0, 0, 1]}, marks: [{at: [0, 0, 18], label: 'crown'}, {at: [3, 0, 3], label: hostile}]},
  {title: 'Cut open', text: 'From buccal.', inside: false, camera: outside, scene: {...clear, section: {point: [0, 0.5, 9], normal: [0, 2, 0]}},
    arrows: [{from: [-7, 3, 15], to: [-1, 0.5, 9], label: hostile}, {from: [5, 4, 5], to: [3, 0.5, 4]}], narration: 'Dentine is pale. It is 3.4 mm thick here!\nThe pulp is inside.'},
  {title: 'Inside', text: '', inside: true, camera: {position: [-0.5, 0, 13], target: [-0.5, 0, 12], up: [0, 1, 0]}, scene: clear},
  {title: 'Down', text: '', inside: true, tour: 'distal canal', camera: {position: [-4, 0, 6], target: [-4, 0, 5], up: [0, 1, 0]}},
  {title: 'Which?', text: '', inside: false, camera: outside, scene: clear, marks: [{at: [-4, 0, 6], label: ''}], question: {kind: 'choice', ask: 'Which tissue is under the pin?', choices: ['enamel', 'pulp'], answer: 1, explain: 'It is the pulp.'}},
  {title: 'Find', text: '', inside: false, camera: outside, scene: clear, question: {kind: 'click', ask: 'Click the distal canal.', structure: 'pulp', part: 'distal canal', explain: ''}},
  {title: 'Measure', text: '', inside: false, camera: outside, scene: clear, question: {kind: 'number', ask: '=How long?', answer: 12.5, within: 0.5, unit: 'mm', explain: ''}},
];
const lessonOf = change => JSON.stringify({format: 'odontoscope.tour', version: 4, title: 'Three canals', model: 'molar.json', language: 'en', notes, translations: [{language: 'fr', texts: [['The tooth', 'La dent']]}, {language: 'de-AT', texts: [['The tooth', 'Der Zahn'], ['crown', 'Krone'], ['Dentine is pale. It is 3.4 mm thick here!\nThe pulp is inside.', hostile]]}], ...change});
odontoscope('sample', 'molar', '--slice-spacing', '0.35', '--point-spacing', '0.5', '-o', 'molar.json');
writeFileSync(made('canals.tour.json'), lessonOf({}));
writeFileSync(made('exam.tour.json'), lessonOf({feedback: 'at-end', title: 'Exam', notes: notes.slice(4)}));
pageOrSkip('canals.tour.json', '-o', 'lesson.html');
odontoscope('web', 'molar.json', '--lesson', 'exam.tour.json', '-o', 'exam.html');
writeFileSync(made('box.json'), JSON.stringify({format: 'odontoscope.contours', version: 1, unit: 'mm', slices: [0, 1, 2].map(z => ({z, contours: [{points: [[0, 0], [9, 0], [9, 9], [0, 9]]}]}))}));
odontoscope('web', 'box.json', '--lesson', 'canals.tour.json', '-o', 'embedded.html');   // drawn in no time

const size = {width: 720, height: 420}, context = {reducedMotion: 'reduce', acceptDownloads: true};
const one = await openedIn(chromium, made('lesson.html'), {size, context});
after(() => one.close());
const {page} = one;
// Software draws: only when told to.
const quiet = opened => opened.page.evaluate(() => { viewer.renderer.setAnimationLoop(null); viewer.shade = viewer.teaching.staging.usualShade = false; Object.assign(viewer.teaching.handout, {size: {width: 180, height: 120}, way: {layers: false, shade: false}}); });
await quiet(one);
const go = step => page.evaluate(hash => { location.hash = hash; return new Promise(done => setTimeout(done, 0)); }, `#step=${step}`);
const state = () => page.evaluate(() => ({
  step: viewer.teaching.lesson.index + 1, hash: location.hash, heading: document.querySelector('#lesson h2').textContent, told: document.querySelector('#lesson .unseen').textContent,
  section: viewer.section.plane()?.toArray() ?? null, mode: viewer.journey.mode, dentine: viewer.looks.get('dentine').opacity,
}));
/// Where a place of the model is in the window.
const inWindow = place => page.evaluate(at => {
  viewer.draw({way: {layers: false, shade: false}});
  const p = viewer.bounds.centre.clone().fromArray(at).project(viewer.camera), box = viewer.canvas.getBoundingClientRect();
  return {x: box.left + (p.x + 1) / 2 * box.width, y: box.top + (1 - p.y) / 2 * box.height};
}, place);
const halfDown = name => page.evaluate(called => { const tour = viewer.tours.find(one => one.name === called); return tour.place(0.5 * (tour.orifice + tour.length)).toArray(); }, name);

test('a lesson opens with its first step, says it, and its text stays text', async () => {
  const first = await state();
  assert.deepEqual([first.step, first.heading, first.hash], [1, 'The tooth', '#step=1']);
  assert.match(first.told, /Step 1 of 7\. The tooth\. Two roots/);
  assert.equal(await page.title(), 'Three canals');
  assert.ok((await page.textContent('#lesson')).includes(hostile) && (await page.textContent('#pins')).includes(hostile));
  assert.equal(await page.evaluate(() => globalThis.bitten), undefined);
  assert.equal(await page.locator('img').count(), 0);
  const pin = await inWindow([0, 0, 18]), dot = await page.evaluate(() => { const box = document.querySelector('#pins circle').getBoundingClientRect(); return {x: box.x + box.width / 2, y: box.y + box.height / 2}; });
  assert.ok(Math.hypot(pin.x - dot.x, pin.y - dot.y) < 1.5, JSON.stringify({pin, dot}));
});

test('steps change by button, key and address, and bring their looks, section and place', async () => {
  await page.getByRole('button', {name: 'Next'}).click();
  let now = await state();
  assert.deepEqual([now.step, now.hash, now.dentine], [2, '#step=2', 0.2]);
  assert.deepEqual(now.section.map(x => Number(x.toFixed(4))), [0, 1, 0, 0.5]);
  assert.ok(await page.evaluate(() => document.getElementById('lesson').contains(document.activeElement)), 'the focus stays in the lesson');
  await page.keyboard.press('n');
  now = await state();
  assert.deepEqual([now.step, now.mode, now.section], [3, 'fly', null]);
  const at = await page.evaluate(() => viewer.camera.position.toArray());
  assert.ok(Math.hypot(at[0] + 0.5, at[1], at[2] - 13) < 1e-6, at.join(' '));
  await go(4);
  const ride = await page.evaluate(() => ({tour: viewer.journey.tour.name, mm: viewer.journey.mm, goal: viewer.journey.tour.nearest(viewer.bounds.centre.clone().set(-4, 0, 6)).mm}));
  assert.equal(ride.tour, 'distal canal');
  assert.ok(Math.abs(ride.mm - ride.goal) < 1e-6 && ride.mm > 3, JSON.stringify(ride));
  await page.keyboard.press('p');
  assert.equal((await state()).step, 3);
});

test('arrows point at the same place from any side, and their words stay words', async () => {
  await go(2);
  for (const view of ['buccal', 'mesial', 'occlusal']) {
    await page.evaluate(name => { viewer.look(name); viewer.orbit.update(0); }, view);
    const tip = await inWindow([-1, 0.5, 9]);
    const drawn = await page.evaluate(() => { const [, x, y] = /M(?:[^L]+L){3}([\d.]+),([\d.]+)/.exec(document.querySelector('#pins path').getAttribute('d')), box = viewer.canvas.getBoundingClientRect(); return {x: box.left + Number(x), y: box.top + Number(y)}; });
    assert.ok(Math.hypot(tip.x - drawn.x, tip.y - drawn.y) < 0.2, JSON.stringify({view, tip, drawn}));
  }
  assert.deepEqual(await page.evaluate(() => [document.querySelectorAll('#pins path').length, document.querySelector('#pins .arrow').textContent]), [2, hostile]);
  await go(3);
  assert.equal(await page.locator('#pins path').count(), 0);
});

test('a step is read aloud by voices of this machine alone, in its language, with captions; without one its words are there', async () => {
  await page.evaluate(() => {
    globalThis.spoken = [];
    globalThis.SpeechSynthesisUtterance = class extends EventTarget { constructor(text) { super(); this.text = text; } };
    Object.assign(speechSynthesis, {speak: said => { spoken.push(said); said.dispatchEvent(new Event('start')); }, cancel: () => {}, voices: [], getVoices: () => speechSynthesis.voices});
  });
  const voices = list => page.evaluate(all => { speechSynthesis.voices = all; speechSynthesis.dispatchEvent(new Event('voiceschanged')); }, list);
  await voices([{lang: 'de-DE', localService: true}, {lang: 'en-GB', localService: false}]);
  await go(2);
  const read = page.getByRole('button', {name: 'Read aloud'});
  assert.equal(await read.count(), 0, 'no voice that is ours to use');
  assert.ok(await page.getByText('The pulp is inside.').isVisible(), 'so the text is unfolded');
  await voices([{lang: 'de-DE', localService: true}, {lang: 'en_GB', localService: true}]);
  assert.ok(!await page.getByText('The pulp is inside.').isVisible());
  await page.locator('.narration summary').focus();
  await page.keyboard.press('Enter');
  assert.ok(await page.getByText('The pulp is inside.').isVisible());
  await read.focus();
  await page.keyboard.press('Enter');
  const said = () => page.evaluate(() => ({texts: spoken.map(({text}) => text), languages: [...new Set(spoken.map(({lang}) => lang))], caption: document.getElementById('caption').textContent}));
  assert.deepEqual(await said(), {texts: ['Dentine is pale.', 'It is 3.4 mm thick here!', 'The pulp is inside.'], languages: ['en_GB'], caption: 'The pulp is inside.'});
  await page.evaluate(() => spoken.at(-1).dispatchEvent(new Event('end')));
  assert.ok(!await page.locator('#caption').isVisible());
  await go(1);
  assert.match((await said()).texts.at(-2), /^Two roots\.$/);   // a step without narration is its text
  await page.getByRole('button', {name: 'Stop reading'}).click();
  assert.ok(!await page.locator('#caption').isVisible());
  await go(2);
  assert.equal((await said()).texts.length, 5, 'and stays silent');
});

test('inside, numbers stand on the rings that they name, and none covers another', async () => {
  await go(4);
  const told = await page.evaluate(() => {
    viewer.seek(viewer.journey.tour.orifice + 2.6);
    viewer.draw({way: {layers: false, shade: false}});
    const spans = [...document.querySelectorAll('#cues span.number')].filter(span => span.style.display !== 'none'), tour = viewer.journey.tour;
    const boxes = spans.map(span => span.getBoundingClientRect()), rings = viewer.cues.prepared.find(one => one.tour === tour).rings;
    const overlap = boxes.some((a, i) => boxes.some((b, j) => j > i && a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom));
    return {numbers: spans.map(span => Number(span.textContent)), overlap, off: rings.map(({mm, text, at}) => Math.abs(tour.nearest(at).mm - tour.orifice - Number(text))), way: document.querySelector('#cues .way').getAttribute('d').length, bar: document.querySelector('#bar output').textContent};
  });
  assert.ok(told.numbers.length > 0 && told.numbers.every(mm => mm > 2.6), JSON.stringify(told));
  assert.ok(!told.overlap && Math.max(...told.off) < 0.5 && told.way > 20, JSON.stringify(told));
  assert.match(told.bar, /^Distal canal: 2\.6 of 1\d\.\d mm below the orifice, /);
});

test('three kinds of question by mouse and by keyboard; marks go out as CSV and JSON', async () => {
  await go(5);
  assert.ok(await page.evaluate(() => viewer.labels.muted), 'names would tell the answer');
  await page.getByRole('button', {name: 'pulp', exact: true}).focus();
  await page.keyboard.press('Enter');
  assert.match(await page.textContent('.question'), /Right\..*It is the pulp/s);
  assert.match(await page.evaluate(() => document.activeElement.textContent), /Next/);
  await page.keyboard.press('Enter');
  const wrong = await inWindow(await halfDown('mesiobuccal canal'));
  await page.mouse.click(wrong.x, wrong.y);
  assert.match(await page.textContent('.question'), /Not quite\. You: mesio(buccal|lingual) canal\. Right: distal canal/);
  await page.keyboard.press('n');
  await page.getByRole('textbox').fill('words');
  await page.keyboard.press('Enter');
  assert.match(await page.textContent('.question'), /Write a number/);
  await page.getByRole('textbox').fill('12,8');
  await page.keyboard.press('Enter');
  await page.keyboard.press('n');
  assert.match(await page.textContent('#lesson'), /2 of 3 right/);
  const save = async name => { const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', {name}).click()]); return readFileSync(await download.path(), 'utf8'); };
  const csv = (await save('Save CSV')).replace(/,\d+\.\d\n/g, ',S\n').replace(/mesio\w+ canal/, 'mesial');
  assert.equal(csv, "number,kind,question,given,right,seconds\n1,choice,Which tissue is under the pin?,pulp,yes,S\n2,click,Click the distal canal.,mesial,no,S\n3,number,'=How long?,12.8 mm,yes,S\n");
  const json = JSON.parse(await save('Save JSON'));
  assert.deepEqual([json.format, json.version, json.title, json.score, json.of, json.rows.map(row => row.right)], ['odontoscope.marks', 1, 'Three canals', 2, 3, [true, false, true]]);
});

test('a quiz of the model: its seed repeats it, and the model agrees with its own answers', async () => {
  const run = seed => page.evaluate(hash => { location.hash = hash; return new Promise(done => setTimeout(() => done(JSON.stringify(viewer.teaching.lesson.notes)), 0)); }, `#quiz=model&seed=${seed}`);
  const seven = await run(7), eight = await run(8);
  assert.notEqual(seven, eight);
  assert.equal(await run(7), seven);
  const kinds = new Set();
  for (const seed of [7, 8, 9]) {
    await run(seed);
    const told = await page.evaluate(() => viewer.teaching.lesson.notes.map((note, i) => {
      viewer.teaching.lesson.go(i);
      viewer.orbit.update(0);
      const {question, marks} = note, V = viewer.bounds.centre.constructor, seen = at => { viewer.camera.updateMatrixWorld(); const p = new V(...at).project(viewer.camera); return {x: p.x + 1e-4, y: p.y + 2e-4}; };   // a ray through a corner may slip between triangles
      if (question.kind === 'number') return [question.kind, question.answer > 0 && question.answer < 20];
      if (question.kind === 'choice' && viewer.tours.some(({name}) => question.choices.includes(name))) {
        const named = question.choices[question.answer];
        return ['canal', viewer.tours.find(({name}) => name === named).nearest(new V(...marks[0].at)).distance < 1e-3];
      }
      if (question.kind === 'choice') return ['structure', viewer.pointing.under(seen(marks[0].at))?.structures.includes(question.choices[question.answer])];
      if (!question.part) return ['click', true];
      const tour = viewer.tours.find(({name}) => name === question.part);
      const fromSomewhere = ['buccal', 'lingual', 'mesial', 'distal'].some(view => { viewer.look(view); return [0.5, 0.8].some(share => viewer.pointing.under(seen(tour.place(tour.orifice + share * (tour.length - tour.orifice)).toArray()))?.part === question.part); });
      return ['part', fromSomewhere];
    }));
    for (const [kind, right] of told) { kinds.add(kind); assert.ok(right, `seed ${seed}: ${JSON.stringify(told)}`); }
  }
  assert.ok(kinds.size >= 4, [...kinds].join(' '));
});

test('the cross answers a click by keyboard alone, and an exam tells nothing before its end', async () => {
  const two = await openedIn(chromium, made('exam.html'), {size, context}), exam = two.page;
  await quiet(two);
  await exam.getByRole('button', {name: 'enamel', exact: true}).click();
  assert.match(await exam.textContent('.question'), /You will be told at the end/);
  assert.ok(!/Right|\u2717/.test(await exam.textContent('.question')));
  await exam.keyboard.press('n');
  await exam.focus('#canvas');
  await exam.evaluate(() => { const tour = viewer.tours.find(({name}) => name === 'distal canal'), p = tour.place(0.6 * tour.length).project(viewer.camera); globalThis.goal = {x: p.x, y: p.y}; });
  for (let i = 0; i < 60; ++i) {
    const key = await exam.evaluate(() => {
      const {at} = viewer.pointing, x = goal.x - at.x, y = goal.y - at.y;
      if (Math.abs(y) > 0.05) return y > 0 ? 'ArrowUp' : 'ArrowDown';
      return viewer.pointing.under(at)?.part === 'distal canal' ? 'Enter' : x > 0 ? 'ArrowRight' : 'ArrowLeft';
    });
    await exam.keyboard.press(key === 'Enter' ? key : `Shift+${key}`);
    if (key === 'Enter') break;
  }
  assert.equal(await exam.evaluate(() => viewer.teaching.lesson.answers.get(1)?.right), true);
  await exam.keyboard.press('n');
  await exam.keyboard.press('n');
  assert.match(await exam.textContent('#lesson'), /1 of 3 right.*Wrong.*Right: pulp.*It is the pulp.*Not answered/s);
  await Promise.all([exam.waitForEvent('load'), exam.evaluate(() => { location.hash = '#step=3'; setTimeout(() => location.reload(), 0); })]);
  assert.equal(await exam.evaluate(async () => { await odontoscope; return document.querySelector('#lesson h2').textContent; }), 'Measure');   // the address opens the step
  assert.deepEqual(two.watched, []);
  await two.close();
});

test('the handout has a picture of every step, and paper has nothing else', async () => {
  await page.evaluate(() => { location.hash = '#handout'; return new Promise(done => setTimeout(done, 0)); });
  const sheet = await page.evaluate(() => ({pictures: [...document.querySelectorAll('#handout img')].map(img => img.src.length), words: document.getElementById('handout').textContent}));
  assert.equal(sheet.pictures.length, 7);
  assert.ok(Math.min(...sheet.pictures) > 3_000, sheet.pictures.join(' '));   // a plain one has 1,000
  assert.match(sheet.words, /Question 3\. =How long\?.*Answers.*pulp\. It is the pulp.*12\.5 mm/s);
  await page.emulateMedia({media: 'print'});
  assert.ok(!await page.locator('#panel').isVisible() && !await page.locator('#canvas').isVisible() && await page.locator('#handout h1').isVisible());
  await page.emulateMedia({media: 'screen'});
});

test('axe finds nothing on a step, an answered question, the marks and the handout', async () => {
  await page.evaluate(readFileSync(join(modules, 'axe-core/axe.min.js'), 'utf8'));
  const look = () => page.evaluate(async () => (await axe.run(document, {resultTypes: ['violations'], runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice']})).violations.map(v => `${v.id}: ${v.nodes.map(node => node.target.join(' ')).join(' | ')}`));
  assert.deepEqual(await look(), [], 'handout');
  await page.getByRole('button', {name: 'Back to the lesson'}).click();
  assert.equal((await state()).step, 1);
  for (const step of [1, 2, 5, 8]) {
    await go(step);
    if (step === 5) await page.getByRole('button', {name: 'enamel', exact: true}).click();
    assert.deepEqual(await look(), [], `step ${step}`);
  }
});

test('a lesson that brings its words in the language of the reader says them, and what has none stays', async () => {
  const two = await openedIn(chromium, made('embedded.html'), {size, context: {...context, locale: 'de-DE'}});
  await quiet(two);
  const told = await two.page.evaluate(() => { viewer.teaching.lesson.go(1); return [document.querySelector('.narration').textContent, viewer.teaching.lesson.language, viewer.teaching.lesson.notes.slice(0, 3).map(({title}) => title), viewer.teaching.lesson.notes[0].marks[0].label, document.querySelector('.steps').textContent]; });
  assert.deepEqual(told.slice(0, 4), [`Erz\u00e4hltext${hostile}`, 'de-AT', ['Der Zahn', 'Cut open', 'Inside'], 'Krone']);
  assert.equal(await two.page.evaluate(() => globalThis.bitten), undefined);
  assert.deepEqual(two.watched, []);
  await two.close();
});

test('a page around it is told, and no other', async t => {
  const file = readFileSync(made('embedded.html'));
  const server = createServer((request, answer) => {
    answer.setHeader('content-type', 'text/html');
    answer.end(request.url === '/lesson.html' ? file : '<script>globalThis.heard=[];addEventListener("message",e=>heard.push(e.data))</script><iframe id=f width=500 height=400></iframe>');
  }).listen(0, '127.0.0.1');
  t.after(() => { server.close(); server.closeAllConnections(); });   // or a failure would keep this script alive
  await new Promise(done => server.once('listening', done));
  const home = `http://127.0.0.1:${server.address().port}`, around = await (await chromium.newContext({reducedMotion: 'reduce'})).newPage();
  const heardIn = async hash => {
    await around.goto(`${home}/`);
    await around.evaluate(src => { document.getElementById('f').src = src; }, `/lesson.html${hash}`);
    const frame = await (await around.waitForSelector('#f')).contentFrame();
    await frame.waitForURL('**/lesson.html*');
    await frame.waitForFunction(() => globalThis.odontoscope);
    await frame.evaluate(async () => { globalThis.viewer = await odontoscope; viewer.renderer.setAnimationLoop(null); viewer.teaching.lesson.go(4); viewer.teaching.lesson.answer(0); });
    await around.evaluate(() => { frames[0].postMessage({source: 'odontoscope', ask: 'go', step: 8}, location.origin); return new Promise(done => setTimeout(done, 100)); });
    return around.evaluate(() => heard);
  };
  const heard = await heardIn('');
  assert.deepEqual(heard.map(({event, step}) => [event, step ?? 0]), [['ready', 0], ['step', 1], ['step', 5], ['answer', 5], ['step', 8], ['done', 0]]);
  assert.deepEqual([heard[3].right, heard[3].given, heard[5].score], [false, 'enamel', {right: 0, of: 3}]);
  assert.deepEqual(await heardIn('#parent=https://elsewhere.example'), []);
});

test('all that asked the network for nothing and complained of nothing', () => assert.deepEqual(one.watched, []));

test('Chromium alone makes a PDF of the handout, as docs/web.md says', () => {
  execFileSync(process.env.ODONTOSCOPE_CHROMIUM, ['--headless', '--no-sandbox', '--virtual-time-budget=60000', '--no-pdf-header-footer', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    `--print-to-pdf=${made('handout.pdf')}`, `file://${made('embedded.html')}#handout`], {stdio: 'ignore', timeout: 120_000});
  const pdf = readFileSync(made('handout.pdf')).toString('latin1');
  assert.ok(pdf.startsWith('%PDF-'));
  assert.ok((pdf.match(/\/Type\s*\/Page\b/g) ?? []).length >= 5, 'a page for a step or two, and the answers');
  assert.ok((pdf.match(/\/Subtype\s*\/Image\b/g) ?? []).length >= 3, 'pictures of the steps, those that are alike once');
});
