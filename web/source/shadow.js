// The X-ray film of a model without a volume: how far each ray runs inside each structure, times how much a millimetre of that tissue swallows. The length inside is the sum of
// the distances of the faces that a ray leaves by, less those that it enters by; they are added up by the graphics card, in any order. Where a section cuts, faces on its far side do not
// count; rays that are within a structure where they pass the section are told by what is left over of their faces' attenuations, and enter or leave there.
import {
  AddEquation, CustomBlending, DoubleSide, FloatType, GLSL3, HalfFloatType, Matrix4, Mesh, NearestFilter, OneFactor, OneMinusDstAlphaFactor, Scene, ShaderMaterial, Vector2, Vector3, Vector4, WebGLRenderTarget,
} from 'three';
import filmShader from '../../shaders/film.frag';
import faceShader from '../../shaders/film_faces.frag';
import filmEdge from '../../shaders/film_edge.glsl';
import tone from '../../shaders/tone.glsl';
import {Sheet} from './sheet.js';

const vertexShader = `
out vec3 eye_place;
out vec3 place;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  eye_place = eye.xyz;
  place = position;
  gl_Position = projectionMatrix * eye;
}`;

export class Shadow {
  /// Null where nothing is known of any tissue, or the surfaces are not closed, so that no ray has a length inside.
  static of(renderer, {models, looks, certificate}, bounds) {
    const parts = models[0].parts.filter(part => looks.get(part.structure)?.attenuation > 0);
    return certificate.verdict === 'wanting' || parts.length === 0 || !renderer.extensions.has('EXT_color_buffer_float') ? null : new Shadow(renderer, parts, looks, bounds);
  }

  constructor(renderer, parts, looks, bounds) {
    this.renderer = renderer;
    this.looks = looks;
    this.bounds = bounds;
    this.on = false;
    this.latitude = 4;
    this.inverted = false;
    this.film_mm = [0, 0];   // 0: it has no edge
    this.scene = new Scene();
    this.meshes = parts.map(part => {
      const mesh = new Mesh(part.geometry, new ShaderMaterial({
        glslVersion: GLSL3, vertexShader, fragmentShader: faceShader, uniforms: {attenuation: {value: looks.get(part.structure).attenuation}, middle: {value: 0}, parallel: {value: 0}, section: {value: new Vector4(0, 0, 0, 1)}},
        side: DoubleSide, depthTest: false, depthWrite: false, blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor, blendDst: OneFactor,
      }));
      mesh.frustumCulled = false;
      this.scene.add(mesh);
      return {mesh, structure: part.structure};
    });
    const precise = renderer.extensions.has('EXT_float_blend');
    this.sums = new WebGLRenderTarget(4, 4, {type: precise ? FloatType : HalfFloatType, depthBuffer: false, minFilter: NearestFilter, magFilter: NearestFilter});
    this.film = new Sheet(filmShader.replace('#include "tone.glsl"', tone).replace('#include "film_edge.glsl"', filmEdge), {swallowed: null, latitude: 4, middle: 0, parallel: 0, least: 1e-3, inverted: 0, film: new Vector2(), film_centre: new Vector3(), section: new Vector4(), clip_to_eye: new Matrix4(), pixels: new Vector2()}, {blendSrc: OneMinusDstAlphaFactor, blendDst: OneFactor});
  }

  get isFilm() { return true; }
  get projects() { return true; }
  get showsSurfaces() { return false; }
  get low() { return this.bounds.box.min; }
  get high() { return this.bounds.box.max; }

  drawProjection({camera, pixels, section}, target) {
    const {renderer, sums} = this, film_centre = this.bounds.centre.clone().applyMatrix4(camera.matrixWorldInverse);
    const parallel = camera.isOrthographicCamera ? 1 : 0, middle = parallel ? -film_centre.z : film_centre.length();
    if (sums.width !== pixels.x || sums.height !== pixels.y) sums.setSize(pixels.x, pixels.y);
    for (const {mesh, structure} of this.meshes) {
      mesh.visible = this.looks.get(structure).visible;
      mesh.material.uniforms.middle.value = middle;
      mesh.material.uniforms.parallel.value = parallel;
      mesh.material.uniforms.section.value = section;
    }
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(sums);
    renderer.clear(true, false, false);
    renderer.render(this.scene, camera);
    const normal = new Vector3(section.x, section.y, section.z).transformDirection(camera.matrixWorldInverse);
    const seen = new Vector4(normal.x, normal.y, normal.z, section.w - camera.position.dot(new Vector3(section.x, section.y, section.z)));
    this.film.set({
      swallowed: sums.texture, latitude: this.latitude, middle, parallel, section: seen, clip_to_eye: camera.projectionMatrixInverse,
      pixels, inverted: this.inverted ? 1 : 0, film: new Vector2(...this.film_mm), film_centre,
    }).draw(renderer, target);
  }
}
