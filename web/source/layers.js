// All layers of what is seen through, in their order at every pixel (depth peeling: Everitt, "Interactive order-independent transparency", NVIDIA
// 2001), and how dark it is in hollows, with the desktop's own shaders. Where that costs too much: of each structure only what is nearest.
import {
  Box3, ConstantAlphaFactor, DepthTexture, FloatType, HalfFloatType, Matrix4, NearestFilter, OneFactor, OneMinusConstantAlphaFactor, OneMinusDstAlphaFactor, RGFormat, Vector2,
  Vector3, WebGLRenderTarget,
} from 'three';
import composeShader from '../../shaders/compose.frag';
import occlusionShader from '../../shaders/occlusion.frag';
import {Sheet} from './sheet.js';
import {noPeel} from './surface.js';

const mostLayers = 16, firstLayers = 8, quickLayers = 2;
const shadedLayers = 4;     // of the translucent ones; what lies behind these shows too little for it
const sameSurface = 0.25;   // of the occlusion's reach, within which neighbours lie on one surface
const strength = 1;

/// How many layers the last pictures had, as the graphics card tells some time later.
class Counter {
  constructor(gl) {
    this.gl = gl;
    this.limit = firstLayers;
    this.asked = null;
    this.tooFew = false;
  }

  begin() {
    this.take();
    this.asking = !this.asked;
    this.queries = [];
  }
  around(draw) {
    if (!this.asking) return draw();
    const {gl} = this, query = gl.createQuery();
    this.queries.push(query);
    gl.beginQuery(gl.ANY_SAMPLES_PASSED, query);
    draw();
    gl.endQuery(gl.ANY_SAMPLES_PASSED);
  }
  end() { if (this.asking && this.queries.length > 0) this.asked = this.queries; }

  take() {
    const {gl, asked} = this;
    if (!asked || !gl.getQueryParameter(asked.at(-1), gl.QUERY_RESULT_AVAILABLE)) return;
    const empty = asked.findIndex(query => !gl.getQueryParameter(query, gl.QUERY_RESULT));
    this.tooFew = this.tooFew || (empty < 0 && asked.length < mostLayers);
    this.limit = Math.min(mostLayers, (empty < 0 ? asked.length : empty) + 2);
    for (const query of asked) gl.deleteQuery(query);
    this.asked = null;
  }
}

export class Layers {
  /// Can this browser draw to targets of light?
  static possible(renderer) { return renderer.extensions.has('EXT_color_buffer_float'); }

  constructor(renderer, shared) {
    this.renderer = renderer;
    this.shared = shared;
    const surface = () => {
      const target = new WebGLRenderTarget(4, 4, {count: 2, type: HalfFloatType, minFilter: NearestFilter, magFilter: NearestFilter});
      target.depthTexture = new DepthTexture(4, 4, FloatType);
      return target;
    };
    [this.opaque, ...this.peeled] = [surface(), surface(), surface()];
    const flat = options => new WebGLRenderTarget(4, 4, {depthBuffer: false, ...options});
    this.hollows = flat({type: FloatType, format: RGFormat, minFilter: NearestFilter, magFilter: NearestFilter});
    this.sum = flat({type: HalfFloatType});
    this.mean = flat({type: HalfFloatType});
    const low = new Vector2(), high = new Vector2();
    this.box = {low, high};
    this.occlusion = new Sheet(occlusionShader, {depth: null, eye_to_clip: new Matrix4(), clip_to_eye: new Matrix4(), pixels: new Vector2(), low, high, reach: 1, strength});
    this.compose = new Sheet(composeShader, {light: null, ambient: null, occlusion: null, low, high, occluded: 0, same_surface: 0},
      {blendSrc: OneMinusDstAlphaFactor, blendDst: OneFactor});
    this.average = new Sheet('uniform sampler2D light; layout(location = 0) out vec4 out_light; void main() { out_light = texelFetch(light, ivec2(gl_FragCoord.xy), 0); }',
      {light: null}, {blendSrc: ConstantAlphaFactor, blendDst: OneMinusConstantAlphaFactor});
    this.counter = new Counter(renderer.getContext());
  }

  /// Were layers missing in what was drawn? Told once, some time after it was.
  hadTooFew() {
    this.counter.take();
    const {tooFew} = this.counter;
    this.counter.tooFew = false;
    return tooFew;
  }

  /// The light of the scene, premultiplied, as a texture: the mean of this `sample` and those before it; 1 is the first.
  /// `caster` of rays (Volume or Shadow), or null; `scale`: a part of the screen's pixels along each side.
  draw(scene, camera, model, {layers, shade, reach, bounds, caster = null, scale = 1, complete = false, sample}) {
    const {renderer, shared, opaque, peeled} = this, screen = renderer.getDrawingBufferSize(new Vector2());
    this.fit(screen.multiplyScalar(scale).ceil());
    camera.updateMatrixWorld();
    if (caster?.isFilm) this.keepToAll();   // a film reaches beyond what it shows, and beside it is its edge
    else this.keepTo(camera, caster ? new Box3(caster.low, caster.high).union(bounds.box) : bounds.box);
    this.shading = shade ? {camera, reach} : null;
    if (sample === 2) [this.sum, this.mean] = [this.mean, this.sum];   // the first one was the mean by itself
    this.sum.scissorTest = this.mean.scissorTest = false;
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(this.sum);
    renderer.clear(true, false, false);
    this.sum.scissorTest = true;
    if (caster) this.castAmong(scene, camera, model, {caster, layers, complete});
    else if (!layers) {
      this.surfaces(scene, camera, model, 'all', peeled[0]);
      this.addLayer(peeled[0]);
    } else {
      this.surfaces(scene, camera, model, 'opaque', opaque);
      if (model.anyClear) this.peel(scene, camera, model, complete ? mostLayers : this.counter.limit);
      if (model.anyOpaque) this.addLayer(opaque);
    }
    shared.peel.value = noPeel;
    if (sample === 1) return this.sum.texture;
    this.average.material.blendAlpha = 1 / sample;
    this.average.set({light: this.sum.texture}).draw(renderer, this.mean);
    return this.mean.texture;
  }

