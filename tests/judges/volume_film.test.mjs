// X-ray films in the page: of a model against rays through every triangle, of a volume against the desktop's; their
// edge and beam, and what is measured on them.
import assert from 'node:assert/strict';
import {after, test} from 'node:test';
import {browser, made, needPackages, odontoscope, openedIn, pageOrSkip} from './support.mjs';
import {compared, giveSeen, writeVolume} from './volume_scene.mjs';

needPackages();
writeVolume('ct.nrrd');
pageOrSkip('ct.nrrd', '--iso', '100', '-o', 'model.html');
odontoscope('web', 'ct.nrrd', '--iso', '100', '--show', 'both', '-o', 'both.html');

const chromium = await browser();
after(() => chromium.close());

/// Gives a page rayThroughModel(n): the nth of rays strewn over the middle of the picture, by its pixel, where it
/// begins and its way, and all its hits on the first model, [distance, 1 where it enters and -1 where it leaves]. Every
/// triangle is asked. The camera's matrices are to be up to date.
const giveRays = page =>
  page.evaluate(() => {
    window.rayThroughModel = n => {
      const {width, height} = viewer.canvas,
        camera = viewer.camera,
        V = viewer.bounds.centre.constructor,
        hits = [];
      const x = Math.floor(width * (0.35 + 0.3 * ((0.5 + n * 0.7548776662) % 1))),
        y = Math.floor(height * ((0.5 + n * 0.569840291) % 1));
      const at = [(2 * (x + 0.5)) / width - 1, (2 * (y + 0.5)) / height - 1],
        begin = new V(...at, -1).unproject(camera);
      const way = new V(...at, 1).unproject(camera).sub(begin).normalize();
      for (const {geometry} of viewer.models[0].parts) {
        const p = geometry.attributes.position,
          index = geometry.index.array,
          [a, u, v, s] = [0, 0, 0, 0].map(() => new V());
        for (let i = 0; i < index.length; i += 3) {
          a.fromBufferAttribute(p, index[i]);
          u.fromBufferAttribute(p, index[i + 1]).sub(a);
          v.fromBufferAttribute(p, index[i + 2]).sub(a);
          s.copy(begin).sub(a);
          const det = u.dot(new V().crossVectors(way, v)),
            q = new V().crossVectors(s, u),
            b = s.dot(new V().crossVectors(way, v)) / det,
            c = way.dot(q) / det;
          if (b >= 0 && c >= 0 && b + c <= 1) hits.push([v.dot(q) / det, Math.sign(det)]);
        }
      }
      return {x, y, begin, way, hits};
    };
  });

for (const beam of ['cone', 'parallel'])
  test(`the film of a model is the length of each ray inside it, times what its tissue swallows: ${beam} beam`, async () => {
    const {page, watched, close} = await openedIn(chromium, made('model.html'), {size: {width: 560, height: 200}});
    await giveRays(page);
    const judged = await page.evaluate(beam => {
      viewer.renderer.setAnimationLoop(null);
      viewer.setFilm(true);
      viewer.setBeam(beam);
      viewer.swingTube(20);
      viewer.orbit.update(0);
      const {width, height} = viewer.canvas,
        camera = viewer.camera,
        gl = viewer.renderer.getContext();
      viewer.draw();
      const sums = new Float32Array(4 * width * height);
      viewer.renderer.setRenderTarget(viewer.shadow.sums);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, sums);
      viewer.renderer.setRenderTarget(null);
      camera.updateMatrixWorld();
      const judged = {worst: 0, most: 0, rays: 0},
        mu = viewer.looks.get('tooth').attenuation;
      for (let n = 0; n < 60; ++n) {
        const {x, y, hits} = rayThroughModel(n);
        let sum = 0;
        for (const [distance, sign] of hits) sum -= sign * distance;
        judged.rays += 1;
        judged.most = Math.max(judged.most, mu * sum);
        judged.worst = Math.max(judged.worst, Math.abs(mu * sum - sums[4 * (y * width + x)]));
      }
      return {...judged, parallel: camera.isOrthographicCamera ?? false};
    }, beam);
    assert.equal(judged.parallel, beam === 'parallel');
    assert.ok(judged.most > 0.5, JSON.stringify(judged));
    assert.ok(judged.worst < 4 / 255, JSON.stringify(judged)); // one level of a film that shows an attenuation of 4 white
    assert.deepEqual(watched, []);
    await close();
  });

