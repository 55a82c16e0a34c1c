// What a person sees of a model today with back faces culled, in other people's viewers: no hole in DT, many in DB with the table that does not turn
// complements over. A hole is a pixel that the surface covers when both its sides are drawn, and does not when only its front is.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {browser, bytesOf, glbOf, glbParts, made, modules, needPackages, odontoscope, packageNamed} from './support.mjs';

needPackages();
const cameras = 20, size = 128;
const chromium = await browser();
after(() => chromium.close());

odontoscope('sample', 'molar', '--slice-spacing', '0.35', '--point-spacing', '0.35', '-o', 'molar.json');
for (const ending of ['glb', 'wrl']) {
  odontoscope('reconstruct', 'molar.json', '-o', `dt.${ending}`);
  odontoscope('reconstruct', 'molar.json', '--method', 'db', '--grid', '32', '--cases', 'classic-unoriented', '-o', `db.${ending}`);
}

/// The same model, drawn from both sides.
function twoSided(glb) {
  const parts = glbParts(glb);
  for (const material of parts.json.materials) material.doubleSided = true;
  return glbOf(parts);
}

function flipped(glb, share) {
  const {json, binary} = glbParts(glb), changed = binary.slice(), view = new DataView(changed.buffer);
  for (const mesh of json.meshes) {
    const accessor = json.accessors[mesh.primitives[0].indices], from = json.bufferViews[accessor.bufferView].byteOffset ?? 0;
    for (let t = 0; t < accessor.count / 3; t += Math.round(1 / share)) {
      const a = view.getUint32(from + 12 * t, true), b = view.getUint32(from + 12 * t + 4, true);
      view.setUint32(from + 12 * t, b, true);
      view.setUint32(from + 12 * t + 4, a, true);
    }
  }
  return glbOf({json, binary: changed});
}

/// The same model with a pulp of pure blue: where its picture differs, the pulp is seen.
function bluePulp(glb) {
  const parts = glbParts(glb);
  for (const {name, pbrMetallicRoughness} of parts.json.materials) if (name === 'pulp') pbrMetallicRoughness.baseColorFactor = [0, 0, 1, 1];
  return glbOf(parts);
}
const pulpSeen = (one, other) => one.reduce((count, value, i) => count + (Math.abs(value - other[i]) > 12), 0);

/// Directions spread over the ball.
const directions = Array.from({length: cameras}, (_, i) => {
  const z = 1 - 2 * (i + 0.5) / cameras, turn = i * Math.PI * (3 - Math.sqrt(5)), r = Math.sqrt(1 - z * z);
  return [r * Math.cos(turn), z, r * Math.sin(turn)];
});

odontoscope('reconstruct', 'molar.json', '--see-through', '-o', 'clear.glb');
const pulps = {opaque: {red: bytesOf('dt.glb'), blue: bluePulp(bytesOf('dt.glb'))}, clear: {red: bytesOf('clear.glb'), blue: bluePulp(bytesOf('clear.glb'))}};

/// Is the pulp seen only where it is to be? `channel(url)` draws, and gives one colour's pixels.
async function judgePulp(viewer, channel) {
  const seen = {};
  for (const name of ['opaque', 'clear']) seen[name] = pulpSeen(await channel(`${name}/red.glb`), await channel(`${name}/blue.glb`));
  console.log(`${viewer}: the pulp is seen in ${seen.clear} pixels with --see-through, in ${seen.opaque} without`);
  assert.equal(seen.opaque, 0);
  assert.ok(seen.clear > 0.02 * size * size, `${viewer}: ${seen.clear} pixels of pulp`);
}

/// A page that may load the given files, and nothing else.
async function pageWith(files) {
  const page = await chromium.newPage({viewport: {width: size, height: size}, deviceScaleFactor: 1});
  const failures = [];
  page.on('pageerror', error => failures.push(error.message));
  await page.route('**/*', route => {
    const path = new URL(route.request().url()).pathname.slice(1), body = files(path);
    if (body === undefined) return route.fulfill({status: 404});
    const type = {html: 'text/html', js: 'text/javascript', mjs: 'text/javascript', css: 'text/css', glb: 'model/gltf-binary', gltf: 'model/gltf+json', wrl: 'model/vrml'}[path.split('.').pop()];
    return route.fulfill({body: typeof body === 'string' ? body : Buffer.from(body), contentType: type ?? 'application/octet-stream'});
  });
  return {page, failures};
}

const models = name => {
  const glb = bytesOf(`${name}.glb`);
  return {front: glb, both: twoSided(glb)};
};

