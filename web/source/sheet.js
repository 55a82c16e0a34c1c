// A shader that runs for every pixel of a target.
import {BufferGeometry, CustomBlending, Float32BufferAttribute, GLSL3, Mesh, NoBlending, OrthographicCamera, Scene, ShaderMaterial} from 'three';

const corners = new BufferGeometry().setAttribute('position', new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
const flat = new OrthographicCamera();

export class Sheet {
  /// `values` of its uniforms; `blend`: {blendSrc, blendDst}, else what was there is replaced.
  constructor(fragmentShader, values, blend = null) {
    this.uniforms = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, {value}]));
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, fragmentShader, uniforms: this.uniforms, depthTest: false, depthWrite: false,
      vertexShader: 'out vec2 at; void main() { at = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      ...(blend ? {blending: CustomBlending, ...blend} : {blending: NoBlending}),
    });
    const mesh = new Mesh(corners, this.material);
    mesh.frustumCulled = false;
    this.scene = new Scene();
    this.scene.add(mesh);
  }

  set(values) {
    for (const [name, value] of Object.entries(values)) this.uniforms[name].value = value;
    return this;
  }

  /// Into `target`, null: the screen. Nothing there is cleared.
  draw(renderer, target) {
    const {autoClear} = renderer;
    renderer.autoClear = false;
    renderer.setRenderTarget(target);
    renderer.render(this.scene, flat);
    renderer.autoClear = autoClear;
  }
}
