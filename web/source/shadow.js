// The X-ray film of a model without a volume: how far each ray runs inside each structure, times how much a millimetre of that tissue swallows. The length inside is the sum of
// the distances of the faces that a ray leaves by, less those that it enters by; they are added up by the graphics card, in any order. Where a section cuts, faces on its far side do not
// count; rays that are within a structure where they pass the section are told by what is left over of their faces' attenuations, and enter or leave there.
import {
  AddEquation, CustomBlending, DoubleSide, FloatType, GLSL3, HalfFloatType, Matrix4, Mesh, NearestFilter, OneFactor, OneMinusDstAlphaFactor, Scene, ShaderMaterial, Vector2, Vector3, Vector4, WebGLRenderTarget,
} from 'three';
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

const faceShader = `
in vec3 eye_place;
in vec3 place;
uniform vec4 section;        // keeps what has dot(xyz, place) <= w
uniform float attenuation;   // 1/mm
uniform float middle;        // a distance about which little is lost
layout(location = 0) out vec4 out_swallowed;
void main() {
  if (dot(section.xyz, place) > section.w) discard;
  float left = gl_FrontFacing ? -attenuation : attenuation;
  out_swallowed = vec4(left * (length(eye_place) - middle), left, 0.0, 1.0);
}`;

const filmShader = `
${tone}
uniform sampler2D swallowed;
uniform float latitude;   // attenuation that is white
uniform float middle;
uniform vec4 section;     // in eye space
uniform mat4 clip_to_eye;
uniform vec2 pixels;
const float none = 1e-3;  // 1/mm, of what rounding leaves over

layout(location = 0) out vec4 out_colour;
void main() {
  vec4 both = texelFetch(swallowed, ivec2(gl_FragCoord.xy), 0);
  vec4 far = clip_to_eye * vec4(2.0 * gl_FragCoord.xy / pixels - 1.0, 1.0, 1.0);
  float approach = dot(section.xyz, normalize(far.xyz / far.w)), sum = both.r;
  if (abs(both.g) > none && approach != 0.0) sum -= both.g * (section.w / approach - middle);
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
        glslVersion: GLSL3, vertexShader, fragmentShader: faceShader, uniforms: {attenuation: {value: looks.get(part.structure).attenuation}, middle: {value: 0}, section: {value: new Vector4(0, 0, 0, 1)}},
        side: DoubleSide, depthTest: false, depthWrite: false, blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor, blendDst: OneFactor,
      }));
      mesh.frustumCulled = false;
      this.scene.add(mesh);
      return {mesh, structure: part.structure};
    });
    const precise = renderer.extensions.has('EXT_float_blend');
    this.sums = new WebGLRenderTarget(4, 4, {type: precise ? FloatType : HalfFloatType, depthBuffer: false, minFilter: NearestFilter, magFilter: NearestFilter});
    this.film = new Sheet(filmShader, {swallowed: null, latitude: 4, middle: 0, section: new Vector4(), clip_to_eye: new Matrix4(), pixels: new Vector2()}, {blendSrc: OneMinusDstAlphaFactor, blendDst: OneFactor});
  }

  get projects() { return true; }
  get showsSurfaces() { return false; }
  get low() { return this.bounds.box.min; }
  get high() { return this.bounds.box.max; }

  drawProjection({camera, pixels, section}, target) {
    const {renderer, sums} = this, middle = camera.position.distanceTo(this.bounds.centre);
    if (sums.width !== pixels.x || sums.height !== pixels.y) sums.setSize(pixels.x, pixels.y);
    for (const {mesh, structure} of this.meshes) {
      mesh.visible = this.looks.get(structure).visible;
      mesh.material.uniforms.middle.value = middle;
      mesh.material.uniforms.section.value = section;
    }
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(sums);
    renderer.clear(true, false, false);
    renderer.render(this.scene, camera);
    const normal = new Vector3(section.x, section.y, section.z).transformDirection(camera.matrixWorldInverse);
    const seen = new Vector4(normal.x, normal.y, normal.z, section.w - camera.position.dot(new Vector3(section.x, section.y, section.z)));
    this.film.set({swallowed: sums.texture, latitude: this.latitude, middle, section: seen, clip_to_eye: camera.projectionMatrixInverse, pixels}).draw(renderer, target);
  }
}