/// From two pictures' opacities, how many pixels are covered, and how many of them are holes.
function compared(both, front) {
  let covered = 0, holes = 0;
  for (let i = 0; i < both.length; ++i) {
    if (both[i] < 250) continue;
    covered += 1;
    if (front[i] < 128) holes += 1;
  }
  return {covered, holes};
}

function judge(viewer, results) {
  for (const [name, {covered}] of Object.entries(results)) assert.ok(covered > 0.05 * cameras * size * size, `${viewer} drew ${covered} pixels of ${name}`);
  console.log(`${viewer}: ${Object.entries(results).map(([name, {covered, holes}]) => `${name} ${holes} holes in ${covered} pixels`).join('; ')}`);
  assert.equal(results.DT.holes, 0, `${viewer}: holes in DT`);
  assert.ok(results.DB.holes > 0.02 * results.DB.covered, `${viewer}: hardly a hole in DB`);
  if (results.mutant) assert.ok(results.mutant.holes > 0.002 * results.mutant.covered, `${viewer}: a DT model with flipped triangles passes`);
}

/// Sums over all cameras; `opacities(direction, which)` draws.
async function seen(opacities) {
  const sum = {covered: 0, holes: 0};
  for (const direction of directions) {
    const one = compared(await opacities(direction, 'both'), await opacities(direction, 'front'));
    sum.covered += one.covered;
    sum.holes += one.holes;
  }
  return sum;
}

test('three.js', {timeout: 240_000}, async () => {
  const script = `import {AmbientLight, Box3, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three';
    import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
    import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';
    const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
    // A mesh's triangles with places and normals, each from its least corner on, in no order: the same surface gives the same text.
    globalThis.triangles = async url => {
      const meshes = {};
      (await loader.loadAsync(url)).scene.traverse(({isMesh, name, geometry}) => {
        if (!isMesh) return;
        const {position, normal} = geometry.attributes, corner = v => [position, normal].map(({array}) => array.slice(3 * v, 3 * v + 3).join()).join(' ');
        meshes[name] = Array.from({length: geometry.index.count / 3}, (_, t) => {
          const corners = [0, 1, 2].map(k => corner(geometry.index.getX(3 * t + k))), first = corners.indexOf([...corners].sort()[0]);
          return [0, 1, 2].map(k => corners[(first + k) % 3]).join(';');
        }).sort().join('|');
      });
      return meshes;
    };
    globalThis.alike = async (one, other) => {
      const [a, b] = [await triangles(one), await triangles(other)];
      return Object.keys(a).join() === Object.keys(b).join() && Object.keys(a).every(name => a[name].length > 1000 && a[name] === b[name]);
    };
    const renderer = new WebGLRenderer({alpha: true, antialias: false, preserveDrawingBuffer: true});
    renderer.setSize(${size}, ${size});
    globalThis.blues = async url => {
      await load(url);
      scene.add(new AmbientLight(0xffffff, 2));
      opacities([0, 0, -1]);
      const gl = renderer.getContext(), pixels = new Uint8Array(${4 * size * size});
      gl.readPixels(0, 0, ${size}, ${size}, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return btoa(String.fromCharCode(...pixels.filter((_, i) => i % 4 === 2)));
    };
    globalThis.load = async url => {
      globalThis.scene = new Scene();
      scene.add((await loader.loadAsync(url)).scene);
      scene.traverse(node => { if (node.isMesh) node.material = node.material.clone(); });
      const box = new Box3().setFromObject(scene);
      globalThis.middle = box.getCenter(new Vector3());
      globalThis.radius = 0.5 * box.getSize(new Vector3()).length();
    };
    globalThis.opacities = direction => {
      const camera = new PerspectiveCamera(30, 1, 0.1 * radius, 10 * radius);
      camera.position.copy(middle).addScaledVector(new Vector3(...direction), 4 * radius);
      camera.lookAt(middle);
      renderer.render(scene, camera);
      const gl = renderer.getContext(), pixels = new Uint8Array(${4 * size * size});
      gl.readPixels(0, 0, ${size}, ${size}, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return btoa(String.fromCharCode(...pixels.filter((_, i) => i % 4 === 3)));
    };`;
  writeFileSync(made('three.mjs'), script);
  await packageNamed('esbuild').build({entryPoints: [made('three.mjs')], bundle: true, format: 'iife', outfile: made('three.js'), nodePaths: [modules], logLevel: 'error'});
  odontoscope('reconstruct', 'molar.json', '--compress', '-o', 'compressed.glb');
  const given = {DT: models('dt'), compressed: models('compressed'), DB: models('db'), mutant: {front: flipped(bytesOf('dt.glb'), 0.1), both: twoSided(bytesOf('dt.glb'))}};
  const {page, failures} = await pageWith(path => {
    const [name, which] = path.replace('.glb', '').split('/');
    return path === 'index.html' ? '<!DOCTYPE html><script src="three.js"></script>' : path === 'three.js' ? readFileSync(made('three.js')) : (given[name] ?? pulps[name])?.[which];
  });
  await page.goto('http://judge.test/index.html');
  const results = {};
  for (const name of Object.keys(given)) {
    const drawn = {};
    for (const which of ['both', 'front']) {
      await page.evaluate(url => load(url), `${name}/${which}.glb`);
      drawn[which] = (await page.evaluate(all => all.map(one => opacities(one)), directions)).map(text => Buffer.from(text, 'base64'));
    }
    results[name] = await seen(async (direction, which) => drawn[which][directions.indexOf(direction)]);
  }
  assert.ok(await page.evaluate(() => alike('DT/front.glb', 'compressed/front.glb')), 'compression changed places, normals or windings');
  assert.ok(!await page.evaluate(() => alike('DT/front.glb', 'mutant/front.glb')), 'flipped triangles pass for the same');
  await judgePulp('three.js', async url => Buffer.from(await page.evaluate(one => blues(one), url), 'base64'));
  assert.deepEqual(failures, []);
  judge('three.js', results);
  assert.equal(results.compressed.holes, 0, 'holes in the compressed DT');
  await page.close();
});

