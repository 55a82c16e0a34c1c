// From the scene to the screen. Light is added up linearly, layer by layer from the eye, then toned and put before the background, as on the
// desktop. A picture that stays still is drawn several times, each time off by a part of a pixel, and the mean is shown.
import {Color, SRGBColorSpace, Vector2} from 'three';
import {Layers} from './layers.js';
import {Sheet} from './sheet.js';
import tone from '../../shaders/tone.glsl';

const resolveShader = `
${tone}
uniform sampler2D light;
uniform vec3 top, bottom;
uniform bool smoothed;   // edges of a single sample a pixel
uniform bool empty;
uniform bool dark;       // of a film, nothing lies behind
in vec2 at;
layout(location = 0) out vec4 out_colour;

/// What lies behind is shown as it is, however much of it is covered (as shaders/resolve.frag does).
vec3 seen(vec2 place) {
  vec4 drawn = texture(light, place);
  vec3 toned = drawn.a > 0.0 ? shoulder(drawn.rgb / drawn.a) * drawn.a : vec3(0.0);
  return dark ? toned : toned + (1.0 - drawn.a) * mix(bottom, top, at.y);
}

float brightness(vec3 colour) { return sqrt(dot(colour, vec3(0.2, 0.7, 0.1))); }

/// Across an edge brightness changes, along it does not: the mean of what lies along it (the idea of Lottes, FXAA, NVIDIA 2009).
vec3 smoothed_edge(vec3 middle) {
  vec2 pixel = 1.0 / vec2(textureSize(light, 0));
  float nw = brightness(seen(at + pixel * vec2(-0.5, 0.5))), ne = brightness(seen(at + pixel * vec2(0.5, 0.5)));
  float sw = brightness(seen(at + pixel * vec2(-0.5, -0.5))), se = brightness(seen(at + pixel * vec2(0.5, -0.5)));
  float low = min(min(nw, ne), min(sw, se)), high = max(max(nw, ne), max(sw, se));
  if (high - low < max(0.03, 0.1 * high)) return middle;
  vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
  along = clamp(along / (min(abs(along.x), abs(along.y)) + 0.02), -3.0, 3.0) * pixel;
  vec3 near = 0.5 * (seen(at - along / 6.0) + seen(at + along / 6.0));
  vec3 wide = 0.5 * near + 0.25 * (seen(at - 0.5 * along) + seen(at + 0.5 * along));
  float of_wide = brightness(wide);
  return of_wide < low || of_wide > high ? near : wide;
}

void main() {
  vec3 colour = empty ? mix(bottom, top, at.y) : seen(at);
  if (smoothed) colour = smoothed_edge(colour);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;   // no bands in the background
  out_colour = vec4(encoded(clamp(colour, 0.0, 1.0)) + noise / 255.0, 1.0);
}`;

/// Where in its pixel the n-th sample lies: the first in the middle, the others spread evenly (Roberts' R2 sequence).
function offset(n) {
  const part = step => (0.5 + n * step) % 1 - 0.5;
  return [part(0.7548776662), part(0.5698402910)];
}

export class Picture {
  constructor(renderer, shared) {
    this.renderer = renderer;
    this.shared = shared;
    this.layers = Layers.possible(renderer) ? new Layers(renderer, shared) : null;
    this.resolve = new Sheet(resolveShader, {light: null, top: new Color(), bottom: new Color(), smoothed: false, empty: false, dark: false});
    this.plain = new Color();
    this.samples = 0;
    this.mostCast = 4;      // of one through which rays are cast, as on the desktop
    this.mostSamples = 8;   // of a picture that stays still; 0: it is left as it was drawn in motion
  }

  setBackground(top, bottom) {
    this.resolve.set({}).uniforms.top.value.setStyle(top, SRGBColorSpace);
    this.resolve.uniforms.bottom.value.setStyle(bottom, SRGBColorSpace);
    this.plain.setStyle(top, SRGBColorSpace);
  }

  /// `way`: {layers, shade, reach, bounds, caster, scale, complete}.
  draw(scene, camera, model, way) {
    if (this.renderer.xr.isPresenting || !this.layers) return this.drawPlainly(scene, camera, model);
    this.samples = 0;
    this.addSample(scene, camera, model, way);
  }

  /// Nothing is left to be done for a picture that stays still.
  finished(way) {
    if (!this.layers || this.mostSamples === 0) return true;
    if (this.layers.hadTooFew()) this.samples = 0;
    return this.sameWay(way) && this.samples >= (way.caster ? Math.min(this.mostSamples, this.mostCast) : this.mostSamples);
  }
  sameWay(way) { return way.layers === this.way?.layers && way.shade === this.way?.shade && way.scale === this.way?.scale; }

  /// One sample more of what was drawn before; all anew if that was drawn in another way.
  refine(scene, camera, model, way) {
    if (!this.sameWay(way)) this.samples = 0;
    this.addSample(scene, camera, model, way);
  }

  addSample(scene, camera, model, way) {
    const size = this.renderer.getDrawingBufferSize(new Vector2()), [x, y] = offset(this.samples);
    this.way = way;
    this.shared.encode.value = false;
    if (this.samples > 0) camera.setViewOffset(size.x, size.y, x, y, size.x, size.y);
    this.samples += 1;
    const light = this.layers.draw(scene, camera, model, {...way, sample: this.samples});
    if (this.samples > 1) camera.clearViewOffset();
    this.resolve.set({light, smoothed: this.samples === 1, empty: false, dark: way.caster?.projects ?? false}).draw(this.renderer, null);
  }

  /// Surfaces toned one by one, of translucent structures only what is nearest: for a headset, and where light cannot be added up.
  drawPlainly(scene, camera, model) {
    const {renderer, shared} = this, present = renderer.xr.isPresenting;
    shared.encode.value = true;
    model.prepare('all');
    renderer.setClearColor(this.plain, 1);
    if (!present) this.resolve.set({empty: true, smoothed: false}).draw(renderer, null);
    renderer.autoClearColor = present;
    renderer.render(scene, camera);
    renderer.autoClearColor = true;
  }
}

/// Lights travel with the eye, as on the desktop; in a headset, whose camera is given, they stay where they are while the head turns.
export function setLightFrame(shared, head) {
  if (head) shared.light_frame.value.setFromMatrix4(head.matrixWorld);
  else shared.light_frame.value.identity();
}
