// The X-ray film of a model without a volume: how far each ray runs inside each structure, times how much a millimetre of that tissue swallows. The length inside is the sum of
// the distances of the faces that a ray leaves by, less those that it enters by; they are added up by the graphics card, in any order.
import {
  AddEquation, CustomBlending, DoubleSide, FloatType, GLSL3, HalfFloatType, Mesh, NearestFilter, OneFactor, OneMinusDstAlphaFactor, Scene, ShaderMaterial, WebGLRenderTarget,
} from 'three';
import tone from '../../shaders/tone.glsl';
import {Sheet} from './sheet.js';

const vertexShader = `
out vec3 eye_place;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  eye_place = eye.xyz;
  gl_Position = projectionMatrix * eye;
}`;

const faceShader = `
in vec3 eye_place;
uniform float attenuation;   // 1/mm
uniform float middle;        // a distance about which little is lost
layout(location = 0) out vec4 out_swallowed;
void main() {
  float way = attenuation * (length(eye_place) - middle);
  out_swallowed = vec4(gl_FrontFacing ? -way : way, 0.0, 0.0, 1.0);
}`;

const filmShader = `
${tone}
uniform sampler2D swallowed;
uniform float latitude;   // attenuation that is white
layout(location = 0) out vec4 out_colour;
void main() {
  float sum = texelFetch(swallowed, ivec2(gl_FragCoord.xy), 0).r;
  out_colour = vec4(vec3(light_shown_as(clamp(sum / latitude, 0.0, 1.0))), 1.0);
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
    this.scene = new Scene();
    this.meshes = parts.map(part => {
      const mesh = new Mesh(part.geometry, new ShaderMaterial({
        glslVersion: GLSL3, vertexShader, fragmentShader: faceShader, uniforms: {attenuation: {value: looks.get(part.structure).attenuation}, middle: {value: 0}},
        side: DoubleSide, depthTest: false, depthWrite: false, blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor, blendDst: OneFactor,
      }));
      mesh.frustumCulled = false;
      this.scene.add(mesh);
      return {mesh, structure: part.structure};
    });
    const precise = renderer.extensions.has('EXT_float_blend');
    this.sums = new WebGLRenderTarget(4, 4, {type: precise ? FloatType : HalfFloatType, depthBuffer: false, minFilter: NearestFilter, magFilter: NearestFilter});
    this.film = new Sheet(filmShader, {swallowed: null, latitude: 4}, {blendSrc: OneMinusDstAlphaFactor, blendDst: OneFactor});
  }

  get projects() { return true; }
  get showsSurfaces() { return false; }
  get low() { return this.bounds.box.min; }
  get high() { return this.bounds.box.max; }

  drawProjection({camera, pixels}, target) {
    const {renderer, sums} = this;
    if (sums.width !== pixels.x || sums.height !== pixels.y) sums.setSize(pixels.x, pixels.y);
    for (const {mesh, structure} of this.meshes) {
      mesh.visible = this.looks.get(structure).visible;
      mesh.material.uniforms.middle.value = camera.position.distanceTo(this.bounds.centre);
    }
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(sums);
    renderer.clear(true, false, false);
    renderer.render(this.scene, camera);
    this.film.set({swallowed: sums.texture, latitude: this.latitude}).draw(renderer, target);
  }
}
