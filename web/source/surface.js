// How a surface looks: the desktop program's light and tone, from the same files.
import {
  AddEquation, BackSide, Color, CustomBlending, DoubleSide, FrontSide, GLSL3, LessEqualDepth, Matrix3, OneFactor, OneMinusSrcAlphaFactor, ShaderMaterial,
  SRGBColorSpace, Vector4,
} from 'three';
import dataColour from '../../shaders/data_colour.glsl';
import grain from '../../shaders/grain.glsl';
import lighting from '../../shaders/lighting.glsl';
import tone from '../../shaders/tone.glsl';
import wallDepth from '../../shaders/wall_depth.glsl';
import {dataUniforms} from './data_colours.js';

const alarm = 0xff00bf, alarmOpacity = 0.9;   // of faces seen from behind

/// What `peel` is while no layer of translucent surfaces is looked for.
export const noPeel = -1;

const vertexShader = `
in float wall_depth;   // in steps, see wall_depth.glsl
in vec2 data;          // see data_colour.glsl
out float depth_here;
out vec2 data_here;
centroid out vec3 place;   // in the model's millimetres
out vec3 eye_place;
out vec3 eye_normal;
void main() {
  depth_here = wall_depth;
  data_here = data;
  place = position;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  eye_place = eye.xyz;
  eye_normal = normalMatrix * normal;
  gl_Position = projectionMatrix * eye;
}`;

const fragmentShader = `
${lighting}
${tone}
${grain}
${wallDepth}
${dataColour}
centroid in vec3 place;
in float depth_here;
in vec2 data_here;
uniform bool show_depth;
in vec3 eye_place;
in vec3 eye_normal;
uniform vec3 colour;
uniform vec3 back_colour;
uniform float opacity;
uniform float least_back_opacity;
uniform float normal_sign;     // -1: shown inside out
uniform bool turned;           // the other winding is the front
uniform float grain_size;      // of a cut material; 0: none
uniform vec4 section;          // cut away where dot(section.xyz, place) > section.w
uniform mat3 light_frame;      // from the eye to where the lights stand
uniform bool encode;           // for a target that shows what it is given
uniform int peel;              // how many layers of translucent surfaces lie in front of the one that is looked for; negative: none is
uniform sampler2D layer_before, opaque_depth;
layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_ambient;

const float same_depth = 1e-6;   // what rounding may make of one depth

void main() {
  if (dot(section.xyz, place) > section.w) discard;
  if (peel >= 0) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (gl_FragCoord.z > texelFetch(opaque_depth, pixel, 0).r - same_depth) discard;
    if (peel > 0 && gl_FragCoord.z < texelFetch(layer_before, pixel, 0).r + same_depth) discard;
  }
  vec3 to_eye = normalize(-eye_place);
  bool front = gl_FrontFacing != turned;
  vec3 normal = normal_sign * normalize(eye_normal);
  if (!front) normal = -normal;
  float slant = 1.0 - abs(dot(normal, to_eye));   // edge-on a wall is looked through lengthwise
  float alpha = opacity + (1.0 - opacity) * 0.75 * slant * slant * slant;
  if (!front) alpha = max(alpha, least_back_opacity);
  vec3 base = front ? colour : back_colour;
  float pixel = fwidth(depth_here);
  if (show_data != 0 && front) base = colour_of_data(data_here);
  if (show_depth) base = with_depth(base, depth_here, pixel);
  if (grain_size > 0.0) base *= grain(place / grain_size);
  Reflected light = reflected(light_frame * eye_place, light_frame * normal, light_frame * to_eye, base, 0.38);
  if (encode) {
    vec3 shown = light.diffuse + light.ambient + light.gloss / max(alpha, 0.05);
    out_light = vec4(alpha * encoded(clamp(shoulder(shown), 0.0, 1.0)), alpha);
    out_ambient = vec4(0.0);
    return;
  }
  out_light = vec4(alpha * light.diffuse + light.gloss, alpha);
  out_ambient = vec4(alpha * light.ambient, alpha);
}`;

/// Shared by all surfaces; the values are changed in place.
export function sharedUniforms() {
  return {
    section: {value: new Vector4(0, 0, 0, 1)},
    light_frame: {value: new Matrix3()},
    lamp: {value: new Vector4(0, 0, 0, 0)},   // its place and reach in eye space; reach 0: none
    encode: {value: false},
    peel: {value: noPeel},
    layer_before: {value: null},
    opaque_depth: {value: null},
    ...dataUniforms(),
  };
}

const linear = hex => new Color().setStyle(hex, SRGBColorSpace);

export function surfaceMaterial(shared, hex) {
  const colour = linear(hex);
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: {
      ...shared, colour: {value: colour}, back_colour: {value: colour.clone()}, opacity: {value: 1}, least_back_opacity: {value: 0}, normal_sign: {value: 1},
      turned: {value: false}, grain_size: {value: 0}, show_depth: {value: false}, show_data: {value: 0},
    },
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    premultipliedAlpha: true,
    depthFunc: LessEqualDepth,
  });
}

export function setColour(material, hex) { material.uniforms.colour.value.setStyle(hex, SRGBColorSpace); }

/// `faces`: 'cull', 'show' or 'tint'; `body`: inside out.
export function setFaces(material, faces, body) {
  const u = material.uniforms;
  material.side = faces !== 'cull' ? DoubleSide : body ? BackSide : FrontSide;
  u.normal_sign.value = body ? -1 : 1;
  u.turned.value = body && faces !== 'cull';
  u.back_colour.value.copy(faces === 'tint' ? linear('#' + alarm.toString(16)) : u.colour.value);
  u.least_back_opacity.value = faces === 'tint' ? alarmOpacity : 0;
}