test('the film is cut by a section: rays count only where they run through what is left', async () => {
  const {page, watched, close} = await openedIn(chromium, made('model.html'), {size: {width: 560, height: 200}});
  await giveRays(page);
  for (const [side, beam] of [
    ['mesial', 'cone'],
    ['buccal', 'parallel'],
    ['buccal', 'cone'],
    ['occlusal', 'cone'],
  ]) {
    const judged = await page.evaluate(
      ([side, beam]) => {
        viewer.renderer.setAnimationLoop(null);
        viewer.setFilm(true);
        viewer.setBeam(beam);
        viewer.cut({on: true, side, at: 0.3});
        viewer.swingTube(20);
        viewer.orbit.update(0);
        const {width, height} = viewer.canvas,
          camera = viewer.camera,
          V = viewer.bounds.centre.constructor,
          gl = viewer.renderer.getContext(),
          light = new Float32Array(4 * width * height);
        viewer.picture.draw(viewer.scene, camera, viewer.current, {
          ...viewer.wayOf({layers: true, shade: false}),
          complete: true,
        });
        viewer.renderer.setRenderTarget(viewer.picture.layers.sum);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, light);
        viewer.renderer.setRenderTarget(null);
        camera.updateMatrixWorld();
        const shown = l => {
          const soft = l > 0.78 ? 0.78 + 0.22 * (1 - Math.exp(-(l - 0.78) / 0.22)) : l;
          return soft <= 0.0031308 ? 12.92 * soft : 1.055 * soft ** (1 / 2.4) - 0.055;
        };
        const plane = viewer.section.plane(),
          judged = {worst: 0, most: 0, cut: 0},
          mu = viewer.looks.get('tooth').attenuation;
        for (let n = 0; n < 80; ++n) {
          const {x, y, begin, way, hits} = rayThroughModel(n);
          hits.sort(([a], [b]) => a - b);
          const normal = new V(plane.x, plane.y, plane.z),
            speed = normal.dot(way),
            pass = (plane.w - normal.dot(begin)) / speed;
          const kept = (from, to) =>
            speed > 0 ? Math.max(0, Math.min(to, pass) - from) : Math.max(0, to - Math.max(from, pass));
          let sum = 0,
            whole = 0;
          for (let i = 0, depth = 0; i + 1 < hits.length; ++i) {
            depth += hits[i][1];
            if (depth > 0) {
              sum += kept(hits[i][0], hits[i + 1][0]);
              whole += hits[i + 1][0] - hits[i][0];
            }
          }
          judged.cut += whole - sum > 0.2 && sum > 0.2 ? 1 : 0;
          judged.most = Math.max(judged.most, mu * sum);
          judged.worst = Math.max(
            judged.worst,
            Math.abs(mu * sum - viewer.shadow.latitude * shown(light[4 * (y * width + x)])),
          );
        }
        return judged;
      },
      [side, beam],
    );
    assert.ok(judged.cut > 3 || side === 'occlusal', JSON.stringify({side, ...judged})); // nearly along the rays
    assert.ok(judged.worst < 8 / 255, JSON.stringify({side, ...judged})); // two levels: the film is kept in halves of floats
  }
  assert.deepEqual(watched, []);
  await close();
});

