// The grey values that the page carries, cast by rays with the desktop's own shaders.
import {
  Color, Data3DTexture, DataTexture, DataUtils, FloatType, HalfFloatType, LinearFilter, Matrix4, NearestFilter, OneFactor, OneMinusDstAlphaFactor, RedFormat, RGBAFormat,
  SRGBColorSpace, UnsignedByteType, Vector2, Vector3, Vector4,
} from 'three';
import lighting from '../../shaders/lighting.glsl';
import tone from '../../shaders/tone.glsl';
import castShader from '../../shaders/volume.frag';
import rayShader from '../../shaders/volume_ray.glsl';
import surfaceShader from '../../shaders/volume_surface.frag';
import filmEdge from '../../shaders/film_edge.glsl';
import {brickGrid, brickSide, distancesToShown} from './bricks.js';
import {Sheet} from './sheet.js';
import {anyExtinction, entries, transferTable, understood} from './transfer.js';

const shared = {'film_edge.glsl': filmEdge, 'lighting.glsl': lighting, 'tone.glsl': tone, 'volume_ray.glsl': rayShader};
const included = text => text.replace(/#include "([\w.]+)"/g, (_, name) => shared[name]);
const under = {blendSrc: OneMinusDstAlphaFactor, blendDst: OneFactor};   // what is there already stays in front
const levels = 255, mostSteps = 8192, clearSlope = 0.0625;   // as on the desktop
export const projections = ['maximum', 'average', 'radiograph'];

function texture3d([width, height, depth], data, {type = UnsignedByteType, filter}) {
  const texture = new Data3DTexture(data, width, height, depth);
  Object.assign(texture, {format: RedFormat, type, minFilter: filter, magFilter: filter, unpackAlignment: 1, needsUpdate: true});
  return texture;
}

/// Halves of floats keep whole numbers up to 2048: a graphics card interpolates between them more finely than between bytes.
function valueTexture(size, bytes) {
  const halves = Uint16Array.from({length: 256}, (_, byte) => DataUtils.toHalfFloat(byte));
  return texture3d(size, Uint16Array.from(bytes, byte => halves[byte]), {type: HalfFloatType, filter: LinearFilter});
}

export class Volume {
  /// `told`: the page's description of it; `bytes`: its values; `bounds`: of the model, at whose middle a film hangs.
  constructor(renderer, told, bytes, bounds) {
    const most = renderer.getContext().getParameter(renderer.getContext().MAX_3D_TEXTURE_SIZE);
    if (Math.max(...told.size) > most) throw new Error(`the volume has ${Math.max(...told.size)} values along one side, and this browser draws ${most}`);
    this.renderer = renderer;
    this.bounds = bounds;
    this.told = told;
    this.look = structuredClone(told.look);
    this.grid = brickGrid(told.size, bytes);
    this.range = this.grid.highest.reduce((a, b) => Math.max(a, b)) - this.grid.lowest.reduce((a, b) => Math.min(a, b)) || 1;   // bytes
    const step = new Vector3(...told.step_mm), size = new Vector3(...told.size), first = new Vector3(...told.first_mm);
    this.low = first.clone().addScaledVector(step, -0.5);
    this.high = this.low.clone().add(size.clone().multiply(step));
    this.finest = Math.min(...told.step_mm);
    this.diagonal = size.clone().multiply(step).length();
    this.unit = (told.high - told.low) / levels;   // of a value, between two bytes
    this.ray = {
      eye_to_world: new Matrix4(), eye_to_clip: new Matrix4(), clip_to_eye: new Matrix4(), pixels: new Vector2(), apart: 1, parallel: 0, section: new Vector4(), first, spacing: step, size,
      stride: 1, values: valueTexture(told.size, bytes), bricks: null, brick_side: brickSide,
    };
    this.light = {lamp: new Vector4()};
    this.transfer = new DataTexture(new Float32Array(4 * entries), entries, 1, RGBAFormat, FloatType);
    this.transfer.magFilter = this.transfer.minFilter = NearestFilter;
    this.sheets = new Map();
    this.coarseness = 1;
    this.prepared = '';
  }

  get showsVolume() { return this.look.shows !== 'surfaces'; }
  get isFilm() { return this.look.cast === 'radiograph'; }
  get projects() { return projections.includes(this.look.cast); }
  get showsSurfaces() { return !this.told.alone && (this.look.shows === 'surfaces' || (this.look.shows === 'both' && !this.projects)); }
  byte(value) { return (value - this.told.low) / this.unit; }

  get bySlope() { return this.look.slopes[1] > 0; }

  sheetFor(cast) {
    const kind = cast === 'shaded' && this.bySlope ? 'shaded by slope' : cast;
    if (this.sheets.has(kind)) return this.sheets.get(kind);
    const sheet = cast === 'surface'
      ? new Sheet(included(surfaceShader), {...this.ray, ...this.light, iso: 0, colour: new Color()})
      : cast === 'shaded'
        ? new Sheet(`#define SHADED\n${kind === cast ? '' : '#define BY_SLOPE\n'}${included(castShader)}`, {...this.ray, ...this.light, ...(kind === cast ? {} : {slopes: new Vector2()}), transfer: this.transfer, among_surfaces: 1, transfer_range: new Vector2(), lit: 1, clear_slope: 1, depth_from: null,
          depth_to: null, depth_opaque: null, from_the_eye: 1}, under)
        : new Sheet(`#define ${cast.toUpperCase()}\n${included(castShader)}`, {...this.ray, low: 0, high: 1, ...(cast === 'radiograph' ? {attenuation: 0, latitude: 1, inverted: 0, film: new Vector2(), film_centre: new Vector3()} : {})}, under);
    if (cast === 'surface') Object.assign(sheet.material, {depthTest: true, depthWrite: true});
    this.sheets.set(kind, sheet);
    return sheet;
  }

  /// Lays out transfer function and empty bricks for the look as it is; at once if nothing changed.
  prepare() {
    const {look, told} = this, {cast, transfer, window: [black, white], iso} = look, key = JSON.stringify([cast, transfer, black, white, iso]);
    if (key === this.prepared) return;
    this.prepared = key;
    const points = understood(transfer), valueOf = byte => told.low + this.unit * byte;
    const shows = {
      shaded: (low, high) => anyExtinction(points, low, high),
      surface: (low, high) => low < iso && high >= iso,
      radiograph: (low, high) => low !== black || high !== black,
    }[cast] ?? ((low, high) => high > black);
    const bricks = texture3d(this.grid.size, distancesToShown(this.grid, (low, high) => shows(valueOf(low), valueOf(high))), {filter: NearestFilter});
    this.ray.bricks?.dispose();
    this.ray.bricks = bricks;
    for (const [, sheet] of this.sheets) sheet.set({bricks});
    if (cast !== 'shaded') return;
    this.transfer.image.data.set(transferTable(points, told.low, told.high, levels));
    this.transfer.needsUpdate = true;
  }

  /// What all ways to cast have in common; `view`: {camera, section, lamp, pixels}.
  sheetSeenBy({camera, section, lamp, pixels}) {
    this.prepare();
    const {look} = this, sheet = this.sheetFor(look.cast), step = 0.5 * this.finest;
    sheet.set({
      eye_to_world: camera.matrixWorld, eye_to_clip: camera.projectionMatrix, clip_to_eye: camera.projectionMatrixInverse, pixels, section, bricks: this.ray.bricks,
      parallel: camera.isOrthographicCamera ? 1 : 0, stride: this.coarseness * Math.max(step, this.diagonal / mostSteps),
    });
    if (sheet.uniforms.lamp) sheet.set({lamp});
    return sheet;
  }

  /// Between two depths of every pixel, `from` and `to` (null: the eye, the end), and not beyond what is opaque; blended under what is in `target`.
  drawBetween(view, {from, to, opaque}, target) {
    this.sheetSeenBy(view).set({
      transfer_range: new Vector2(0, levels), lit: this.look.lit ? 1 : 0, among_surfaces: this.showsSurfaces ? 1 : 0, clear_slope: clearSlope * this.range / Math.max(...this.told.step_mm),
      depth_from: from ?? opaque, depth_to: to ?? opaque, depth_opaque: opaque, from_the_eye: from ? 0 : 1,
      ...(this.bySlope ? {slopes: new Vector2(...this.look.slopes.map(slope => slope / this.unit))} : {}),
    }).draw(this.renderer, target);
    this.sheetFor('shaded').set({depth_from: null, depth_to: null, depth_opaque: null});   // no target may be read while it is drawn to
  }

  drawProjection(view, target) {
    const {window: [black, white], attenuation, latitude, cast, film_mm} = this.look, sheet = this.sheetSeenBy(view).set({low: this.byte(black), high: this.byte(white)});
    if (cast === 'radiograph') {
      const film_centre = this.bounds.centre.clone().applyMatrix4(view.camera.matrixWorldInverse);
      sheet.set({attenuation, latitude, inverted: this.look.inverted ? 1 : 0, film: new Vector2(...film_mm), film_centre});
    }
    sheet.draw(this.renderer, target);
  }

  /// The raw surface of one value, among opaque surfaces.
  drawSurface(view, target) {
    const {iso, iso_colour} = this.look, sheet = this.sheetSeenBy(view).set({iso: this.byte(iso)});
    sheet.uniforms.colour.value.setStyle(iso_colour, SRGBColorSpace);
    sheet.draw(this.renderer, target);
  }
}
