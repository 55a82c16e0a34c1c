// Three lights that travel with the eye, and the sky above them; or a lamp in the eye's hand. Everything is linear and in eye space.
struct Light {
  vec3 towards;    // unit length
  vec3 strength;
};

const Light key = Light(vec3(-0.477, 0.620, 0.623), vec3(0.80, 0.765, 0.71));
const Light fill = Light(vec3(0.811, 0.090, 0.578), vec3(0.19, 0.205, 0.225));
const Light rim = Light(vec3(0.331, 0.563, -0.757), vec3(0.30, 0.31, 0.34));
const vec3 sky = vec3(0.25, 0.27, 0.30);
const vec3 ground = vec3(0.105, 0.09, 0.08);

uniform vec4 lamp;   // place and reach; reach 0: the studio's lights

/// Light that a surface throws back: what ambient occlusion darkens is kept apart from what it does not.
struct Reflected {
  vec3 diffuse;
  vec3 ambient;
  vec3 gloss;
};

/// Reflection of a rough dielectric (Walter, Marschner, Li, Torrance, EGSR 2007), its Fresnel term after Schlick.
/// The vector half way between eye and light is not needed itself: the dot products with it follow from the others.
float gloss_of(vec3 normal, vec3 to_eye, vec3 to_light, float roughness) {
  float n_e = dot(normal, to_eye), n_t = dot(normal, to_light), squared = max(2.0 + 2.0 * dot(to_eye, to_light), 1e-6);
  float n_l = max(n_t, 0.0), n_v = max(n_e, 1e-3), n_sum = max(n_e + n_t, 0.0), n_h2 = n_sum * n_sum / squared;
  float a2 = roughness * roughness * roughness * roughness;
  float spread = n_h2 * (a2 - 1.0) + 1.0;
  float k = 0.5 * roughness * roughness;
  float shadowed = (n_l * (1.0 - k) + k) * (n_v * (1.0 - k) + k);
  float off = max(1.0 - 0.5 * sqrt(squared), 0.0), off2 = off * off;
  float fresnel = 0.04 + 0.96 * off2 * off2 * off;
  return 0.25 * n_l * fresnel * a2 / (shadowed * spread * spread);
}

/// Light wraps a little around the terminator, as it does in tissue that scatters it inside.
float wrapped(vec3 normal, vec3 towards) {
  const float wrap = 0.2;
  return max((dot(normal, towards) + wrap) / (1.0 + wrap), 0.0);
}

/// Bright near the lamp and dark far from it, so that depth is seen; a little comes from everywhere, as walls throw it at each other.
Reflected reflected_lamp(vec3 place, vec3 normal, vec3 to_eye, vec3 colour, float roughness) {
  const vec3 warm = vec3(1.0, 0.955, 0.88), cool = vec3(0.80, 0.90, 1.0);
  vec3 way = lamp.xyz - place;
  float far = length(way);
  vec3 towards = way / max(far, 1e-9);
  float part = far / lamp.w, left = 1.0 / (1.0 + part * part);
  Reflected light;
  light.diffuse = colour * warm * (1.3 * left * wrapped(normal, towards));
  light.ambient = colour * (cool * 0.035 + warm * (0.22 * left));
  light.gloss = warm * (0.55 * left * gloss_of(normal, to_eye, towards, roughness));
  return light;
}

Reflected reflected(vec3 place, vec3 normal, vec3 to_eye, vec3 colour, float roughness) {
  if (lamp.w > 0.0) return reflected_lamp(place, normal, to_eye, colour, roughness);
  Reflected light;
  light.diffuse = colour * (key.strength * wrapped(normal, key.towards) + fill.strength * wrapped(normal, fill.towards) +
                            rim.strength * max(dot(normal, rim.towards), 0.0));
  light.ambient = colour * mix(ground, sky, 0.5 + 0.5 * normal.y);
  light.gloss = key.strength * gloss_of(normal, to_eye, key.towards, roughness) +
                rim.strength * gloss_of(normal, to_eye, rim.towards, roughness);
  return light;
}