test('beside the film stand the canals\u2019 lengths on it and their own', async () => {
  odontoscope('web', '-o', 'molar.html');
  const {page, watched, close} = await openedIn(chromium, made('molar.html'), {size: {width: 560, height: 400}});
  const told = await page.evaluate(() => {
    viewer.renderer.setAnimationLoop(null);
    viewer.setFilm(true);
    return [
      [0, 'cone'],
      [35, 'cone'],
      [35, 'parallel'],
    ].map(([degrees, beam]) => {
      viewer.setBeam(beam);
      viewer.swingTube(degrees);
      viewer.orbit.update(0);
      viewer.draw();
      const {
          camera,
          bounds: {centre},
        } = viewer,
        V = centre.constructor;
      camera.updateMatrixWorld();
      // On the screen: how many parts of the picture's height, and how many millimetres these are at the middle of the
      // tooth.
      const depth = -centre.clone().applyMatrix4(camera.matrixWorldInverse).z,
        tall = 2 * depth * Math.tan((viewer.orbit.camera.fov * Math.PI) / 360),
        {aspect} = viewer.orbit.camera;
      const rows = [...document.querySelectorAll('#film-lengths tbody tr')].map(row =>
        [...row.children].map(cell => cell.textContent),
      );
      return viewer.description.tours.map((tour, index) => {
        const places = tour.points_mm
          .map(point => new V(...point).project(camera))
          .map(({x, y}) => [0.5 * x * aspect * tall, 0.5 * y * tall]);
        const film = places
          .slice(1)
          .reduce((sum, [x, y], i) => sum + Math.hypot(x - places[i][0], y - places[i][1]), 0);
        const own = tour.points_mm
          .slice(1)
          .reduce((sum, point, i) => sum + new V(...point).distanceTo(new V(...tour.points_mm[i])), 0);
        return {film, own, row: rows[index]};
      });
    });
  });
  for (const {film, own, row} of told.flat()) {
    assert.ok(Math.abs(parseFloat(row[1]) - film) < 0.11, JSON.stringify({film, own, row}));
    assert.ok(Math.abs(parseFloat(row[2]) - own) < 0.11, JSON.stringify({film, own, row}));
  }
  assert.ok(
    told[0].length >= 3 && told[0].some(({film}, i) => Math.abs(film - told[1][i].film) > 0.1),
    'swinging the tube changes what the film shows',
  );
  assert.ok(
    told[1].some(({row}, i) => row[1] !== told[2][i].row[1]),
    'a cone enlarges what is nearer to it',
  );
  assert.deepEqual(watched, []);
  await close();
});

test('two places of the film are measured where they are clicked; a film has an edge, and a negative', async () => {
  const {page, watched, close} = await openedIn(chromium, made('model.html'), {size: {width: 900, height: 700}});
  await page.evaluate(() => {
    viewer.setFilm(true);
    viewer.swingTube(10);
    document.getElementById('film-ruler').click();
  });
  await page.waitForFunction(() => viewer.picture.finished(viewer.wayOf(viewer.quality.still)));
  const box = await page.locator('canvas').first().boundingBox(),
    middle = [box.x + 0.5 * box.width, box.y + 0.5 * box.height];
  await page.mouse.click(middle[0] - 60, middle[1] + 20);
  await page.mouse.click(middle[0] + 40, middle[1] - 55);
  const {words, right} = await page.evaluate(
    ([across, down]) => {
      const {
          camera,
          bounds: {centre},
          canvas,
        } = viewer,
        depth = -centre.clone().applyMatrix4(camera.matrixWorldInverse).z;
      return {
        words: document.getElementById('pins').textContent,
        right: (Math.hypot(across, down) * 2 * depth * Math.tan((camera.fov * Math.PI) / 360)) / canvas.clientHeight,
      };
    },
    [100, 75],
  );
  assert.match(words, /^[0-9.]+ mm on the film$/);
  assert.ok(Math.abs(parseFloat(words) - right) < 0.06, JSON.stringify({words, right}));
  const turned = await page.evaluate(() => {
    viewer.swingTube(25);
    viewer.draw();
    return document.getElementById('pins').textContent;
  });
  assert.equal(turned, '', 'another film has other places');
  // The film's own sheet, drawn to a target of eight bits: the usual one, a negative, and one with an edge.
  const shown = await page.evaluate(() => {
    viewer.renderer.setAnimationLoop(null);
    const {shadow, renderer, camera, section, canvas} = viewer,
      gl = renderer.getContext(),
      {width, height} = canvas,
      target = shadow.sums.clone();
    target.setSize(width, height);
    const seen = () => {
      renderer.setRenderTarget(target);
      renderer.clear(true, false, false);
      shadow.drawProjection(
        {
          camera,
          pixels: new shadow.film.uniforms.pixels.value.constructor(width, height),
          section: section.plane() ?? shadow.film.uniforms.section.value.clone().set(0, 0, 0, 1),
        },
        target,
      );
      const light = new Float32Array(4 * width * height);
      renderer.setRenderTarget(target);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, light);
      renderer.setRenderTarget(null);
      return [
        [0.5, 0.5],
        [0.02, 0.5],
      ].map(([x, y]) => light[4 * (Math.floor(y * height) * width + Math.floor(x * width))]);
    };
    const usual = seen();
    shadow.inverted = true;
    const negative = seen();
    shadow.inverted = false;
    shadow.film_mm = [4, 4];
    return {usual, negative, edged: seen()};
  });
  assert.ok(shown.usual[0] > 0.02 && shown.usual[1] < 0.001, JSON.stringify(shown)); // the tooth, and nothing in the way
  assert.ok(shown.negative[1] > 0.9 && shown.negative[0] < shown.negative[1], JSON.stringify(shown));
  assert.ok(
    Math.abs(shown.edged[0] - shown.usual[0]) < 1e-3 &&
      Math.abs(shown.edged[1] - ((0.16 + 0.055) / 1.055) ** 2.4) < 1e-3,
    JSON.stringify(shown),
  );
  assert.deepEqual(watched, []);
  await close();
});