  /// Rays through a volume, and surfaces where they are in it; of clear ones only the nearest two while that must be quick.
  castAmong(scene, camera, model, {caster, layers, complete}) {
    const {renderer, shared, opaque} = this, view = {camera, section: shared.section.value, lamp: shared.lamp.value, pixels: new Vector2(opaque.width, opaque.height)};
    if (caster.projects) return caster.drawProjection(view, this.sum);
    if (caster.showsSurfaces) this.surfaces(scene, camera, model, 'opaque', opaque);
    else {
      renderer.setRenderTarget(opaque);
      renderer.clear(true, true, false);
    }
    const raw = caster.look.cast === 'surface';
    if (raw) caster.drawSurface(view, opaque);
    const between = (from, to) => { if (!raw) caster.drawBetween(view, {from, to, opaque: opaque.depthTexture}, this.sum); };
    let last = null;
    if (caster.showsSurfaces && model.anyClear) last = this.peel(scene, camera, model, complete ? mostLayers : layers ? this.counter.limit : quickLayers, between);
    between(last, null);
    if (raw || (caster.showsSurfaces && model.anyOpaque)) this.addLayer(opaque);
  }

  /// `between(from, to)` is called before each layer is added. Returns the last one's depths.
  peel(scene, camera, model, count, between = () => {}) {
    const {shared, opaque, peeled, counter} = this;
    counter.begin();
    for (let i = 0; i < count; ++i) {
      shared.peel.value = i;
      shared.opaque_depth.value = opaque.depthTexture;
      shared.layer_before.value = i > 0 ? peeled[(i - 1) % 2].depthTexture : null;
      counter.around(() => this.surfaces(scene, camera, model, 'clear', peeled[i % 2]));
      between(i > 0 ? peeled[(i - 1) % 2].depthTexture : null, peeled[i % 2].depthTexture);
      this.addLayer(peeled[i % 2], i < shadedLayers);
    }
    counter.end();
    shared.opaque_depth.value = shared.layer_before.value = null;   // no target may be read while it is drawn to
    return peeled[(count - 1) % 2].depthTexture;
  }

  surfaces(scene, camera, model, pass, target) {
    model.prepare(pass);
    this.renderer.setRenderTarget(target);
    this.renderer.render(scene, camera);
  }

  /// Under what is already there.
  addLayer(target, shaded = true) {
    const {renderer, hollows} = this, shading = shaded ? this.shading : null, [light, ambient] = target.textures;
    if (shading) {
      const {camera, reach} = shading;
      this.occlusion.set({depth: target.depthTexture, eye_to_clip: camera.projectionMatrix, clip_to_eye: camera.projectionMatrixInverse, reach}).draw(renderer, hollows);
      this.compose.set({occlusion: hollows.texture, same_surface: sameSurface * reach});
    }
    this.compose.set({light, ambient, occluded: shading ? 1 : 0}).draw(renderer, this.sum);
  }

  fit(size) {
    if (this.opaque.width === size.x && this.opaque.height === size.y) return;
    for (const target of [this.opaque, ...this.peeled, this.hollows, this.sum, this.mean]) {
      target.setSize(size.x, size.y);
      target.scissorTest = true;
    }
    this.occlusion.uniforms.pixels.value.copy(size);
  }

  /// Nothing is drawn but where the model can be.
  keepTo(camera, box) {
    const {low, high} = this.box, {width, height} = this.opaque, p = new Vector3();
    low.set(width, height);
    high.set(0, 0);
    for (let corner = 0; corner < 8; ++corner) {
      p.set(...['x', 'y', 'z'].map((axis, k) => (corner >> k & 1 ? box.max : box.min)[axis])).applyMatrix4(camera.matrixWorldInverse);
      if (p.z > -camera.near) {   // beside or behind the eye
        low.set(0, 0);
        high.set(width, height);
        break;
      }
      p.applyMatrix4(camera.projectionMatrix);
      low.min({x: Math.floor((0.5 + 0.5 * p.x) * width) - 2, y: Math.floor((0.5 + 0.5 * p.y) * height) - 2});
      high.max({x: Math.ceil((0.5 + 0.5 * p.x) * width) + 2, y: Math.ceil((0.5 + 0.5 * p.y) * height) + 2});
    }
    low.clampScalar(0, Infinity);
    high.min({x: width, y: height});
    this.scissor();
  }

  keepToAll() {
    this.box.low.set(0, 0);
    this.box.high.set(this.opaque.width, this.opaque.height);
    this.scissor();
  }

  scissor() {
    const {low, high} = this.box;
    for (const target of [this.opaque, ...this.peeled, this.hollows, this.sum, this.mean])
      target.scissor.set(low.x, low.y, Math.max(0, high.x - low.x), Math.max(0, high.y - low.y));
  }
}