// What a player of the file sees from within, by the file's own cameras: the wall, in green here, and nothing else. The body of pulp is hidden, as in our
// own films; its surface keeps a little off the wall and would show in folds.
test('three.js plays the tours', {timeout: 240_000}, async () => {
  const script = `import {AnimationMixer, Color, LoopOnce, MeshBasicMaterial, Scene, Vector3, WebGLRenderer} from 'three';
    import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
    import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';
    const renderer = new WebGLRenderer({antialias: false, preserveDrawingBuffer: true});
    renderer.setSize(${size}, ${size});
    globalThis.load = async url => {
      globalThis.file = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync(url);
      globalThis.scene = new Scene();
      scene.background = new Color(0, 0, 1);
      scene.add(file.scene);
      scene.traverse(node => {
        node.visible = !node.name.startsWith('pulp');
        if (node.isMesh) node.material = new MeshBasicMaterial({side: node.material.side, color: node.name.endsWith('cavity') ? 0x00ff00 : 0xff0000});
      });
      return file.animations.map(({name, duration}) => ({name, duration}));
    };
    globalThis.play = (name, share) => {
      const clip = file.animations.find(clip => clip.name === name), mixer = new AnimationMixer(file.scene);
      const action = mixer.clipAction(clip).setLoop(LoopOnce).play();
      action.clampWhenFinished = true;
      mixer.setTime(share * clip.duration);
      scene.updateMatrixWorld(true);
      const camera = file.cameras.find(camera => camera.name === clip.tracks[0].name.split('.')[0]);
      camera.aspect = 1;
      camera.updateProjectionMatrix();
      renderer.render(scene, camera);
      const place = camera.getWorldPosition(new Vector3()).toArray();
      const gl = renderer.getContext(), pixels = new Uint8Array(${4 * size * size});
      gl.readPixels(0, 0, ${size}, ${size}, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      let wall = 0;
      for (let i = 0; i < pixels.length; i += 4) wall += pixels[i] === 0 && pixels[i + 1] === 255 && pixels[i + 2] === 0;
      mixer.uncacheRoot(file.scene);   // which puts the camera back
      return {wall, place};
    };`;
  writeFileSync(made('tours.mjs'), script);
  await packageNamed('esbuild').build({entryPoints: [made('tours.mjs')], bundle: true, format: 'iife', outfile: made('tours.js'), nodePaths: [modules], logLevel: 'error'});
  odontoscope('sample', 'molar', '-o', 'fine.json');
  odontoscope('reconstruct', 'fine.json', '--tours', '-o', 'tours.glb', '-o', 'tours.gltf');
  odontoscope('reconstruct', 'fine.json', '--tours', '--compress', '-o', 'tours-compressed.glb');
  const facing = bytesOf('tours.glb'), strayed = glbParts(facing), view = new DataView((strayed.binary = strayed.binary.slice()).buffer);
  for (const {samplers, channels} of strayed.json.animations) {   // turned about: what the camera is led along is mirrored
    const {output} = samplers[channels.find(({target}) => target.path === 'translation').sampler], {bufferView, count} = strayed.json.accessors[output];
    const from = strayed.json.bufferViews[bufferView].byteOffset;
    for (let i = 0; i < 3 * count; i += 3) view.setFloat32(from + 4 * i, -view.getFloat32(from + 4 * i, true), true);
  }
  const given = {'tours.glb': facing, 'tours.gltf': readFileSync(made('tours.gltf')), 'tours-compressed.glb': bytesOf('tours-compressed.glb'), 'flipped.glb': flipped(facing, 0.1), 'strayed.glb': glbOf(strayed)};
  const {page, failures} = await pageWith(path => path === 'index.html' ? '<!DOCTYPE html><script src="tours.js"></script>' : path === 'tours.js' ? readFileSync(made('tours.js')) : given[path]);
  await page.goto('http://judge.test/index.html');
  const seen = {};
  for (const name of Object.keys(given)) {
    const clips = await page.evaluate(url => load(url), name), [pixels, places] = [[], []];
    assert.equal(clips.length, 3, 'one animation for each canal');
    for (const clip of clips) {
      assert.ok(clip.duration > 5, `${clip.name} takes ${clip.duration} s`);
      for (const share of [0, 0.1, 0.25, 0.4, 0.6, 0.8, 0.95, 1]) {
        const {wall, place} = await page.evaluate(([name, share]) => play(name, share), [clip.name, share]);
        pixels.push(size * size - wall);
        places.push(place);
      }
      // In metres, +y up: down from the chamber by some millimetres.
      const [start, end] = [places.at(-8), places.at(-1)];
      assert.ok(start[1] - end[1] > 0.005 && start[1] - end[1] < 0.02, `${clip.name} leads from ${start} to ${end}`);
    }
    seen[name] = pixels.reduce((sum, one) => sum + one, 0);
  }
  console.log(`three.js from within: ${Object.entries(seen).map(([name, others]) => `${name} ${others} pixels that are no wall`).join('; ')}`);
  assert.deepEqual(failures, []);
  assert.equal(seen['tours.glb'], 0);
  assert.equal(seen['tours.gltf'], 0);
  assert.equal(seen['tours-compressed.glb'], 0);
  assert.ok(seen['flipped.glb'] > 100 && seen['strayed.glb'] > 100, 'mutants pass');
  await page.close();
});

