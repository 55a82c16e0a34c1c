// From the scene to the screen: light is added up linearly in a target of its own, then toned and put before the background. Where the browser
// cannot draw to such a target, and in a headset, surfaces are toned one by one.
import {
  BufferGeometry, Color, Float32BufferAttribute, GLSL3, HalfFloatType, Mesh, NoBlending, OrthographicCamera, SRGBColorSpace, Scene, ShaderMaterial, Vector2,
  WebGLRenderTarget,
} from 'three';
import tone from '../../shaders/tone.glsl';

const samples = 4;

const composeShader = `
${tone}
uniform sampler2D light;
uniform vec3 top, bottom;
in vec2 at;
layout(location = 0) out vec4 out_colour;
void main() {
  vec4 drawn = texture(light, at);
  vec3 colour = drawn.rgb + (1.0 - drawn.a) * mix(bottom, top, at.y);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;   // no bands in the background
  out_colour = vec4(encoded(clamp(shoulder(colour), 0.0, 1.0)) + noise / 255.0, 1.0);
}`;

export class Picture {
  constructor(renderer, shared) {
    this.renderer = renderer;
    this.shared = shared;
    this.linear = renderer.extensions.has('EXT_color_buffer_float') || renderer.extensions.has('EXT_color_buffer_half_float');
    if (this.linear) this.target = new WebGLRenderTarget(4, 4, {type: HalfFloatType, samples, stencilBuffer: true});
    this.compose = new ShaderMaterial({
      glslVersion: GLSL3, blending: NoBlending, depthTest: false, depthWrite: false, fragmentShader: composeShader,
      vertexShader: 'out vec2 at; void main() { at = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      uniforms: {light: {value: this.target?.texture ?? null}, top: {value: new Color()}, bottom: {value: new Color()}},
    });
    const triangle = new BufferGeometry().setAttribute('position', new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    this.screen = new Scene();
    const mesh = new Mesh(triangle, this.compose);
    mesh.frustumCulled = false;
    this.screen.add(mesh);
    this.flat = new OrthographicCamera();
    this.plain = new Color();
  }

  setBackground(top, bottom) {
    this.compose.uniforms.top.value.setStyle(top, SRGBColorSpace);
    this.compose.uniforms.bottom.value.setStyle(bottom, SRGBColorSpace);
    this.plain.setStyle(top, SRGBColorSpace);
  }

  draw(scene, camera) {
    const {renderer, shared} = this;
    if (renderer.xr.isPresenting || !this.linear) {
      shared.encode.value = true;
      renderer.setClearColor(this.plain, 1);
      renderer.render(scene, camera);
      return;
    }
    shared.encode.value = false;
    const size = renderer.getDrawingBufferSize(new Vector2());
    if (this.target.width !== size.x || this.target.height !== size.y) this.target.setSize(size.x, size.y);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    renderer.render(this.screen, this.flat);
  }
}

/// Lights travel with the eye, as on the desktop; in a headset, whose camera is given, they stay where they are while the head turns.
export function setLightFrame(shared, head) {
  if (head) shared.light_frame.value.setFromMatrix4(head.matrixWorld);
  else shared.light_frame.value.identity();
}