/// How far the film reaches in the picture's middle row and column: from the first to the last pixel that is not of the one
/// grey beside it; in millimetres, too, as it hangs at the middle of the model.
const edges = page =>
  page.evaluate(() => {
    const {width, height, shown} = seen(), column = Math.floor(width / 2), row = Math.floor(height / 2);
    const beside = (x, y) => Math.abs(shown[4 * (y * width + x)] - 0.16 * 255) < 0.6;
    const reach = (count, isBeside) => {
      const within = [...Array(count).keys()].filter(i => !isBeside(i));
      return within.at(-1) - within[0] + 1;
    };
    const across = reach(width, x => beside(x, row)), up = reach(height, y => beside(column, y));
    const {orbit, bounds} = viewer, distance = orbit.camera.position.distanceTo(bounds.centre);
    const pixel = (2 * distance * Math.tan((orbit.camera.fov * Math.PI) / 360)) / height;
    return {mm: [across * pixel, up * pixel], corner: beside(3, 3), whole: across === width && up === height};
  });

const isOf = ({mm: [across, up], corner}, [width, height]) =>
  corner && Math.abs(across - width) < 0.3 && Math.abs(up - height) < 0.3;

for (const name of ['model.html', 'both.html'])
  test(`the panel has the usual films, upright and across, and both beams: ${name}`, async () => {
    const {page, watched, close} = await openedIn(chromium, made(name), {size: {width: 900, height: 700}});
    await giveSeen(page);
    if (name === 'model.html') await page.locator('#film').click();
    else await page.getByRole('button', {name: 'X-ray'}).click();
    assert.ok((await edges(page)).whole, 'no edge at first');
    const size = page.locator('#film-size'),
      sizes = {0: [22, 35], 1: [24, 40], 2: [31, 41], 3: [27, 54], 4: [57, 76]};
    for (const [words, mm] of Object.entries(sizes)) {
      await size.getByRole('button', {name: words, exact: true}).click();
      assert.deepEqual(await page.evaluate(() => viewer.filmLook.film_mm), mm);
      const film = await edges(page);
      assert.ok(isOf(film, mm), JSON.stringify({...film, right: mm}));
    }
    await size.getByRole('button', {name: '0', exact: true}).click();
    await page.locator('#film-across').click();
    const across = await edges(page);
    assert.ok(isOf(across, [35, 22]), JSON.stringify(across));
    await size.getByRole('button', {name: 'No edge'}).click();
    const cone = await page.evaluate(() => seen().shown);
    await page.getByRole('button', {name: 'Parallel beam'}).click();
    const parallel = await page.evaluate(() => ({
      shown: seen().shown,
      parallel: viewer.camera.isOrthographicCamera ?? false,
    }));
    assert.ok(parallel.parallel);
    const differ = parallel.shown.filter((value, i) => Math.abs(value - cone[i]) > 8).length;
    assert.ok(differ > 0.01 * cone.length, `${differ} of ${cone.length} values differ`);
    assert.deepEqual(watched, []);
    await close();
  });

test('the film of the volume is the desktop\u2019s within two levels, with its edge, by either beam, and as a negative', async () => {
  const {page, watched, close} = await openedIn(chromium, made('both.html'), {size: {width: 560, height: 200}});
  await giveSeen(page);
  const look = {shows: 'volume', cast: 'radiograph', window: [40, 160], attenuation: 0.23, latitude: 2};
  for (const beam of ['cone', 'parallel'])
    for (const change of [
      {film_mm: [5.3, 6.7]},
      {film_mm: [9.3, 5.1], inverted: true},
      {film_mm: [0, 0], inverted: true},
    ]) {
      const judged = await compared(page, 'ct.nrrd', {beam, volume: {...look, inverted: false, ...change}});
      assert.ok(judged.lit > 4000, JSON.stringify({beam, ...change, ...judged}));
      assert.ok(judged.off <= 4, JSON.stringify({beam, ...change, ...judged})); // on the film's corners
    }
  assert.deepEqual(watched, []);
  await close();
});