/// The opacities of a picture that the page's viewer gives as a data address.
const decodeInPage = `globalThis.decoded = async picture => {
  const image = await createImageBitmap(await (await fetch(picture)).blob()), canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  return btoa(String.fromCharCode(...context.getImageData(0, 0, image.width, image.height).data.filter((_, i) => i % 4 === 3)));
}`;

test('model-viewer', {timeout: 240_000}, async () => {
  const given = {DT: models('dt'), DB: models('db')};
  const html = `<!DOCTYPE html><style>body{margin:0}model-viewer{width:${size}px;height:${size}px}</style><script>${decodeInPage}</script>
    <script type="module" src="model-viewer.js"></script><model-viewer interaction-prompt="none" camera-target="auto auto auto" min-camera-orbit="auto 0deg auto" max-camera-orbit="auto 180deg auto"></model-viewer>`;
  const {page, failures} = await pageWith(path => {
    const [name, which] = path.replace('.glb', '').split('/');
    if (path === 'index.html') return html;
    return path === 'model-viewer.js' ? readFileSync(join(modules, '@google/model-viewer/dist/model-viewer.min.js')) : given[name]?.[which];
  });
  await page.goto('http://judge.test/index.html');
  // A sky of a few grey pixels: its own takes software a quarter of a minute to prepare.
  await page.evaluate(() => {
    const sky = document.createElement('canvas');
    Object.assign(sky, {width: 64, height: 32});
    sky.getContext('2d').fillStyle = '#ccc';
    sky.getContext('2d').fillRect(0, 0, 64, 32);
    document.querySelector('model-viewer').environmentImage = sky.toDataURL();
  });
  const show = file => page.evaluate(async url => {
    const viewer = document.querySelector('model-viewer'), loaded = new Promise((done, failed) => {
      viewer.addEventListener('load', done, {once: true});
      viewer.addEventListener('error', event => failed(new Error(event.detail?.type)), {once: true});
    });
    viewer.src = url;
    await loaded;
  }, file);
  const results = {};
  for (const name of Object.keys(given)) {
    const drawn = {};
    for (const which of ['both', 'front']) {
      await show(`${name}/${which}.glb`);
      drawn[which] = (await page.evaluate(async all => {
        const viewer = document.querySelector('model-viewer'), pictures = [];
        for (const [x, y, z] of all) {
          viewer.cameraOrbit = `${Math.atan2(x, z)}rad ${Math.acos(y)}rad 105%`;
          await viewer.updateComplete;
          viewer.jumpCameraToGoal();
          await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
          pictures.push(await decoded(viewer.toDataURL('image/png')));
        }
        return pictures;
      }, directions)).map(text => Buffer.from(text, 'base64'));
    }
    results[name] = await seen(async (direction, which) => drawn[which][directions.indexOf(direction)]);
  }
  assert.deepEqual(failures, []);
  judge('model-viewer', results);
  await page.close();
});

/// The same with a background of pure green in place of none.
const notGreenInPage = decodeInPage.replace('decoded', 'notGreen')
  .replace('.data.filter((_, i) => i % 4 === 3)', ".data.reduce((all, _, i, data) => { if (i % 4 === 0) all.push(data[i] < 8 && data[i + 1] > 247 && data[i + 2] < 8 ? 0 : 255); return all; }, [])");

/// A viewpoint of VRML: its place, and the turn from looking along -z as axis and angle.
function lookingFrom([x, y, z], middle, distance) {
  const turn = 0.5 * Math.atan2(x, z), tilt = -0.5 * Math.asin(y), w = Math.cos(turn) * Math.cos(tilt);
  const axis = [Math.cos(turn) * Math.sin(tilt), Math.sin(turn) * Math.cos(tilt), -Math.sin(turn) * Math.sin(tilt)], length = Math.hypot(...axis);
  return {place: [x, y, z].map((d, k) => middle[k] + distance * d), turned: length < 1e-9 ? [[0, 1, 0], 0] : [axis.map(a => a / length), 2 * Math.atan2(length, w)]};
}

test('X_ITE, with VRML97 as in the paper', {timeout: 240_000}, async () => {
  const given = {};
  for (const name of ['dt', 'db']) {
    const front = `${readFileSync(made(`${name}.wrl`), 'utf8')}\nBackground { skyColor 0 1 0 }\n`;   // a colour that no tooth has
    assert.ok(front.startsWith('#VRML V2.0 utf8') && front.includes('solid TRUE') && front.includes('ccw TRUE'));
    given[name.toUpperCase()] = {front, both: front.replaceAll('solid TRUE', 'solid FALSE')};
  }
  const html = `<!DOCTYPE html><style>html,body{margin:0;background:transparent}x3d-canvas{width:${size}px;height:${size}px}</style><script>${notGreenInPage}</script>
    <script src="x_ite/x_ite.min.js"></script><x3d-canvas splashScreen="false" notifications="false" contextMenu="false" antialiased="false"></x3d-canvas>`;
  const {page, failures} = await pageWith(path => {
    const [name, which] = path.replace('.wrl', '').split('/');
    if (path === 'index.html') return html;
    if (path.startsWith('x_ite/')) { try { return readFileSync(join(modules, 'x_ite/dist', path.slice(6))); } catch { return undefined; } }
    return given[name]?.[which];
  });
  await page.goto('http://judge.test/index.html');
  const results = {};
  for (const name of Object.keys(given)) {
    const drawn = {};
    for (const which of ['both', 'front']) {
      drawn[which] = [];
      await page.evaluate(async url => {
        const X3D = globalThis.X3D, browser = X3D.getBrowser(document.querySelector('x3d-canvas'));
        await browser.loadURL(new X3D.MFString(url));
        globalThis.browser = browser;
        globalThis.viewpoint = browser.currentScene.rootNodes.find(node => node.getNodeTypeName() === 'Viewpoint');
      }, `${name}/${which}.wrl`);
      for (const [x, y, z] of directions) {
        await page.evaluate(async ({place, turned: [axis, angle]}) => {
          viewpoint.position = new X3D.SFVec3f(...place);
          viewpoint.orientation = new X3D.SFRotation(...axis, angle);
          await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
        }, lookingFrom([x, y, z], [0, 0.0107, 0], 0.04));
        const picture = (await page.screenshot({omitBackground: true})).toString('base64');
        drawn[which].push(Buffer.from(await page.evaluate(url => notGreen(url), `data:image/png;base64,${picture}`), 'base64'));
        if (process.env.ODONTOSCOPE_KEEP) writeFileSync(join(process.env.ODONTOSCOPE_KEEP, `x_ite-${name}-${which}-${drawn[which].length}.png`), Buffer.from(picture, 'base64'));
      }
    }
    results[name] = await seen(async (direction, which) => drawn[which][directions.indexOf(direction)]);
  }
  assert.deepEqual(failures, []);
  judge('X_ITE', results);
  await page.close();
});
